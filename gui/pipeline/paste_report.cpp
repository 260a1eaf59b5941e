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

struct PasteReport {
    Q_DECLARE_TR_FUNCTIONS(unprojector::gui::PasteReport)
};

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

/// A sentence about a camera with the names of fields instead of the command's options.
QString withFieldNames(QString sentence)
{
    const std::array<std::pair<const char *, QString>, 12> names{{
        {"--pixel-centers half", PasteReport::tr("“Pixel centres”")},
        {"--pixel-centers integer", PasteReport::tr("“Pixel centres”")},
        {"--pixel-centers", PasteReport::tr("“Pixel centres”")},
        {"--image NAME", PasteReport::tr("“Image”")},
        {"--image", PasteReport::tr("“Image”")},
        {"--size", PasteReport::tr("“Image size”")},
        {"--near", PasteReport::tr("“Near”")},
        {"--far", PasteReport::tr("“Far”")},
        {"--axes", PasteReport::tr("“Axes”")},
        {"--pose", PasteReport::tr("“Pose”")},
        {"--objects", PasteReport::tr("“File > Add to Scene”")},
        {"--undistorted", PasteReport::tr("“My pixels are of the undistorted image”")},
    }};
    for (const auto &[option, name] : names)
        sentence.replace(QLatin1String(option), name);
    const auto replaceWord = [&sentence](const char *word, const QString &shown) {
        const QRegularExpression whole(QStringLiteral("(?<![\\w.-])%1(?![\\w-]|[.]\\w)").arg(QLatin1String(word)));
        sentence.replace(whole, PasteReport::tr("“%1”", "the item of a field").arg(shown));
    };
    for (const PoseDirection direction : {PoseDirection::WorldToCamera, PoseDirection::CameraToWorld})
        replaceWord(keyOf(direction), directionName(direction));
    for (const EyeAxes axes : kEyeAxes)
        replaceWord(keyOf(axes), axesName(axes));
    return sentence;
}

QString faultText(const base::Error &error)
{
    QString place = QString::fromStdString(error.file);
    if (error.line > 0)
        place = place.isEmpty() ? PasteReport::tr("line %1").arg(error.line)
                                : PasteReport::tr("%1, line %2").arg(place).arg(error.line);
    const std::string said = base::Error{error.text, error.subject}.message();
    return place.isEmpty()
               ? withFieldNames(sentence(said))
               : PasteReport::tr("%1: %2", "a place in a text, what is wrong").arg(place, withFieldNames(ended(said)));
}

QString formName(MatrixForm form)
{
    switch (form) {
    case MatrixForm::Flat: return PasteReport::tr("sixteen numbers in a row");
    case MatrixForm::Indexed: return PasteReport::tr("numbers with an index, m[0] to m[15]");
    case MatrixForm::GlmColumns: return PasteReport::tr("GLM's or GLSL's columns");
    case MatrixForm::IndexPairs: return PasteReport::tr("numbers with row and column, m(0,1)");
    case MatrixForm::RowLines: return PasteReport::tr("four lines");
    case MatrixForm::Call:
    case MatrixForm::NestedRows: break;
    }
    return PasteReport::tr("four brackets");
}

QString partName(PastedPart part)
{
    switch (part) {
    case PastedPart::ModelView:
    case PastedPart::View: return roleName(MatrixRole::View);
    case PastedPart::Projection: return roleName(MatrixRole::Projection);
    case PastedPart::Product: return roleName(MatrixRole::Product);
    default: return PasteReport::tr("Model");
    }
}

void say(Section &section, const QString &text)
{
    if (!text.isEmpty())
        section.blocks.push_back(Paragraph{text.toStdString()});
}

Piece link(const QString &name, const std::string &target)
{
    return {name.toStdString(), Piece::Look::Plain, target};
}

Code matrixCode(const glm::dmat4 &matrix)
{
    std::array<std::vector<std::string>, 4> columns;
    for (int column = 0; column < 4; ++column) {
        for (int row = 0; row < 4; ++row)
            columns[std::size_t(column)].push_back(writtenText(matrix[column][row], 6).toStdString());
        alignAtDecimalPoint(columns[std::size_t(column)]);
    }
    Code code;
    for (std::size_t row = 0; row < 4; ++row)
        code.lines.push_back(columns[0][row] + "  " + columns[1][row] + "  " + columns[2][row] + "  "
                             + columns[3][row]);
    return code;
}

