#include "gui/pipeline/paste_report.h"

#include "core/cameras/seen_objects.h"
#include "core/geometry/numbers.h"
#include "core/pipeline/matrix_format.h"
#include "gui/document/view_limits.h"
#include "gui/pipeline/matrix_text.h"
#include "gui/pipeline/paste_choices_form.h"
#include "gui/text/number_text.h"
#include "gui/text/sentences.h"

#include <QCoreApplication>
#include <QRegularExpression>
#include <QStringList>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace unprojector::gui {
using namespace geometry;
using namespace cameras;
using namespace pipeline;
using namespace report;
namespace {

/// The remaining digits of near in a single-precision matrix.
constexpr int kDigits = 5;

QString number(double value)
{
    return writtenText(value, kDigits);
}

QString tripleText(const glm::dvec3 &p)
{
    return QStringLiteral("(%1, %2, %3)").arg(number(p.x), number(p.y), number(p.z));
}

Code matrixCode(const glm::dmat4 &matrix)
{
    Code code{std::vector<std::string>(4)};
    for (int column = 0; column < 4; ++column) {
        std::vector<std::string> entries(4);
        for (std::size_t row = 0; row < 4; ++row)
            entries[row] = writtenText(matrix[column][int(row)], 6).toStdString();
        alignAtDecimalPoint(entries);
        for (std::size_t row = 0; row < 4; ++row)
            code.lines[row] += (column > 0 ? "  " : "") + entries[row];
    }
    return code;
}

class PasteReport {
    Q_DECLARE_TR_FUNCTIONS(unprojector::gui::PasteReport)
public:
    explicit PasteReport(const ShownPaste &shown) : m_shown(shown), m_camera(shown.camera) {}

    Report report()
    {
        const auto &fault = m_camera.fault;
        if (!m_shown.refusal.isEmpty()) {
            begin(tr("Not read"));
            say(m_shown.refusal);
        }
        if (!m_shown.fault.isEmpty() || fault) {
            begin(tr("No camera yet"));
            say(m_shown.fault.isEmpty() ? faultText(*fault) : withFieldNames(m_shown.fault));
            if (fault && !m_camera.foreign && m_camera.matrices.empty())
                say(tr(
                    "A camera is that of a program (K, R and t, a camera's file), matrices of sixteen numbers each, or "
                    "calls such as gluLookAt."));
            if (m_camera.foreign && m_camera.foreign->isDirectionOpen && !m_camera.scene) {
                for (const PoseDirection direction : {PoseDirection::CameraToWorld, PoseDirection::WorldToCamera})
                    say({}, directionName(direction), kDirection + (':' + std::to_string(int(direction))));
            }
        } else if (m_shown.setup) {
            if (m_camera.foreign) // what was assumed stands first
                sayForeign(*m_camera.foreign);
            sayMeaning(*m_shown.setup);
        } else {
            begin({});
            say(tr("The view shows the pasted camera at once. Cancel brings the present one back."));
        }
        if (m_camera.foreign && (!m_shown.setup || m_camera.fault || !m_shown.fault.isEmpty()))
            sayForeign(*m_camera.foreign);
        for (std::size_t i = 0; i < m_camera.matrices.size(); ++i)
            sayMatrix(i);
        sayOthers();
        return std::move(m_report);
    }

private:
    void begin(const QString &title) { m_report.push_back({title.toStdString()}); }
    void say(const QString &text) { m_report.back().blocks.push_back(Paragraph{text.toStdString()}); }
    void say(const QString &text, const QString &link, const std::string &target)
    {
        m_report.back().blocks.push_back(
            Paragraph{{{text.toStdString() + ' '}, {link.toStdString(), Piece::Look::Plain, target}}});
    }
    void addRow(const QString &name, const QString &value)
    {
        std::vector<Block> &blocks = m_report.back().blocks;
        if (blocks.empty())
            blocks.push_back(Rows());
        std::get<Rows>(blocks.back()).add(name.toStdString(), value.toStdString());
    }

    /// A sentence about a camera with the names of fields instead of the command's options.
    static QString withFieldNames(QString sentence)
    {
        const std::array<std::pair<const char *, QString>, 11> names{{
            {"--pixel-centers half", tr("“Pixel centres”")},
            {"--pixel-centers integer", tr("“Pixel centres”")},
            {"--pixel-centers", tr("“Pixel centres”")},
            {"--image NAME", tr("“Image”")},
            {"--image", tr("“Image”")},
            {"--size", tr("“Image size”")},
            {"--near", tr("“Near”")},
            {"--far", tr("“Far”")},
            {"--axes", tr("“Axes”")},
            {"--pose", tr("“Pose”")},
            {"--undistorted", tr("“My pixels are of the undistorted image”")},
        }};
        for (const auto &[option, name] : names)
            sentence.replace(QLatin1String(option), name);
        const auto replaceWord = [&sentence](const char *word, const QString &shown) {
            const QRegularExpression whole(QStringLiteral("(?<![\\w.-])%1(?![\\w-]|[.]\\w)").arg(QLatin1String(word)));
            sentence.replace(whole, tr("“%1”", "the item of a field").arg(shown));
        };
        for (const PoseDirection direction : {PoseDirection::WorldToCamera, PoseDirection::CameraToWorld})
            replaceWord(keyOf(direction), directionName(direction));
        for (const EyeAxes axes : kEyeAxes)
            replaceWord(keyOf(axes), axesName(axes));
        return sentence;
    }

