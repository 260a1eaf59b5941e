// Cameras of other programs, pasted, opened and dropped in the real dialog: what is assumed is said,
// and a field says otherwise. The scene then projects as the program does.

#include "tests/support/test.h"

#include "tests/gui/cut_texts.h"
#include "tests/gui/document_edits.h"
#include "tests/gui/gui_scene.h"

#include "core/cameras/foreign_camera.h"
#include "gui/document/camera_looks.h"
#include "gui/pipeline/foreign_camera_box.h"
#include "gui/pipeline/paste_camera_dialog.h"
#include "gui/pipeline/pasted_matrix_box.h"
#include "tests/support/data_files.h"
#include "tests/support/patience.h"

#include <QApplication>
#include <QCheckBox>
#include <QClipboard>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QDir>
#include <QDragEnterEvent>
#include <QDropEvent>
#include <QFile>
#include <QGuiApplication>
#include <QLabel>
#include <QLineEdit>
#include <QMimeData>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QTemporaryDir>
#include <QUrl>

#include <glm/gtc/matrix_transform.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>

using namespace guitest;
using namespace unprojector::geometry;
using namespace unprojector::gui;
using namespace unprojector::cameras;
using namespace unprojector::pipeline;

namespace {

constexpr double kFx = 500.0, kFy = 510.0, kCx = 319.5, kCy = 239.5;

/// World to OpenCV's camera: x right, y down, z ahead.
glm::dmat4 cameraFromWorld()
{
    const glm::dmat4 eyeFromWorld =
        glm::lookAt(kCubeCenter + glm::dvec3(1.0, 2.0, 8.0), kCubeCenter + glm::dvec3(0.2, -0.1, 0.0), {0.1, 1.0, 0.0});
    return glm::scale(glm::dmat4(1.0), glm::dvec3(1.0, -1.0, -1.0)) * eyeFromWorld;
}

QString number(double value)
{
    return QString::number(value, 'g', 17);
}

QString rowsOf(const glm::dmat3 &m)
{
    QStringList rows;
    for (int i = 0; i < 3; ++i)
        rows << QStringLiteral("[%1, %2, %3]").arg(number(m[0][i]), number(m[1][i]), number(m[2][i]));
    return QStringLiteral("[%1]").arg(rows.join(QStringLiteral(",\n ")));
}

/// K, R and t as NumPy prints them.
QString krt()
{
    const glm::dmat4 m = cameraFromWorld();
    return QStringLiteral("K = [[%1, 0, %2],\n [0, %3, %4],\n [0, 0, 1]]\nR = %5\nt = [%6, %7, %8]\n")
        .arg(number(kFx), number(kCx), number(kFy), number(kCy), rowsOf(glm::dmat3(m)), number(m[3][0]),
             number(m[3][1]), number(m[3][2]));
}

/// The pixel of a world point as OpenCV computes it: the first pixel's centre is at 0, 0.
glm::dvec2 projectedByKrt(const glm::dvec3 &world)
{
    const glm::dvec3 p(cameraFromWorld() * glm::dvec4(world, 1.0));
    return {kFx * p.x / p.z + kCx, kFy * p.y / p.z + kCy};
}

/// A dialog on the screen, and hands on it.
struct Pasting {
    SceneDocument document;
    PasteCameraDialog dialog{document};