/// What told a matrix its role, and how its numbers are written.
QString originText(const ReadMatrix &one, const PastedCamera &camera)
{
    if (one.given.form == MatrixForm::Call)
        return ended(one.given.call);
    const QString order =
        one.order == NumberOrder::ByColumns ? PasteReport::tr("by columns") : PasteReport::tr("by rows");
    const QString name = QString::fromStdString(one.given.name);
    QStringList said{
        name.isEmpty()
            ? PasteReport::tr("Line %1: %2, read %3.").arg(one.given.line).arg(formName(one.given.form), order)
            : PasteReport::tr("“%1”, line %2: %3, read %4.")
                  .arg(name)
                  .arg(one.given.line)
                  .arg(formName(one.given.form), order)};
    if (camera.isRoleByForm)
        said << PasteReport::tr("No name tells what it is: its form does.");
    if (camera.isRoleOpen)
        said << PasteReport::tr("It has the form of another matrix, too: choose under “Matrix”.");
    if (one.given.isInverse)
        said << sentence(inverseText(one.given));
    if (one.leavesInverse)
        said << PasteReport::tr("The text also has the inverse of this matrix. It is ignored.");
    return joinSentences(said);
}

void addMatrix(const PastedCamera &camera, std::size_t index, Report &report)
{
    const ReadMatrix &one = camera.matrices[index];
    Section section{roleName(one.role).toStdString()};
    say(section, originText(one, camera));
    section.blocks.push_back(matrixCode(one.matrix));
    const std::string at = ':' + std::to_string(index);
    bool offersInverse = false;
    for (std::size_t i = 0; i < one.findings.size(); ++i) {
        const MatrixFinding &finding = one.findings[i];
        const std::string said = findingSentence(finding, one.role).toStdString();
        const QString name = repairName(finding, one.order);
        offersInverse = offersInverse || finding.repair == MatrixRepair::Invert;
        if (name.isEmpty())
            section.blocks.push_back(Paragraph{said});
        else
            section.blocks.push_back(Paragraph{{{said + ' '}, link(name, kCorrect + at + ':' + std::to_string(i))}});
    }
    if (camera.isRoleByForm && one.role == MatrixRole::View && !offersInverse)
        section.blocks.push_back(
            Paragraph{{{PasteReport::tr("It is read from the world to the eye. If it leads from the eye to the world:")
                            .toStdString()
                        + ' '},
                       link(repairName({MatrixFault::Inverse, MatrixRepair::Invert}, one.order), kInvert + at)}});
    if (camera.apart)
        say(section, sentence(decompositionText(*camera.apart)));
    report.push_back(std::move(section));
}

void addMatrices(const ShownPaste &shown, Report &report)
{
    const PastedCamera &camera = shown.camera;
    for (std::size_t i = 0; i < camera.matrices.size(); ++i)
        addMatrix(camera, i, report);
    Section others{""};
    QStringList unused;
    for (const PastedPart part : camera.unused)
        unused << partName(part);
    for (const std::string &name : camera.aside)
        unused << QString::fromStdString(name);
    if (!unused.isEmpty())
        say(others, PasteReport::tr("Not used: %1.").arg(unused.join(QStringLiteral(", "))));
    if (const auto &v = camera.viewport)
        say(others, (camera.isViewportSet
                         ? PasteReport::tr("The viewport is set by glViewport: %1 × %2 at (%3, %4).")
                         : PasteReport::tr("The viewport, %1 × %2 at (%3, %4), is not used: the view keeps its own."))
                        .arg(number(v->width), number(v->height), number(v->x), number(v->y)));
    if (shown.isBlenders && !camera.matrices.empty())
        say(others,
            PasteReport::tr("Blender prints this. If it is the camera's pose, write “matrix_world =” before it, "
                            "and add the lens in a line below: “lens = 50”."));
    if (shown.isCorrected)
        others.blocks.push_back(Paragraph{{link(PasteReport::tr("Undo the corrections"), kAsPasted)}});
    if (!others.blocks.empty())
        report.push_back(std::move(others));
}