    static QString faultText(const base::Error &error)
    {
        QString place = QString::fromStdString(error.file);
        if (error.line > 0)
            place = place.isEmpty() ? tr("line %1").arg(error.line) : tr("%1, line %2").arg(place).arg(error.line);
        const std::string said = base::Error{error.text, error.subject}.message();
        return place.isEmpty()
                   ? withFieldNames(sentence(said))
                   : tr("%1: %2", "a place in a text, what is wrong").arg(place, withFieldNames(ended(said)));
    }

    void sayMeaning(const Setup &setup)
    {
        const LookAt &eye = setup.camera();
        const WorldVector forward = eye.center - eye.eye;
        const ProjectionWindow w = projectionWindow(setup.projection());
        begin(tr("The view"));
        addRow(tr("Eye"), tripleText(eye.eye.coordinates()));
        addRow(tr("Looks along"), tripleText((forward * (1.0 / length(forward))).coordinates()));
        if (isPerspective(setup.projection())) {
            const auto angle = [n = w.nearDistance](double from, double to) {
                return number(degreesFromRadians(std::abs(std::atan2(to, n) - std::atan2(from, n))));
            };
            addRow(tr("Field of view"), tr("%1° high, %2° wide").arg(angle(w.bottom, w.top), angle(w.left, w.right)));
        } else {
            addRow(tr("Orthographic"),
                   tr("%1 wide, %2 high").arg(number(std::abs(w.right - w.left)), number(std::abs(w.top - w.bottom))));
        }
        addRow(tr("Near and far"), QStringLiteral("%1, %2").arg(number(w.nearDistance), number(w.farDistance)));
        const auto *matrix = m_camera.projection ? std::get_if<MatrixProjection>(&*m_camera.projection) : nullptr;
        if (const auto form = matrix ? recognised(*matrix) : Error{})
            addRow(tr("NDC depths"), form->ndcDepth == NdcDepth::ZeroToOne ? tr("0 to 1") : tr("−1 to 1"));
        if (!m_camera.projection)
            say(tr("The text has no projection: the scene's projection is kept."));
        if (!m_camera.eyeFromWorld)
            say(tr("The text has no view: the scene's view is kept."));
        if (m_shown.objects)
            saySeen(setup, *m_shown.objects);
        if (m_shown.size)
            say(tr("The view gets the image's size, %1 × %2.")
                    .arg(m_shown.size->widthPixels)
                    .arg(m_shown.size->heightPixels));
        else if (m_camera.scene && std::max(m_camera.scene->size.width, m_camera.scene->size.height) > kMostViewPixels)
            say(tr("The image is larger than %1 pixels: the view keeps its own size.").arg(kMostViewPixels));
    }

    void saySeen(const Setup &setup, const Box &objects)
    {
        const auto lens = clipFromEye(setup), view = eyeFromWorld(setup);
        if (!lens || !view)
            return;
        const double seen = seenPart(*lens, *view, objects);
        const DepthExtent depths = depthExtent(*view, objects);
        const ProjectionWindow w = projectionWindow(setup.projection());
        if (seen == 0.0 && depths.nearest == 0.0 && depths.farthest > 0.0) // the eye may be among them
            return;
        if (seen == 0.0)
            say(tr("Nothing will be seen: no object is in the image."));
        else if (depths.farthest <= std::min(w.nearDistance, w.farDistance)
                 || depths.nearest >= std::max(w.nearDistance, w.farDistance))
            say(tr("Nothing will be seen: the objects are %1 to %2 in front of the eye, not between near and far.")
                    .arg(writtenText(depths.nearest, 4), writtenText(depths.farthest, 4)));
        else
            say(seen < 1.0 ? tr("A part of the objects is in the image.") : tr("The objects are in the image."));
    }

    /// The names of the values that gave a part: ", from K (line 1), t (line 3)".
    QString readFrom(ReadValue::Of part) const
    {
        QStringList names;
        for (const ReadValue &value : m_camera.foreign->read) {
            if (value.of == part)
                names
                    << tr("%1 (line %2)", "a name in the text").arg(QString::fromStdString(value.name)).arg(value.line);
        }
        return names.isEmpty() ? QString() : tr(", from %1").arg(names.join(QStringLiteral(", ")));
    }