    Pasting()
    {
        document.setSurface(surfaceFromWidget(400, 300, 1.0));
        openObjects(document, cubeScene());
        dialog.show();
        if (!QTest::qWaitForWindowExposed(&dialog, kPatienceMilliseconds))
            qFatal("The dialog is not shown.");
    }
    PastedMatrixBox *box(MatrixRole role) const
    {
        return dialog.findChildren<PastedMatrixBox *>().at(role == MatrixRole::Projection ? 0 : 1);
    }
    /// Pastes as a user does: by the clipboard and the keyboard.
    void paste(const QString &text, MatrixRole role = MatrixRole::Projection) const
    {
        auto *edit = box(role)->findChild<QPlainTextEdit *>();
        edit->setFocus();
        edit->selectAll();
        QGuiApplication::clipboard()->setText(text);
        QTest::keySequence(edit, QKeySequence::Paste);
    }
    template <class Widget>
    Widget *named(const char *name) const
    {
        for (Widget *widget : foreign()->findChildren<Widget *>()) {
            if (widget->accessibleName() == QLatin1String(name) && widget->isVisible())
                return widget;
        }
        return nullptr;
    }
    ForeignCameraBox *foreign() const { return dialog.findChild<ForeignCameraBox *>(); }
    QCheckBox *check(const QString &text) const
    {
        for (QCheckBox *box : foreign()->findChildren<QCheckBox *>()) {
            if (box->text() == text && box->isVisible())
                return box;
        }
        return nullptr;
    }
    void type(const char *name, const QString &text) const
    {
        auto *field = named<QLineEdit>(name);
        field->setFocus();
        field->selectAll();
        QTest::keyClicks(field, text);
    }
    void choose(const char *name, int index) const
    {
        auto *combo = named<QComboBox>(name);
        combo->setCurrentIndex(index);
        emit combo->activated(index);
    }
    QPushButton *ok() const { return dialog.findChild<QDialogButtonBox *>()->button(QDialogButtonBox::Ok); }
    QString said() const
    {
        QStringList all;
        for (const QLabel *label : dialog.findChildren<QLabel *>()) {
            if (label->isVisible())
                all << label->text();
        }
        return all.join('\n');
    }
    /// The pixel of a world point in the document's view, from the corner of the image.
    glm::dvec2 pixelOf(const glm::dvec3 &world) const
    {
        const Setup &setup = document.setup();
        const DevicePoint at = deviceFromWindow(setup.surface, *windowFromWorld(setup, WorldPoint(world)));
        return {at.x, at.y};
    }
};

std::filesystem::path written(const QTemporaryDir &folder, const QString &name, const QByteArray &text)
{
    QFile file(folder.filePath(name));
    if (!file.open(QIODevice::WriteOnly) || file.write(text) != text.size())
        qFatal("A test's file cannot be written.");
    return {file.fileName().toStdU16String()};
}

bool areClose(const glm::dvec2 &a, const glm::dvec2 &b, double tolerance = 1e-9)
{
    const bool are = std::abs(a.x - b.x) <= tolerance && std::abs(a.y - b.y) <= tolerance;
    if (!are)
        qWarning("%.12g %.12g is not %.12g %.12g", a.x, a.y, b.x, b.y);
    return are;
}

const glm::dvec3 kPoint = kCubeCenter + glm::dvec3(0.4, 0.7, 1.0);
const glm::dvec2 kHalfPixels(0.5, 0.5);

} // namespace

namespace {

const QString kUnityView = QStringLiteral("worldToCameraMatrix\n1 0 0 -0.15\n0 1 0 -0.25\n0 0 -1 -0.45\n0 0 0 1\n");
const QString kUnityLens = QStringLiteral("projectionMatrix\n1.5 0 0 0\n0 2 0 0\n0 0 -1.0006 -0.60018\n0 0 -1 0\n");

} // namespace

