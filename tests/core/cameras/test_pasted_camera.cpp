// A pasted text as one camera: matrices in every usual form and role, and the corrections of their
// findings.

#include "tests/core/cameras/pasted_text.h"
#include "tests/support/test.h"

#include "core/geometry/condition_number.h"

#include <glm/gtc/matrix_transform.hpp>

#include <string>
#include <vector>

using namespace unprojector;
using namespace unprojector::geometry;
using namespace unprojector::cameras;
using namespace unprojector::pipeline;

namespace {

glm::dmat4 lens()
{
    return glm::frustum(-1.0, 1.0, -0.75, 0.75, 2.0, 50.0);
}

glm::dmat4 view()
{
    return glm::lookAt(glm::dvec3(3, 2, 5), glm::dvec3(0.0), glm::dvec3(0, 1, 0));
}

/// The lens with NDC depths in [0, 1].
glm::dmat4 zeroToOne(double n = 2.0, double f = 50.0)
{
    glm::dmat4 m = glm::frustum(-1.0, 1.0, -0.75, 0.75, n, f);
    m[2][2] = -f / (f - n);
    m[3][2] = -f * n / (f - n);
    return m;
}

/// The entries one after the other, four of them in a pair of brackets or in a line.
QString fours(const glm::dmat4 &m, bool areRows, const QString &separator, const QString &open, const QString &close,
              const QString &between)
{
    QStringList groups;
    for (int i = 0; i < 4; ++i) {
        QStringList numbers;
        for (int j = 0; j < 4; ++j)
            numbers << QString::number(areRows ? m[j][i] : m[i][j], 'g', 17);
        groups << open + numbers.join(separator) + close;
    }
    return groups.join(between);
}

/// The matrix as the programs print it.
std::string printed(const glm::dmat4 &m, const QString &form = "NumPy")
{
    QString text;
    if (form == "glm::to_string")
        text = "dmat4x4(" + fours(m, false, ", ", "(", ")", ", ") + ")";
    else if (form == "NumPy")
        text = "[" + fours(m, true, "  ", "[", "]", "\n ") + "]";
    else if (form == "Eigen")
        text = fours(m, true, "   ", "", "", "\n");
    else if (form == "QMatrix4x4")
        text = "QMatrix4x4(type:General\n" + fours(m, true, "  ", "  ", "", "\n") + "\n)";
    else if (form == "JSON")
        text = "[" + fours(m, false, ", ", "", "", ", ") + "]";
    else if (form == "C")
        text = "const double m[16] = {\n" + fours(m, false, ", ", "    ", "", ",\n") + "\n};";
    else if (form == "three.js")
        text = R"({"elements":[)" + fours(m, false, ",", "", "", ",") + "]}";
    for (int i = 0; text.isEmpty() || (form == "m[0] to m[15]" && i < 16); ++i)
        text += QStringLiteral("m[%1] = %2\n").arg(i).arg(m[i / 4][i % 4], 0, 'g', 17);
    return text.toStdString();
}

glm::dmat4 lensOf(const PastedCamera &camera)
{
    return std::get<MatrixProjection>(camera.projection.value()).clipFromEye;
}

bool areClose(const glm::dmat4 &a, const glm::dmat4 &b)
{
    return largestEntry(a - b) <= 1e-12;
}

bool isCamera(const PastedCamera &camera)
{
    if (!camera.projection || !camera.eyeFromWorld)
        return false;
    return areClose(lensOf(camera) * *camera.eyeFromWorld, lens() * view());
}

} // namespace

class TestPastedCamera : public QObject {
    Q_OBJECT

private slots:
    void everyPrintedFormIsRead_data()
    {
        addColumn<QString>("form");
        for (const char *form :
             {"glm::to_string", "NumPy", "Eigen", "QMatrix4x4", "JSON", "C", "three.js", "m[0] to m[15]"})
            newRow(form) << form;
    }

    /// Alone, a matrix without a name has the role of its form; so have two, in either order.
    void everyPrintedFormIsRead()
    {
        QFETCH(QString, form);
        const std::string lens_ = printed(lens(), form), view_ = printed(view(), form);
        QCOMPARE(pasted(view_).eyeFromWorld, std::optional(view()));
        QVERIFY(!pasted(view_).projection);
        QCOMPARE(lensOf(pasted(lens_)), lens());
        QVERIFY(!pasted(lens_).eyeFromWorld);
        QVERIFY(isCamera(pasted(lens_ + "\n\n" + view_)) && isCamera(pasted(view_ + "\n\n" + lens_)));
        QVERIFY(isCamera(pasted(printed(lens() * view(), form))));
    }