    void sayForeign(const ForeignCamera &camera)
    {
        using Of = ReadValue::Of;
        const auto &scene = m_camera.scene;
        begin(tr("Camera of %1").arg(QString::fromStdString(camera.program)));
        for (const std::string &sentence : scene ? scene->assumed : camera.assumed)
            say(withFieldNames(QString::fromStdString(sentence)));
        begin({});
        if (camera.images.size() > 1)
            addRow(tr("Image"), tr("%1 (%2 of %3)", "an image, its number, how many there are")
                                    .arg(QString::fromStdString(camera.images[camera.image]))
                                    .arg(camera.image + 1)
                                    .arg(camera.images.size()));
        if (const auto &k = camera.intrinsics)
            addRow(tr("Lens"), tr("fx %1, fy %2, cx %3, cy %4 pixels%5")
                                   .arg(writtenText(k->fx, 6), writtenText(k->fy, 6), writtenText(k->cx, 6),
                                        writtenText(k->cy, 6), readFrom(Of::Lens)));
        else if (camera.projection)
            addRow(tr("Lens"), tr("a projection matrix"));
        if (hasCentres(camera))
            addRow(tr("Pixel centres"), centresName((scene ? scene->intrinsics : camera.intrinsics)->centres));
        if (scene)
            addRow(tr("Image size"),
                   QStringLiteral("%1 × %2%3").arg(scene->size.width).arg(scene->size.height).arg(readFrom(Of::Image)));
        if (scene && camera.pose) {
            addRow(tr("Pose"), directionName(scene->direction) + readFrom(Of::Pose));
            addRow(tr("Axes"), axesName(scene->axes));
        }
        if (const auto &d = camera.distortion; d && !d->isNone())
            addRow(tr("Distortion"), QStringLiteral("k1 %1, k2 %2, p1 %3, p2 %4, k3 %5%6")
                                         .arg(shortestText(d->k1), shortestText(d->k2), shortestText(d->p1),
                                              shortestText(d->p2), shortestText(d->k3), readFrom(Of::Distortion)));
    }

    /// What told a matrix its role, and how its numbers are written.
    QString originText(const PastedMatrix &given, NumberOrder order) const
    {
        if (given.form == MatrixForm::Call)
            return ended(given.call);
        const QString how = order == NumberOrder::ByColumns ? tr("by columns") : tr("by rows");
        const QString name = QString::fromStdString(given.name);
        QStringList said{name.isEmpty() ? tr("Line %1, read %2.").arg(given.line).arg(how)
                                        : tr("“%1”, line %2, read %3.").arg(name).arg(given.line).arg(how)};
        if (m_camera.isRoleByForm)
            said << tr("No name tells what it is: its form does.");
        if (m_camera.isRoleOpen)
            said << tr("It has the form of another matrix, too: choose under “Matrix”.");
        if (given.isInverse)
            said << sentence(inverseText(given));
        return joinSentences(said);
    }

    void sayMatrix(std::size_t index)
    {
        const ReadMatrix &one = m_camera.matrices[index];
        begin(roleName(one.role));
        say(originText(one.given, one.order));
        if (m_camera.openDirection) {
            const bool isInverted = m_camera.openDirection == PoseDirection::CameraToWorld;
            const PoseDirection other = isInverted ? PoseDirection::WorldToCamera : PoseDirection::CameraToWorld;
            say(isInverted ? tr("Nothing tells its direction. It is read from camera to world, so this is its inverse. "
                                "The other reading:")
                           : tr("Nothing tells its direction. It is read from world to camera. The other reading:"),
                directionName(other), kDirection + (':' + std::to_string(int(other))));
        }
        m_report.back().blocks.push_back(matrixCode(one.matrix));
        for (std::size_t i = 0; i < one.findings.size(); ++i) {
            const QString said = findingSentence(one.findings[i], one.role);
            if (const QString name = repairName(one.findings[i], one.order); name.isEmpty())
                say(said);
            else
                say(said, name, kCorrect + (':' + std::to_string(index) + ':' + std::to_string(i)));
        }
        if (m_camera.apart)
            say(sentence(decompositionText(*m_camera.apart)));
    }

    void sayOthers()
    {
        begin({});
        for (const std::string &note : m_camera.notes)
            say(sentence(note));
        QStringList unused;
        for (const std::string &name : m_camera.aside)
            unused << QString::fromStdString(name);
        if (!unused.isEmpty())
            say(tr("Not used: %1.").arg(unused.join(QStringLiteral(", "))));
        if (const auto &v = m_camera.viewport)
            say((m_camera.isViewportSet ? tr("The viewport is set by glViewport: %1 × %2 at (%3, %4).")
                                        : tr("The viewport, %1 × %2 at (%3, %4), is not used: the view keeps its own."))
                    .arg(number(v->width), number(std::abs(v->height)), number(v->x), number(v->y)));
        if (m_shown.isBlenders && !m_camera.matrices.empty())
            say(tr(
                "Blender prints this. If it is the camera's pose, write “matrix_world =” before it, and add the lens "
                "in a line below: “lens = 50”."));
        if (m_shown.isCorrected)
            say({}, tr("Undo the corrections"), kAsPasted);
    }

    const ShownPaste &m_shown;
    const PastedCamera &m_camera;
    Report m_report;
};

} // namespace

Report pasteReport(const ShownPaste &shown)
{
    return PasteReport(shown).report();
}

} // namespace unprojector::gui