/// The names of the values that gave a part: "K (line 1), t (line 3)".
QString readFrom(const ForeignCamera &camera, ReadValue::Of part)
{
    QStringList names;
    for (const ReadValue &value : camera.read) {
        if (value.of == part)
            names << PasteReport::tr("%1 (line %2)", "a name in the text")
                         .arg(QString::fromStdString(value.name))
                         .arg(value.line);
    }
    return names.isEmpty() ? QString() : PasteReport::tr(", from %1").arg(names.join(QStringLiteral(", ")));
}

void addForeign(const ShownPaste &shown, Report &report)
{
    const ForeignCamera &camera = *shown.camera.foreign;
    Section section{PasteReport::tr("Camera of %1").arg(QString::fromStdString(camera.program)).toStdString()};
    Rows rows;
    const auto add = [&rows](const QString &name, const QString &value) {
        rows.add(name.toStdString(), value.toStdString());
    };
    using enum ReadValue::Of;
    if (camera.images.size() > 1)
        add(PasteReport::tr("Image"), PasteReport::tr("%1 of %2", "an image's number, how many there are")
                                          .arg(camera.image + 1)
                                          .arg(camera.images.size()));
    if (camera.intrinsics) {
        const Intrinsics &k = *camera.intrinsics;
        add(PasteReport::tr("Lens"), PasteReport::tr("fx %1, fy %2, cx %3, cy %4 pixels%5")
                                         .arg(writtenText(k.fx, 6), writtenText(k.fy, 6), writtenText(k.cx, 6),
                                              writtenText(k.cy, 6), readFrom(camera, Lens)));
    } else if (camera.projection) {
        add(PasteReport::tr("Lens"), PasteReport::tr("a projection matrix"));
    }
    if (hasCentres(camera))
        add(PasteReport::tr("Pixel centres"),
            centresName(shown.camera.scene && shown.camera.scene->intrinsics ? shown.camera.scene->intrinsics->centres
                                                                             : camera.intrinsics->centres));
    if (const auto &scene = shown.camera.scene) {
        add(PasteReport::tr("Image size"),
            QStringLiteral("%1 × %2%3").arg(scene->size.width).arg(scene->size.height).arg(readFrom(camera, Image)));
        if (camera.pose) {
            add(PasteReport::tr("Pose"), directionName(scene->direction) + readFrom(camera, Pose));
            add(PasteReport::tr("Axes"), axesName(scene->axes));
        }
    }
    if (camera.distortion && !camera.distortion->isNone()) {
        const cameras::Distortion &d = *camera.distortion;
        add(PasteReport::tr("Distortion"),
            QStringLiteral("k1 %1, k2 %2, p1 %3, p2 %4, k3 %5%6")
                .arg(shortestText(d.k1), shortestText(d.k2), shortestText(d.p1), shortestText(d.p2), shortestText(d.k3),
                     readFrom(camera, ReadValue::Of::Distortion)));
    }
    if (!rows.rows.empty())
        section.blocks.push_back(std::move(rows));
    for (const std::string &sentence : shown.camera.scene ? shown.camera.scene->assumed : camera.assumed)
        say(section, withFieldNames(QString::fromStdString(sentence)));
    report.push_back(std::move(section));
}

/// What the view shows of the objects.
QString seenText(const Setup &setup, const Box &objects)
{
    const auto lens = clipFromEye(setup), view = eyeFromWorld(setup);
    if (!lens || !view)
        return {};
    const double seen = seenPart(*lens, *view, objects);
    if (seen == 0.0)
        return PasteReport::tr("Nothing will be seen: no object is in the image.");
    const DepthExtent depths = depthExtent(*view, objects);
    const ProjectionWindow w = projectionWindow(setup.projection());
    if (depths.farthest <= std::min(w.nearDistance, w.farDistance)
        || depths.nearest >= std::max(w.nearDistance, w.farDistance))
        return PasteReport::tr(
                   "Nothing will be seen: the objects are %1 to %2 in front of the eye, not between near and "
                   "far.")
            .arg(writtenText(depths.nearest, 4), writtenText(depths.farthest, 4));
    return seen < 1.0 ? PasteReport::tr("A part of the objects is in the image.")
                      : PasteReport::tr("The objects are in the image.");
}