    void rolesAreRead_data()
    {
        addColumn<QString>("text");
        addColumn<QString>("notes");
        addColumn<bool>("isProduct");
        const std::string view_ = printed(view()), lens_ = printed(lens()), product = printed(lens() * view());
        const auto row = [](const char *name, const std::string &text, const char *notes = "", bool isProduct = false) {
            newRow(name) << QString::fromStdString(text) << notes << isProduct;
        };
        const std::string both = "view = " + view_ + "\nprojection = " + lens_;
        row("names", both);
        row("names the other way round", "projection: " + lens_ + "\nmodelview: " + view_);
        row("an inverse too many", both + "\nviewInverse = " + printed(glm::inverse(view())),
            "view: its inverse is ignored, because the needed matrices are given");
        row("an inverse alone", "projection = " + lens_ + "\ncameraToWorld = " + printed(glm::inverse(view())));
        row("a viewport", view_ + "\n" + lens_ + "\nviewport: QRect(0,0 300x200)");
        row("a product", "mvp = " + product, "", true);
        row("a product and a viewport", product + "\nviewport 0 0 300 200", "", true);
        row("a product beside the view", "mvp = " + product + "\nview = " + view_,
            "view: ignored without a projection: only the product counts", true);
        row("a product beside another view", "mvp = " + product + "\nview = " + printed(glm::inverse(view())),
            "view: ignored without a projection: only the product counts, and it differs from the product's", true);
        row("a product beside both", "mvp = " + product + "\n" + both,
            "product: ignored, because the projection and the view are given");
        row("a wrong product beside both", "mvp = " + view_ + "\n" + both,
            "product: ignored, because the projection and the view are given, and it differs from their product by "
            "0.72 of its largest entry: one of them is of another setup, or contains an object's matrix");
        row("a product by rows beside both", "mvp = " + printed(glm::transpose(lens() * view())) + "\n" + both,
            "product: ignored, because the projection and the view are given");
        row("a model beside both", "model = " + lens_ + "\n" + both,
            "model: ignored: world coordinates do not need it");
        row("a modelview beside both", both + "\nmodelview = " + view_,
            "modelview: ignored, because the view is given");
        row("two views", "view A:\n" + view_ + "\nview B:\n" + view_ + "\nprojection = " + lens_,
            "view: there are several; the first one is used");
        row("a product behind both", view_ + "\n" + lens_ + "\n" + product,
            "product: ignored, because the projection and the modelview are given");
        row("an inverse between both", view_ + "\n" + printed(glm::inverse(view())) + "\n" + lens_,
            "modelview: ignored, because the view is given");
        row("exchanged", lens_ + "\n" + view_,
            "modelview: it has no name and the form of a projection, and is read as the projection");
    }

    void rolesAreRead()
    {
        QFETCH(QString, text);
        QFETCH(QString, notes);
        QFETCH(bool, isProduct);
        const PastedCamera camera = pasted(text.toStdString());
        QVERIFY(isCamera(camera));
        QCOMPARE(camera.apart.has_value(), isProduct);
        QStringList said;
        for (const std::string &note : camera.notes)
            said << QString::fromStdString(note);
        QCOMPARE(said.join("; "), notes);
        QCOMPARE(camera.viewport.has_value(), text.contains("viewport"));
        QVERIFY(!camera.isViewportSet);
    }

    /// A model in the product makes its space the world.
    void aProductWithAModelIsRead()
    {
        const glm::dmat4 model = glm::rotate(glm::translate(glm::dmat4(1.0), {1, 2, 3}), 0.3, {0.0, 0.6, 0.8});
        const PastedCamera camera = pasted(printed(lens() * view() * model));
        QVERIFY(camera.apart && areClose(lensOf(camera), lens()) && areClose(*camera.eyeFromWorld, view() * model));
        const glm::dmat4 box = glm::ortho(-3.0, 3.0, -2.0, 2.0, 1.0, 9.0);
        const PastedCamera ofBox = pasted(printed(box * view()));
        QVERIFY(ofBox.apart && ofBox.apart->isBox);
        QVERIFY(areClose(lensOf(ofBox) * *ofBox.eyeFromWorld, box * view()));
    }

    void theNameAndTheLineAreKept()
    {
        const PastedCamera camera = pasted("a camera\nviewMatrix =\n" + printed(view()) + "\nproj\n" + printed(lens()));
        const ReadMatrix *projection = matrixOf(camera, MatrixRole::Projection),
                         *read = matrixOf(camera, MatrixRole::View);
        QCOMPARE(read->given.name, std::string("viewMatrix"));
        QCOMPARE(read->given.line, std::size_t(3));
        QCOMPARE(projection->given.name, std::string("proj"));
        QCOMPARE(projection->given.line, std::size_t(8));
    }