class TestPasteCamera : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { redirectSettings(); }

    void theSceneProjectsAsTheProgram()
    {
        Pasting pasting;
        QVERIFY(!pasting.foreign()->isVisible());
        pasting.paste(krt());
        QVERIFY2(pasting.foreign()->isVisible() && pasting.said().contains("Camera of OpenCV"),
                 qPrintable(pasting.said()));
        QVERIFY2(pasting.said().contains("The view gets the image's size, 640 × 480."), qPrintable(pasting.said()));
        QVERIFY(pasting.ok()->isEnabled());
        pasting.ok()->click();
        QVERIFY(!pasting.dialog.isVisible());
        QCOMPARE(pasting.document.setup().surface, (Surface{640, 480, 1.0}));
        for (const glm::dvec3 &off : {glm::dvec3(0.0), glm::dvec3(0.4, 0.7, 1.0), glm::dvec3(-1.0, -0.8, 0.3)}) {
            const glm::dvec3 world = kCubeCenter + off;
            QVERIFY(areClose(pasting.pixelOf(world), projectedByKrt(world) + kHalfPixels));
        }
    }

    void theTextsMayBeInBothFields()
    {
        Pasting pasting;
        const QString text = krt();
        const auto split = text.indexOf("R = ");
        pasting.paste(text.mid(split), MatrixRole::View);
        pasting.paste(text.left(split));
        QVERIFY(pasting.ok()->isEnabled());
        pasting.ok()->click();
        QVERIFY(areClose(pasting.pixelOf(kPoint), projectedByKrt(kPoint) + kHalfPixels));
    }

    void oneStepIsUndone()
    {
        Pasting pasting;
        const Setup before = pasting.document.setup();
        pasting.paste(krt());
        pasting.ok()->click();
        QVERIFY(pasting.document.setup() != before);
        QCOMPARE(pasting.document.undoStack().undoText(), QStringLiteral("Paste Camera"));
        pasting.document.undoStack().undo();
        QCOMPARE(pasting.document.setup(), before);
    }

    void nearAndFarCanBeSaid()
    {
        Pasting pasting;
        pasting.paste(krt());
        QVERIFY2(pasting.said().contains("“Near” and “Far” say otherwise"), qPrintable(pasting.said()));
        QVERIFY(!pasting.said().contains("--"));
        pasting.type("Near", "0.25");
        pasting.type("Far", "x");
        QVERIFY2(pasting.said().contains("“x” is not a distance"), qPrintable(pasting.said()));
        QVERIFY(!pasting.ok()->isEnabled());
        pasting.type("Far", "40");
        QVERIFY2(pasting.said().contains("near 0.25, far 40"), qPrintable(pasting.said()));
        pasting.ok()->click();
        const ProjectionWindow planes = projectionWindow(pasting.document.setup().projection());
        QVERIFY(std::abs(planes.nearDistance - 0.25) < 1e-9 && std::abs(planes.farDistance - 40.0) < 1e-6);
    }

    void sizeCanBeSaidAndLeft()
    {
        Pasting pasting;
        pasting.paste(krt());
        pasting.type("Image size", "800 x");
        QVERIFY(!pasting.ok()->isEnabled());
        pasting.type("Image size", "800 x 600");
        QVERIFY2(pasting.said().contains("800 × 600"), qPrintable(pasting.said()));
        pasting.ok()->click();
        QCOMPARE(pasting.document.setup().surface, (Surface{800, 600, 1.0}));
        QVERIFY(areClose(pasting.pixelOf(kPoint), projectedByKrt(kPoint) + kHalfPixels));

        Pasting keeping;
        keeping.paste(krt());
        keeping.check("Give the view this size")->click();
        keeping.ok()->click();
        QVERIFY(!keeping.document.scene().windowSize);
        QCOMPARE(keeping.document.setup().surface.widthPixels, 400);
    }

    void axesAndPoseCanBeSaid()
    {
        Pasting pasting;
        pasting.paste(krt());
        const glm::dmat4 read = (*pasting.foreign()->camera())->eyeFromWorld;
        pasting.choose("Axes of the camera", 1); // OpenGL's
        const glm::dmat4 turned = (*pasting.foreign()->camera())->eyeFromWorld;
        QVERIFY(std::abs(turned[0][1] + read[0][1]) < 1e-12 && std::abs(turned[0][2] + read[0][2]) < 1e-12);
        pasting.choose("Axes of the camera", 2); // OpenCV's
        pasting.choose("Pose", 2);               // camera to world
        const glm::dvec3 eye(glm::inverse((*pasting.foreign()->camera())->eyeFromWorld)[3]);
        QVERIFY(glm::distance(eye, glm::dvec3(cameraFromWorld()[3])) < 1e-9);
        pasting.choose("Pose", 0);
        QCOMPARE((*pasting.foreign()->camera())->eyeFromWorld, read);
    }

    void pixelCentresCanBeSaid()
    {
        Pasting pasting;
        pasting.paste(krt());
        pasting.type("Image size", "640 x 480");
        pasting.choose("Pixel centres", 2); // at halves
        pasting.ok()->click();
        QVERIFY(areClose(pasting.pixelOf(kPoint), projectedByKrt(kPoint)));

        // A camera without principal point has its image's centre: there is no choice.
        Pasting computed;
        computed.paste("position: (1, 2, 8)\nrotation: (0, 0, 0, 1)\nfieldOfView: 60\n");
        computed.type("Image size", "640 x 480");
        QVERIFY2(computed.ok()->isEnabled(), qPrintable(computed.said()));
        QVERIFY(!computed.named<QComboBox>("Pixel centres"));
    }

    void theObjectsDecideThePose()
    {
        // A 4 x 4 pose without a name that tells its direction: only one direction shows the cube.
        const glm::dmat4 pose = glm::inverse(cameraFromWorld());
        QStringList rows;
        for (int i = 0; i < 4; ++i)
            rows << QStringLiteral("[%1, %2, %3, %4]")
                        .arg(number(pose[0][i]), number(pose[1][i]), number(pose[2][i]), number(pose[3][i]));
        Pasting pasting;
        pasting.paste(
            QStringLiteral("K = [[500, 0, 319.5], [0, 510, 239.5], [0, 0, 1]]\npose = [%1]").arg(rows.join(", ")));
        QVERIFY2(pasting.said().contains("“Camera to world”") && !pasting.said().contains("camera-to-world"),
                 qPrintable(pasting.said()));
        pasting.ok()->click();
        QVERIFY(areClose(pasting.pixelOf(kPoint), projectedByKrt(kPoint) + kHalfPixels));
    }

    void distortionWantsAWord()
    {
        Pasting pasting;
        pasting.paste(krt() + QStringLiteral("dist = [0.1, -0.02, 0.001, 0, 0]\n"));
        QVERIFY2(pasting.said().contains("k1 0.1, k2 -0.02") || pasting.said().contains("k1 0.1, k2 −0.02"),
                 qPrintable(pasting.said()));
        QVERIFY(!pasting.ok()->isEnabled());
        pasting.check("My pixels are of the undistorted image")->click();
        QVERIFY2(pasting.ok()->isEnabled(), qPrintable(pasting.said()));
    }

    void faultsNameLineAndValue()
    {
        Pasting pasting;
        pasting.paste("K = [[500, 0, 319.5], [0, 510, 239.5], [0, 0, 1]]\nR = [[1, 0, 0],\n [0, 1, 0], [0, 0.5, 1]]\n"
                      "t = [0, 0, 5]");
        QVERIFY2(pasting.said().contains("the pose's axes are not perpendicular"), qPrintable(pasting.said()));
        QVERIFY(!pasting.ok()->isEnabled());
        pasting.paste("K = [[500, 0, 319.5], [0, 510, 239.5], [0, 0, 1, 7]]\n");
        QVERIFY(!pasting.ok()->isEnabled());
        QVERIFY2(pasting.said().contains("line 1"), qPrintable(pasting.said()));
    }

    void everyProgramsFilesAreRead_data()
    {
        addColumn<int>("index");
        for (std::size_t i = 0; i < data_files::cameraExamples().size(); ++i)
            addRow("%zu %s", i, data_files::cameraExamples()[i].name.c_str()) << static_cast<int>(i);
    }

    /// Each program's own projection of its points, with a scene made by the dialog.
    void everyProgramsFilesAreRead()
    {
        QFETCH(int, index);
        const data_files::CameraExample &example = data_files::cameraExamples().at(std::size_t(index));
        const QTemporaryDir folder;
        std::vector<std::filesystem::path> files;
        std::vector<unprojector::cameras::NamedText> texts;
        for (const auto &text : example.texts) {
            const QString own = QString::number(files.size()); // the file's name may count
            QVERIFY(QDir(folder.path()).mkpath(own));
            files.push_back(
                written(folder, own + QLatin1Char('/') + QString::fromStdString(text.name), text.text.c_str()));
            texts.push_back({text.name, text.text});
        }
        Pasting pasting;
        QVERIFY(removeObject(pasting.document, 0)); // the points are of another scene
        pasting.dialog.readFiles(files);
        QVERIFY2(pasting.foreign()->isVisible(), qPrintable(pasting.said()));
        if (example.width > 0)
            pasting.type("Image size", QStringLiteral("%1 x %2").arg(example.width).arg(example.height));
        const QString wanted = QString::fromStdString(example.image);
        auto *image = pasting.named<QComboBox>("Image");
        if (image && !wanted.isEmpty()) {
            unprojector::cameras::CameraChoices choices;
            choices.image = example.image;
            choices.size = unprojector::cameras::ImageSize{example.width, example.height};
            if (example.width == 0)
                choices.size.reset();
            const auto camera = unprojector::cameras::readCamera(texts, choices);
            QVERIFY(camera && *camera);
            const int at =
                image->findText(QString::fromStdString((*camera)->images.at((*camera)->image)), Qt::MatchExactly);
            QVERIFY2(at >= 0, example.image.c_str());
            pasting.choose("Image", at);
        }
        if (QCheckBox *undistorted = pasting.check("My pixels are of the undistorted image"))
            undistorted->click();
        QVERIFY2(pasting.ok()->isEnabled(), qPrintable(pasting.said()));
        pasting.ok()->click();
        const Surface &surface = pasting.document.setup().surface;
        const double tolerance = example.tolerance * std::max(surface.widthPixels, surface.heightPixels);
        for (const data_files::CameraExample::Point &point : example.points) {
            const glm::dvec2 expected(point.pixel[0] + example.corner, point.pixel[1] + example.corner);
            QVERIFY(areClose(pasting.pixelOf({point.world[0], point.world[1], point.world[2]}), expected,
                             std::max(tolerance, 1e-9)));
        }
    }

    void filesAreDropped()
    {
        const QTemporaryDir folder;
        const auto file = written(folder, QStringLiteral("camera.txt"), krt().toUtf8());
        Pasting pasting;
        QMimeData data;
        data.setUrls({QUrl::fromLocalFile(QString::fromStdU16String(file.u16string()))});
        QDragEnterEvent enter(QPoint(20, 20), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
        QApplication::sendEvent(&pasting.dialog, &enter);
        QVERIFY(enter.isAccepted());
        QDropEvent drop(QPointF(20, 20), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
        QApplication::sendEvent(&pasting.dialog, &drop);
        QVERIFY2(pasting.said().contains("camera.txt"), qPrintable(pasting.said()));
        QVERIFY(!pasting.box(MatrixRole::Projection)->isVisible());
        QVERIFY(pasting.ok()->isEnabled());
        for (QPushButton *button : pasting.dialog.findChildren<QPushButton *>()) {
            if (button->text().remove(u'&') == QStringLiteral("Type instead"))
                button->click();
        }
        QVERIFY(pasting.box(MatrixRole::Projection)->isVisible() && !pasting.ok()->isEnabled());
    }

    void strangeFilesAreRefused()
    {
        const QTemporaryDir folder;
        Pasting pasting;
        pasting.dialog.readFiles({written(folder, QStringLiteral("a.txt"), "nothing"),
                                  written(folder, QStringLiteral("b.txt"), "of a camera")});
        QVERIFY2(pasting.said().contains("These files have no camera of a program that is known here"),
                 qPrintable(pasting.said()));
        QVERIFY(!pasting.ok()->isEnabled());
        pasting.dialog.readFiles({std::filesystem::path(folder.filePath(QStringLiteral("none")).toStdU16String())});
        QVERIFY2(pasting.said().contains("cannot be read"), qPrintable(pasting.said()));
        // A file with matrices is read as matrices.
        const auto large = written(folder, QStringLiteral("large.yml"), {});
        QVERIFY(QFile::resize(QString::fromStdU16String(large.u16string()),
                              qint64(unprojector::cameras::kMostCameraBytes) + 1));
        pasting.dialog.readFiles({large});
        QVERIFY2(pasting.said().contains("larger than 256 MiB"), qPrintable(pasting.said()));
        pasting.dialog.readFiles(
            {written(folder, QStringLiteral("m.txt"), "2 0 0 0  0 2 0 0  0 0 -1.1 -1  0 0 -2.1 0")});
        QVERIFY2(!pasting.foreign()->isVisible() && pasting.ok()->isEnabled(), qPrintable(pasting.said()));
    }

    void matricesStayMatrices()
    {
        Pasting pasting;
        pasting.paste(krt());
        QVERIFY(pasting.foreign()->isVisible());
        pasting.paste("projection = [[2, 0, 0, 0], [0, 2, 0, 0], [0, 0, -1.1, -2.1], [0, 0, -1, 0]]");
        QVERIFY(!pasting.foreign()->isVisible());
        QVERIFY(pasting.box(MatrixRole::View)->isVisible());
        pasting.ok()->click();
        QVERIFY(pasting.document.scene().projection.matrix() && !pasting.document.scene().windowSize);
    }

    void unitysMatricesAreUnitys_data()
    {
        addColumn<QString>("first");
        addColumn<QString>("second");
        addColumn<bool>("isFile");
        newRow("one text") << kUnityView + kUnityLens << QString() << false;
        newRow("a field each") << kUnityLens << kUnityView << false;
        newRow("exchanged fields") << kUnityView << kUnityLens << false;
        newRow("a file") << kUnityView + kUnityLens << QString() << true;
    }

    /// Without a size they are not taken as plain matrices: the dialog asks for the size.
    void unitysMatricesAreUnitys()
    {
        QFETCH(QString, first);
        QFETCH(QString, second);
        QFETCH(bool, isFile);
        const QTemporaryDir folder;
        Pasting pasting;
        if (isFile)
            pasting.dialog.readFiles({written(folder, QStringLiteral("u.txt"), first.toUtf8())});
        else
            pasting.paste(first);
        if (!second.isEmpty())
            pasting.paste(second, MatrixRole::View);
        QVERIFY2(pasting.said().contains("Camera of Unity"), qPrintable(pasting.said()));
        QVERIFY(!pasting.ok()->isEnabled());
        QVERIFY2(pasting.said().contains("size of the image is not given"), qPrintable(pasting.said()));
        pasting.type("Image size", "640 x 480");
        QVERIFY2(pasting.ok()->isEnabled(), qPrintable(pasting.said()));
        pasting.ok()->click();
        const glm::dvec3 eye = pasting.document.setup().camera().eye.coordinates();
        QVERIFY2(glm::distance(eye, {0.15, 0.25, 0.45}) < 1e-9, qPrintable(pasting.said()));
    }

    void mirroringIsSaid()
    {
        Pasting pasting;
        pasting.paste(QString(kUnityView).replace("worldToCameraMatrix", "view"), MatrixRole::View);
        QVERIFY2(pasting.said().contains("“Flip x” keeps the coordinates of that world and mirrors the image"),
                 qPrintable(pasting.said()));
    }

    void filesOpenedOneByOneJoin()
    {
        const QTemporaryDir folder;
        const auto images = written(folder, QStringLiteral("images.txt"), "1 1 0 0 0 0 0 5 1 a.png\n\n"),
                   cameras = written(folder, QStringLiteral("cameras.txt"), "1 PINHOLE 640 480 500 510 320 240\n"),
                   other = written(folder, QStringLiteral("other.txt"), krt().toUtf8());
        for (const bool areImagesFirst : {true, false}) {
            Pasting pasting;
            pasting.dialog.readFiles({areImagesFirst ? images : cameras});
            QVERIFY(!pasting.ok()->isEnabled());
            QVERIFY2(pasting.said().contains(areImagesFirst ? "give cameras.txt" : "give images.txt"),
                     qPrintable(pasting.said()));
            pasting.dialog.readFiles({areImagesFirst ? cameras : images});
            QVERIFY2(pasting.ok()->isEnabled() && pasting.said().contains("Camera of COLMAP"),
                     qPrintable(pasting.said()));
            QVERIFY(pasting.said().contains("images.txt") && pasting.said().contains("cameras.txt"));
            // A whole camera replaces them.
            pasting.dialog.readFiles({other});
            QVERIFY(pasting.said().contains("other.txt") && !pasting.said().contains("images.txt"));
        }
    }

    void choicesThatDontApplyAreDisabled()
    {
        Pasting pasting;
        pasting.paste(krt());
        pasting.paste("K = [[500, 0, 319.5], [0, 510, 239.5], [0, 0, 1, 7]]\n");
        QVERIFY(!pasting.ok()->isEnabled());
        QVERIFY(pasting.named<QLineEdit>("Image size")->isEnabled());
        for (const char *name : {"Near", "Far"})
            QVERIFY2(!pasting.named<QLineEdit>(name)->isEnabled(), name);
        for (const char *name : {"Axes of the camera", "Pose", "Pixel centres"})
            QVERIFY2(!pasting.named<QComboBox>(name)->isEnabled(), name);
        pasting.paste(krt());
        QVERIFY(pasting.named<QLineEdit>("Near")->isEnabled() && pasting.named<QComboBox>("Pose")->isEnabled());
    }

    void blendersMatrixNeedsItsName()
    {
        Pasting pasting;
        const QString matrix = QStringLiteral("<Matrix 4x4 (1.0, 0.0, 0.0, 0.5)\n            (0.0, 1.0, 0.0, 0.7)\n"
                                              "            (0.0, 0.0, 1.0, 9.0)\n            (0.0, 0.0, 0.0, 1.0)>");
        pasting.paste(matrix, MatrixRole::View);
        QVERIFY2(pasting.said().contains("write “matrix_world =” before it"), qPrintable(pasting.said()));
        // What it says is right.
        Pasting named;
        named.paste("matrix_world = " + matrix + "\nlens = 50\n");
        QVERIFY2(!named.ok()->isEnabled(), qPrintable(named.said())); // the size is asked for
        named.type("Image size", "640 x 480");
        QVERIFY2(named.said().contains("Camera of Blender") && named.ok()->isEnabled(), qPrintable(named.said()));
    }

    void planesBeyondTheObjectsAreSaid()
    {
        Pasting pasting;
        pasting.paste(krt());
        QVERIFY(!pasting.said().contains("Nothing will be seen"));
        pasting.type("Far", "5000");
        pasting.type("Near", "1000");
        QVERIFY2(pasting.said().contains("Nothing will be seen"), qPrintable(pasting.said()));
        pasting.type("Near", "0.1");
        pasting.type("Far", "0.2");
        QVERIFY2(pasting.said().contains("Nothing will be seen"), qPrintable(pasting.said()));
    }

    void bothTextsLeaveRoomForTheFields()
    {
        Pasting pasting;
        pasting.paste(kUnityLens);
        pasting.paste(kUnityView, MatrixRole::View);
        QCoreApplication::processEvents();
        const auto *size = pasting.named<QLineEdit>("Image size");
        QVERIFY(size);
        const int wanted = size->fontMetrics().horizontalAdvance(QStringLiteral("00000 x 00000"));
        QVERIFY2(size->width() > wanted, qPrintable(QString::number(size->width())));
        QVERIFY(pasting.said().contains("Camera, first text") && pasting.said().contains("Camera, second text"));
        // One above the other.
        QVERIFY(pasting.box(MatrixRole::View)->y() > pasting.box(MatrixRole::Projection)->y());
        QCOMPARE(pasting.box(MatrixRole::View)->x(), pasting.box(MatrixRole::Projection)->x());
        QTRY_VERIFY2_WITH_TIMEOUT(cutTexts(pasting.dialog).isEmpty(), qPrintable(cutTexts(pasting.dialog).join('\n')),
                                  kPatienceMilliseconds);
    }

    void nothingIsCut()
    {
        Pasting pasting;
        pasting.paste(krt() + QStringLiteral("dist = [0.1, -0.02, 0.001, 0, 0]\n"));
        QTRY_VERIFY2_WITH_TIMEOUT(cutTexts(pasting.dialog).isEmpty(), qPrintable(cutTexts(pasting.dialog).join('\n')),
                                  kPatienceMilliseconds);
    }
};

UNPROJECTOR_TEST(TestPasteCamera, display)
#include "test_paste_camera.moc"