void addMeaning(const ShownPaste &shown, Report &report)
{
    const Setup &setup = *shown.setup;
    const LookAt &camera = setup.camera();
    const WorldVector forward = camera.center - camera.eye;
    const ProjectionWindow w = projectionWindow(setup.projection());
    const double width = std::abs(w.right - w.left), height = std::abs(w.top - w.bottom);
    Section section{PasteReport::tr("The view").toStdString()};
    Rows rows;
    const auto add = [&rows](const QString &name, const QString &value) {
        rows.add(name.toStdString(), value.toStdString());
    };
    add(PasteReport::tr("Eye"), tripleText(camera.eye.coordinates()));
    add(PasteReport::tr("Looks along"), tripleText((forward * (1.0 / length(forward))).coordinates()));
    if (isPerspective(setup.projection())) {
        const auto angle = [&w](double from, double to) {
            return number(
                degreesFromRadians(std::abs(std::atan2(to, w.nearDistance) - std::atan2(from, w.nearDistance))));
        };
        add(PasteReport::tr("Field of view"),
            PasteReport::tr("%1° high, %2° wide").arg(angle(w.bottom, w.top), angle(w.left, w.right)));
    } else {
        add(PasteReport::tr("Orthographic"), PasteReport::tr("%1 wide, %2 high").arg(number(width), number(height)));
    }
    add(PasteReport::tr("Near and far"), QStringLiteral("%1, %2").arg(number(w.nearDistance), number(w.farDistance)));
    const auto *matrix = shown.camera.projection ? std::get_if<MatrixProjection>(&*shown.camera.projection) : nullptr;
    const auto form = matrix ? recognised(*matrix) : Error{};
    if (form)
        add(PasteReport::tr("NDC depths"),
            form.value().ndcDepth == NdcDepth::ZeroToOne ? PasteReport::tr("0 to 1") : PasteReport::tr("−1 to 1"));
    section.blocks.push_back(std::move(rows));
    if (!shown.camera.projection)
        say(section, PasteReport::tr("The text has no projection: the scene's projection is kept."));
    if (!shown.camera.eyeFromWorld)
        say(section, PasteReport::tr("The text has no view: the scene's view is kept."));
    if (shown.objects)
        say(section, seenText(setup, *shown.objects));
    if (shown.size)
        say(section, PasteReport::tr("The view gets the image's size, %1 × %2.")
                         .arg(shown.size->widthPixels)
                         .arg(shown.size->heightPixels));
    else if (shown.camera.scene
             && std::max(shown.camera.scene->size.width, shown.camera.scene->size.height) > kMostViewPixels)
        say(section,
            PasteReport::tr("The image is larger than %1 pixels: the view keeps its own size.").arg(kMostViewPixels));
    report.push_back(std::move(section));
}

} // namespace

Report pasteReport(const ShownPaste &shown)
{
    const PastedCamera &camera = shown.camera;
    Report report;
    QString fault = shown.fault;
    if (camera.fault && fault.isEmpty())
        fault = faultText(*camera.fault);
    if (!fault.isEmpty()) {
        Section section{PasteReport::tr("No camera yet").toStdString()};
        say(section, fault);
        if (camera.foreign && camera.foreign->isDirectionOpen && !camera.scene) {
            for (const PoseDirection direction : {PoseDirection::CameraToWorld, PoseDirection::WorldToCamera})
                section.blocks.push_back(
                    Paragraph{{link(directionName(direction), kDirection + (':' + std::to_string(int(direction))))}});
        }
        report.push_back(std::move(section));
    } else if (shown.setup) {
        addMeaning(shown, report);
    }
    if (camera.foreign)
        addForeign(shown, report);
    addMatrices(shown, report);
    return report;
}

} // namespace unprojector::gui