    void aPoseAloneIsOpenToDirectionAndAxes()
    {
        // OpenCV's pose of the same camera: right, down, ahead.
        const glm::dmat4 turn = glm::scale(glm::dmat4(1.0), {1.0, -1.0, -1.0});
        const std::string pose = printed(glm::inverse(turn * view()));
        QVERIFY(pasted(pose).openDirection == PoseDirection::WorldToCamera);
        PasteChoices choices;
        choices.camera.direction = PoseDirection::CameraToWorld;
        choices.camera.axes = EyeAxes::RightDownAhead;
        QVERIFY(pasted(pose, choices).openDirection == PoseDirection::CameraToWorld);
        QVERIFY(areClose(pasted(pose, choices).eyeFromWorld.value(), view()));
        QVERIFY(!pasted("view = " + pose).openDirection && !pasted(printed(lens())).openDirection);
    }

    void theRoleByFormIsOpenToAChoice()
    {
        const std::string box = printed(glm::ortho(-1.0, 1.0, -1.0, 1.0, -1.0, 1.0));
        QVERIFY(matrixOf(pasted(box), MatrixRole::Projection) && pasted(box).isRoleOpen);
        const std::string shift = printed(glm::translate(glm::dmat4(1.0), {0, 0, -5}));
        QVERIFY(matrixOf(pasted(shift), MatrixRole::View) && pasted(shift).isRoleOpen);
        QVERIFY(pasted(printed(view())).isRoleByForm && !pasted(printed(view())).isRoleOpen);
        QVERIFY(!pasted("view = " + shift).isRoleByForm && !pasted("view = " + shift).isRoleOpen);
        PasteChoices choices;
        choices.role = MatrixRole::Projection;
        QVERIFY(matrixOf(pasted(shift, choices), MatrixRole::Projection));
        // It holds for one matrix.
        QVERIFY(isCamera(pasted(printed(view()) + printed(lens()), choices)));
    }

    void everyFindingHasItsCorrection_data()
    {
        addColumn<MatrixRole>("role");
        addColumn<glm::dmat4>("given");
        addColumn<MatrixFault>("fault");
        addColumn<glm::dmat4>("expected");
        const auto scaling = [](double x, double y, double z) {
            return glm::scale(glm::dmat4(1.0), glm::dvec3(x, y, z));
        };
        using enum MatrixRole;
        newRow("an inverse") << Projection << glm::inverse(lens()) << MatrixFault::Inverse << lens();
        newRow("the camera's matrix") << View << glm::inverse(view()) << MatrixFault::Inverse << view();
        newRow("Vulkan's y") << Projection << scaling(1, -1, 1) * lens() << MatrixFault::YDown << lens();
        newRow("mirrored") << Projection << scaling(-1, 1, 1) * lens() << MatrixFault::Mirrored << lens();
        newRow("a mirrored view") << View << scaling(-1, 1, 1) * view() << MatrixFault::Mirrored << view();
        newRow("a scaled view") << View << view() * scaling(2, 2, 2) << MatrixFault::Scaled << view();
        newRow("negated") << Projection << -lens() << MatrixFault::Negated << lens();
        newRow("along +z") << Projection << lens() * scaling(1, 1, -1) << MatrixFault::LeftHanded << lens();
        newRow("depths in [0, 1]") << Projection << zeroToOne() << MatrixFault::DepthZeroToOne << zeroToOne();
    }

    void everyFindingHasItsCorrection()
    {
        QFETCH(MatrixRole, role);
        QFETCH(glm::dmat4, given);
        QFETCH(MatrixFault, fault);
        QFETCH(glm::dmat4, expected);
        const bool isView = role == MatrixRole::View;
        // Alone, and beside the other one.
        for (const std::string &beside :
             {std::string(), isView ? "projection = " + printed(lens()) : "view = " + printed(view())}) {
            const std::string text = (isView ? "view = " : "projection = ") + printed(given, "JSON") + "\n" + beside;
            const PastedCamera before = pasted(text);
            PasteChoices choices;
            for (const MatrixFinding &finding : matrixOf(before, role)->findings) {
                if (finding.fault == fault)
                    choices.corrections.push_back({role, finding});
            }
            const PastedCamera after = pasted(text, choices);
            const std::vector<MatrixFinding> &left = matrixOf(after, role)->findings;
            QVERIFY(
                std::none_of(left.begin(), left.end(), [&](const MatrixFinding &one) { return one.fault == fault; }));
            if (fault == MatrixFault::LeftHanded && !beside.empty()) // with the view, whose product stays
                QVERIFY(areClose(lensOf(after) * *after.eyeFromWorld, given * view()));
            else
                QVERIFY(areClose(isView ? *after.eyeFromWorld : lensOf(after), expected));
            if (fault == MatrixFault::DepthZeroToOne)
                QCOMPARE(std::get<MatrixProjection>(*after.projection).ndcDepth, std::optional(NdcDepth::ZeroToOne));
        }
    }

    void swappedNamesAreExchanged()
    {
        const std::string text = "projection = " + printed(view()) + "\nview = " + printed(lens());
        const PastedCamera camera = pasted(text);
        PasteChoices choices;
        for (int time = 0; time < 3; ++time) { // the third is as the first
            QCOMPARE(isCamera(pasted(text, choices)), time == 1);
            choices.corrections.push_back({MatrixRole::View, {MatrixFault::Exchanged, MatrixRepair::Exchange}});
        }
        QCOMPARE(int(matrixOf(camera, MatrixRole::View)->findings.at(0).repair), int(MatrixRepair::Exchange));
    }

    void theDepthsCanBeChosen()
    {
        // Near has many digits in either order: only the user can tell the two apart.
        const std::string text = printed(zeroToOne(1.23457, 87.6543));
        QVERIFY(pasted(text).matrices[0].findings.empty());
        PasteChoices choices;
        choices.ndcDepth = NdcDepth::ZeroToOne;
        const auto lens_ = std::get<MatrixProjection>(*pasted(text, choices).projection);
        QCOMPARE(lens_.ndcDepth, choices.ndcDepth);
        QVERIFY(std::abs(std::get<Frustum>(recognised(lens_).value().parameters).nearDistance - 1.23457) < 1e-9);
    }

    void textsWithoutACameraAreRefused_data()
    {
        addColumn<QString>("text");
        addColumn<QString>("message");
        glm::dmat4 shear(1.0);
        shear[2][0] = 0.5;
        const QString zeros = QStringLiteral("0 ").repeated(16);
        newRow("words") << "no matrix at all"
                        << "0 numbers found, 16 are needed";
        newRow("nothing") << ""
                          << "it is empty";
        newRow("UTF-16 without its mark")
            << QString(QChar(0)).prepend('7') << "it has zero bytes, which no text has; save it as UTF-8";
        newRow("one short") << "1 0 0 0\n0 1 0 0\n0 0 1 0\n0 0 0"
                            << "15 numbers found, 16 are needed";
        newRow("one number") << "7"
                             << "1 number found, 16 are needed";
        newRow("half a viewport") << "projection " + zeros + " viewport 100 100"
                                  << "viewport: 2 numbers found, 4 are needed: x y width height, or 16 of a matrix";
        newRow("half a projection") << "view: " + QString::fromStdString(printed(view())) + "\nprojection: 1.5 2"
                                    << "projection: 2 numbers found, 16 are needed";
        newRow("NaN") << "1 0 0 0\n0 nan 0 0\n"
                      << ":2:3: \"nan\" is not a finite number";
        newRow("a call") << "gluPerspective(45, aspect, 0.1, 100)"
                         << "gluPerspective: the argument 'aspect' is not a number. Put its value there";
        newRow("a sheared box's product")
            << "mvp = " + QString::fromStdString(printed(glm::ortho(-3.0, 3.0, -2.0, 2.0, 1.0, 9.0) * shear * view()))
            << "product: it cannot be decomposed; give projection and view";
    }

    void textsWithoutACameraAreRefused()
    {
        QFETCH(QString, text);
        QFETCH(QString, message);
        const PastedCamera camera = pasted(text.toStdString());
        QVERIFY(camera.fault && !camera.projection && !camera.eyeFromWorld);
        QCOMPARE(QString::fromStdString(camera.fault->message()), message);
    }

    /// A program's camera counts before its matrices; but matrices that can be read do before a camera
    /// that cannot.
    void aProgramsCameraComesFirst()
    {
        const std::string krt = "K = [[500, 0, 319.5], [0, 510, 239.5], [0, 0, 1]]\n"
                                "R = [[1, 0, 0], [0, 1, 0], [0, 0, 1]]\nt = [0, 0, 5]\n";
        const PastedCamera camera = pasted(krt);
        QVERIFY(camera.scene && camera.matrices.empty());
        std::vector<std::string> read;
        for (const ReadValue &value : camera.foreign->read)
            read.push_back(value.name + " " + std::to_string(value.line));
        QCOMPARE(read, (std::vector<std::string>{"K 1", "R 2", "t 3"}));
        const PastedCamera open = pasted("worldToCameraMatrix\n1 0 0 -0.15\n0 1 0 -0.25\n0 0 -1 -0.45\n0 0 0 1\n"
                                         "projectionMatrix\n1.5 0 0 0\n0 2 0 0\n0 0 -1.0006 -0.60018\n0 0 -1 0\n");
        QVERIFY(open.foreign && !open.scene && open.fault && open.matrices.empty());
    }
};

UNPROJECTOR_TEST(TestPastedCamera)
#include "test_pasted_camera.moc"
