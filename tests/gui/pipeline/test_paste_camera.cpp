// Cameras of other programs, pasted, opened and dropped in the real dialog: it says how they are
// read, and a field says otherwise. The scene then projects as the program does.

#include "tests/gui/pipeline/pasting.h"
#include "tests/support/test.h"

#include "tests/gui/cut_texts.h"

#include "core/cameras/foreign_camera.h"
#include "gui/text/translation.h"
#include "tests/support/data_files.h"

#include <QApplication>
#include <QDir>
#include <QDragEnterEvent>
#include <QDropEvent>
#include <QFile>
#include <QLabel>
#include <QMimeData>
#include <QScopeGuard>
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
        QVERIFY(!pasting.ok()->isEnabled() && !pasting.named<QLineEdit>("Image size"));
        pasting.paste(krt());
        QVERIFY(pasting.says("Camera of OpenCV"));
        QVERIFY(pasting.says("fx 500, fy 510, cx 319.5, cy 239.5 pixels, from K (line 1)"));
        QVERIFY(pasting.says("World to camera, from R (line 4), t (line 7)"));
        QVERIFY(pasting.says("The view gets the image's size, 640 × 480."));
        pasting.ok()->click();
        QVERIFY(!pasting.dialog->isVisible());
        QCOMPARE(pasting.document.setup().surface, (Surface{640, 480, 1.0}));
        for (const glm::dvec3 &off : {glm::dvec3(0.0), glm::dvec3(0.4, 0.7, 1.0), glm::dvec3(-1.0, -0.8, 0.3)}) {
            const glm::dvec3 world = kCubeCenter + off;
            QVERIFY(areClose(pasting.pixelOf(world), projectedByKrt(world) + kHalfPixels));
        }
    }

    /// OK is one step of undo; without it, the scene shows the camera only while the dialog is open.
    void theSceneShowsTheCameraMeanwhile()
    {
        Pasting pasting;
        SceneDocument &document = pasting.document;
        document.markSaved();
        const Setup before = document.setup();
        const auto settings = document.scene();
        const int steps = document.undoStack().count();
        pasting.paste(krt());
        QVERIFY(areClose(pasting.pixelOf(kPoint), projectedByKrt(kPoint) + kHalfPixels));
        QCOMPARE(document.setup().surface, (Surface{640, 480, 1.0}));
        QVERIFY(!document.isModified() && !document.isEdited());
        pasting.paste("no camera");
        QCOMPARE(document.setup(), before);
        pasting.paste(krt());
        QVERIFY(document.setup() != before);
        QTest::keyClick(pasting.dialog.get(), Qt::Key_Escape);
        QVERIFY(!pasting.dialog->isVisible());
        QCOMPARE(document.setup(), before);
        QVERIFY(changesBetween(document.scene(), settings) == Changes());
        QCOMPARE(document.undoStack().count(), steps);
        QVERIFY(!document.isModified() && !document.isEdited());

        pasting.dialog->show();
        pasting.paste(krt() + "\n");
        pasting.ok()->click();
        QCOMPARE(document.undoStack().count(), steps + 1);
        QCOMPARE(document.undoStack().undoText(), QStringLiteral("Paste Camera"));
        QVERIFY(areClose(pasting.pixelOf(kPoint), projectedByKrt(kPoint) + kHalfPixels));
        document.undoStack().undo();
        QCOMPARE(document.setup(), before);
    }

    /// Only the views follow a preview; the window's size may change meanwhile.
    void aPreviewIsNoChange()
    {
        Pasting pasting;
        SceneDocument &document = pasting.document;
        Changes told;
        connect(&document, &SceneDocument::changed, this, [&told](Changes changes) { told |= changes; });
        pasting.paste("gluLookAt(3, 2, 5, 0, 0, 0, 0, 1, 0)");
        QCOMPARE(told, Changes(Change::Preview));
        document.setSurface(surfaceFromWidget(500, 300, 1.0));
        QCOMPARE(told, Changes(Change::Preview));
        pasting.dialog->reject();
        QCOMPARE(told, Change::Preview | Change::Setup);
        QCOMPARE(document.setup().surface.widthPixels, 500);
        // An edit begins with the scene's own camera.
        const LookAt own = document.setup().camera();
        pasting.paste("gluLookAt(30, 2, 5, 0, 0, 0, 0, 1, 0)");
        QVERIFY(document.setup().camera() != own);
        QVERIFY(removeObject(document, 0));
        QCOMPARE(document.setup().camera(), own);
    }

    void undoEndsAPreview()
    {
        Pasting pasting;
        SceneDocument &document = pasting.document;
        const LookAt first = document.setup().camera();
        LookAt second = first;
        second.eye += WorldVector(0.5, 0.0, 0.0);
        setCamera(document, second);
        pasting.paste("gluLookAt(30, 2, 5, 0, 0, 0, 0, 1, 0)");
        document.undoStack().undo();
        QCOMPARE(document.setup().camera(), first);
        document.endPreview();
        QCOMPARE(document.setup().camera(), first);
    }

    void anotherSceneIsPreviewed()
    {
        Pasting pasting;
        pasting.paste("gluLookAt(30, 2, 5, 0, 0, 0, 0, 1, 0)");
        Changes told;
        connect(&pasting.document, &SceneDocument::changed, this, [&told](Changes changes) { told |= changes; });
        openObjects(pasting.document, cubeScene());
        const Setup own = pasting.document.setup();
        QTRY_VERIFY_WITH_TIMEOUT(told & Change::Preview, kPatienceMilliseconds);
        QVERIFY(pasting.document.setup() != own && pasting.document.ownSetup() == own);
        pasting.dialog->reject();
        QCOMPARE(pasting.document.setup(), own);
    }

    void nearAndFarCanBeSaid()
    {
        Pasting pasting;
        pasting.paste(krt());
        QVERIFY(pasting.says("“Near” and “Far” say otherwise") && !pasting.report()->toPlainText().contains("--"));
        pasting.type("Near", "0.25");
        pasting.type("Far", "x");
        QVERIFY(pasting.says("“x” is not a distance"));
        QVERIFY(!pasting.ok()->isEnabled());
        pasting.type("Far", "40");
        QVERIFY(pasting.says("0.25, 40"));
        pasting.ok()->click();
        const ProjectionWindow planes = projectionWindow(pasting.document.setup().projection());
        QVERIFY(std::abs(planes.nearDistance - 0.25) < 1e-9 && std::abs(planes.farDistance - 40.0) < 1e-6);
    }

    /// What the report names is there.
    void fieldsOfAssumptionsAreShown()
    {
        Pasting pasting;
        pasting.paste("position: (1, 2, 9)\nfocal point: (0, 0, 0)\nview up: (0, 1, 0)\nparallel projection: On\n"
                      "parallel scale: 3\n");
        pasting.type("Image size", "640 x 480");
        QVERIFY(pasting.says("“Near” and “Far” say otherwise"));
        pasting.type("Far", "40");
        QVERIFY(pasting.says("0, 40") && pasting.named<QLineEdit>("Far"));

        pasting.paste("width: 640\nheight: 480\ndistortion_model: plumb_bob\nD: [0, 0, 0, 0, 0]\n"
                      "K: [500, 0, 320, 0, 510, 240, 0, 0, 1]\nR: [1, 0, 0, 0, 1, 0, 0, 0, 1]\n"
                      "P: [480, 0, 320, 0, 0, 490, 240, 0, 0, 0, 1, 0]\n");
        QVERIFY(pasting.says("“My pixels are of the undistorted image” takes P"));
        pasting.button("My pixels are of the undistorted image")->click();
        QVERIFY(pasting.says("fx 480") && pasting.button("My pixels are of the undistorted image"));
    }

    void imagesOfOneNameAreToldApart()
    {
        const QTemporaryDir folder;
        Pasting pasting;
        pasting.dialog->readFiles(
            {written(folder, QStringLiteral("images.txt"),
                     "7 1 0 0 0 0 0 5 1 a.png\n\n8 1 0 0 0 1 0 5 1 b.png\n\n9 1 0 0 0 2 0 5 1 a.png\n\n"),
             written(folder, QStringLiteral("cameras.txt"), "1 PINHOLE 640 480 500 510 320 240\n")});
        for (const int image : {2, 1, 0}) {
            pasting.choose("Image", image);
            QVERIFY(pasting.ok()->isEnabled());
            QCOMPARE(pasting.document.setup().camera().eye.x, -double(image));
            QCOMPARE(pasting.named<QComboBox>("Image")->currentIndex(), image);
        }
    }

    void sizeCanBeSaidAndLeft()
    {
        Pasting pasting;
        pasting.paste(krt());
        pasting.type("Image size", "800 x");
        QVERIFY(!pasting.ok()->isEnabled());
        pasting.type("Image size", "800 x 600");
        QVERIFY(pasting.says("800 × 600"));
        pasting.ok()->click();
        QCOMPARE(pasting.document.setup().surface, (Surface{800, 600, 1.0}));
        QVERIFY(areClose(pasting.pixelOf(kPoint), projectedByKrt(kPoint) + kHalfPixels));

        Pasting keeping;
        keeping.paste(krt());
        keeping.button("Give the view this size")->click();
        keeping.ok()->click();
        QVERIFY(!keeping.document.scene().windowSize);
        QCOMPARE(keeping.document.setup().surface.widthPixels, 400);
    }

    void axesAndPoseCanBeSaid()
    {
        Pasting pasting;
        pasting.paste(krt());
        const auto view = [&] { return *eyeFromWorld(pasting.document.setup()); };
        const glm::dmat4 read = view();
        pasting.choose("Axes of the camera", 1); // OpenGL's
        QVERIFY(std::abs(view()[0][1] + read[0][1]) < 1e-9 && std::abs(view()[0][2] + read[0][2]) < 1e-9);
        pasting.choose("Axes of the camera", 2); // OpenCV's
        pasting.choose("Pose", 2);               // camera to world
        QVERIFY(glm::distance(glm::dvec3(glm::inverse(view())[3]), glm::dvec3(cameraFromWorld()[3])) < 1e-9);
        // They last while the text of this camera is changed, and no longer.
        pasting.paste(krt() + "\n");
        QCOMPARE(pasting.named<QComboBox>("Pose")->currentIndex(), 2);
        pasting.paste("matrix_world = <Matrix 4x4 (1.0, 0.0, 0.0, 0.5)\n (0.0, 1.0, 0.0, 0.7)\n (0.0, 0.0, 1.0, 9.0)\n "
                      "(0.0, 0.0, 0.0, 1.0)>\nlens = 50\n");
        pasting.type("Image size", "640 x 480");
        QVERIFY(pasting.says("Camera of Blender"));
        QCOMPARE(pasting.named<QComboBox>("Pose")->currentIndex(), 0);
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
        QVERIFY(computed.ok()->isEnabled());
        QVERIFY(!computed.named<QComboBox>("Pixel centres"));
    }

    /// The direction of an unnamed pose is open: the objects decide it, else the user.
    void anOpenPoseIsAskedFor()
    {
        const QString lens = QStringLiteral("K = [[500, 0, 319.5], [0, 510, 239.5], [0, 0, 1]]\n");
        const glm::dmat4 pose = glm::inverse(cameraFromWorld());
        QStringList rows;
        for (int i = 0; i < 4; ++i)
            rows << QStringLiteral("[%1, %2, %3, %4]")
                        .arg(number(pose[0][i]), number(pose[1][i]), number(pose[2][i]), number(pose[3][i]));
        Pasting pasting;
        pasting.paste(lens + QStringLiteral("pose = [%1]").arg(rows.join(", ")));
        QVERIFY(pasting.says("“Camera to world”") && !pasting.report()->toPlainText().contains("camera-to-world"));
        pasting.ok()->click();
        QVERIFY(areClose(pasting.pixelOf(kPoint), projectedByKrt(kPoint) + kHalfPixels));

        Pasting open;
        open.paste(lens + "M = [[1, 0, 0, 0.2], [0, 1, 0, 0.1], [0, 0, 1, 40], [0, 0, 0, 1]]");
        QVERIFY(open.says("Pose: nothing tells its direction") && !open.ok()->isEnabled());
        QVERIFY(!open.report()->toPlainText().contains("to-"));
        QVERIFY(open.click("Camera to world"));
        QVERIFY(open.ok()->isEnabled());
        QVERIFY(glm::distance(open.document.setup().camera().eye.coordinates(), {0.2, 0.1, 40.0}) < 1e-9);
        QCOMPARE(open.named<QComboBox>("Pose")->currentIndex(), 2);
    }

    void distortionWantsAWord()
    {
        Pasting pasting;
        pasting.paste(krt() + QStringLiteral("dist = [0.1, -0.02, 0.001, 0, 0]\n"));
        QVERIFY(pasting.says("k1 0.1, k2 -0.02"));
        QVERIFY(!pasting.ok()->isEnabled());
        QVERIFY(pasting.says("undistort the image first") && !pasting.report()->toPlainText().contains("--"));
        pasting.button("My pixels are of the undistorted image")->click();
        QVERIFY(pasting.ok()->isEnabled());
    }

    void faultsNameLineAndValue()
    {
        Pasting pasting;
        pasting.paste("K = [[500, 0, 319.5], [0, 510, 239.5], [0, 0, 1]]\nR = [[1, 0, 0],\n [0, 1, 0], [0, 0.5, 1]]\n"
                      "t = [0, 0, 5]");
        QVERIFY(pasting.says("The pose's axes are not perpendicular"));
        QVERIFY(!pasting.ok()->isEnabled());
        pasting.paste("K = [[500, 0, 319.5], [0, 510, 239.5], [0, 0, 1, 7]]\n");
        QVERIFY(!pasting.ok()->isEnabled());
        QVERIFY(pasting.says("line 1"));
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
        std::vector<NamedText> texts;
        for (const auto &text : example.texts) {
            const QString own = QString::number(files.size()); // the file's name may count
            QVERIFY(QDir(folder.path()).mkpath(own));
            files.push_back(
                written(folder, own + QLatin1Char('/') + QString::fromStdString(text.name), text.text.c_str()));
            texts.push_back({text.name, text.text});
        }
        Pasting pasting;
        QVERIFY(removeObject(pasting.document, 0)); // the points are of another scene
        pasting.dialog->readFiles(files);
        if (example.width > 0)
            pasting.type("Image size", QStringLiteral("%1 x %2").arg(example.width).arg(example.height));
        const QString wanted = QString::fromStdString(example.image);
        auto *image = pasting.named<QComboBox>("Image");
        if (image && !wanted.isEmpty()) {
            CameraChoices choices;
            choices.image = example.image;
            choices.size = ImageSize{example.width, example.height};
            if (example.width == 0)
                choices.size.reset();
            const auto camera = readCamera(texts, choices);
            QVERIFY(camera && *camera);
            const int at =
                image->findText(QString::fromStdString((*camera)->images.at((*camera)->image)), Qt::MatchExactly);
            QVERIFY2(at >= 0, example.image.c_str());
            pasting.choose("Image", at);
        }
        if (QAbstractButton *undistorted = pasting.button("My pixels are of the undistorted image"))
            undistorted->click();
        QVERIFY(pasting.ok()->isEnabled() || !pasting.says(""));
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
        QApplication::sendEvent(pasting.dialog.get(), &enter);
        QVERIFY(enter.isAccepted());
        QDropEvent drop(QPointF(20, 20), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
        QApplication::sendEvent(pasting.dialog.get(), &drop);
        // Its text can be changed.
        QCOMPARE(pasting.named<QLabel>("Files of the camera")->text(), QStringLiteral("camera.txt"));
        QCOMPARE(pasting.text()->toPlainText(), krt());
        QVERIFY(pasting.ok()->isEnabled() && !pasting.button("Type instead"));
        pasting.text()->appendPlainText("dist = [0.1, 0, 0, 0, 0]");
        QVERIFY(!pasting.named<QLabel>("Files of the camera") && pasting.says("k1 0.1"));
    }

    void copiedFilesArePasted()
    {
        const QTemporaryDir folder;
        const auto file = written(folder, QStringLiteral("camera.txt"), krt().toUtf8());
        Pasting pasting;
        auto *copied = new QMimeData;
        copied->setUrls({QUrl::fromLocalFile(QString::fromStdU16String(file.u16string()))});
        QGuiApplication::clipboard()->setMimeData(copied);
        pasting.text()->paste();
        QCOMPARE(pasting.named<QLabel>("Files of the camera")->text(), QStringLiteral("camera.txt"));
        QVERIFY(pasting.ok()->isEnabled());
        pasting.dialog->reject();
        // A dialog that opens reads them, too, unless they are no camera.
        for (const bool isCamera : {true, false}) {
            if (!isCamera)
                written(folder, QStringLiteral("camera.txt"), "nothing");
            PasteCameraDialog::open(pasting.document, nullptr);
            PasteCameraDialog *opened = nullptr;
            for (QWidget *window : QApplication::topLevelWidgets()) {
                if (window->isVisible() && qobject_cast<PasteCameraDialog *>(window))
                    opened = qobject_cast<PasteCameraDialog *>(window);
            }
            QVERIFY(opened);
            QCOMPARE(opened->findChild<PlainTextBox *>()->toPlainText(), isCamera ? krt() : QString());
            opened->reject();
        }
    }

    void aRefusedFileLeavesTheCamera()
    {
        const QTemporaryDir folder;
        Pasting pasting;
        pasting.paste(krt());
        const Setup shown = pasting.document.setup();
        pasting.dialog->readFiles({std::filesystem::path(folder.filePath(QStringLiteral("none")).toStdU16String())});
        QVERIFY(pasting.says("cannot be read") && pasting.says("Camera of OpenCV"));
        pasting.dialog->setText(QString(kMostPastedCharacters + 1, u'1'));
        QVERIFY(pasting.says("at most 1000000 can be pasted") && pasting.says("Camera of OpenCV"));
        QVERIFY(pasting.ok()->isEnabled());
        QCOMPARE(pasting.document.setup(), shown);
        pasting.paste(krt() + "\n");
        QVERIFY(!pasting.report()->toPlainText().contains("Not read"));
    }

    void aPastedTextStaysTypable()
    {
        Pasting pasting;
        pasting.paste(QString(400'000, QChar(0x76f8)));
        QVERIFY(pasting.text()->isVisible());
        pasting.text()->setPlainText(QStringLiteral("a") + QChar(0) + QStringLiteral("b"));
        QVERIFY(pasting.text()->isVisible());
        const QTemporaryDir folder;
        pasting.dialog->readFiles(
            {written(folder, QStringLiteral("c.txt"), QByteArray("\xe7\x9b\xb8").repeated(400'000))});
        QVERIFY(pasting.text()->isVisible());
    }

    void strangeFilesAreRefused()
    {
        const QTemporaryDir folder;
        Pasting pasting;
        pasting.dialog->readFiles({written(folder, QStringLiteral("a.txt"), "nothing"),
                                   written(folder, QStringLiteral("b.txt"), "of a camera")});
        QVERIFY(pasting.says("No camera yet") && !pasting.ok()->isEnabled());
        QCOMPARE(pasting.named<QLabel>("Files of the camera")->text(), QStringLiteral("a.txt\nb.txt"));
        QVERIFY(!pasting.text()->isVisible());
        pasting.button("Type instead")->click();
        QVERIFY(pasting.text()->isVisible() && pasting.text()->toPlainText().isEmpty());
        pasting.dialog->readFiles({written(folder, QStringLiteral("c.bin"), QByteArray("a\0b", 3))});
        QVERIFY(!pasting.text()->isVisible() && pasting.says("No camera yet"));
        pasting.dialog->readFiles({std::filesystem::path(folder.filePath(QStringLiteral("none")).toStdU16String())});
        QVERIFY(pasting.says("cannot be read"));
        const auto large = written(folder, QStringLiteral("large.yml"), {});
        QVERIFY(QFile::resize(QString::fromStdU16String(large.u16string()), qint64(kMostCameraBytes) + 1));
        pasting.dialog->readFiles({large});
        QVERIFY(pasting.says("larger than 256 MiB"));
        // A file with matrices is read as matrices.
        pasting.dialog->readFiles(
            {written(folder, QStringLiteral("m.txt"), "2 0 0 0  0 2 0 0  0 0 -1.1 -1  0 0 -2.1 0")});
        QVERIFY(pasting.says("The scene's view is kept") || pasting.says("the scene's view is kept"));
        QVERIFY(pasting.ok()->isEnabled());
    }

    /// Without a size they are not taken as plain matrices: the dialog asks for the size.
    void unitysMatricesAreUnitys()
    {
        const QTemporaryDir folder;
        for (const QString &text : {kUnityView + kUnityLens, kUnityLens + kUnityView}) {
            for (const bool isFile : {false, true}) {
                Pasting pasting;
                if (isFile)
                    pasting.dialog->readFiles({written(folder, QStringLiteral("u.txt"), text.toUtf8())});
                else
                    pasting.paste(text);
                QVERIFY(pasting.says("Camera of Unity") && !pasting.ok()->isEnabled());
                QVERIFY(pasting.says("size of the image is not given; give it with “Image size”"));
                pasting.type("Image size", "640 x 480");
                pasting.ok()->click();
                const glm::dvec3 eye = pasting.document.setup().camera().eye.coordinates();
                QVERIFY(glm::distance(eye, {0.15, 0.25, 0.45}) < 1e-9);
            }
        }
    }

    void filesOpenedOneByOneJoin()
    {
        const QTemporaryDir folder;
        const auto images = written(folder, QStringLiteral("images.txt"), "1 1 0 0 0 0 0 5 1 a.png\n\n"),
                   cameras = written(folder, QStringLiteral("cameras.txt"), "1 PINHOLE 640 480 500 510 320 240\n"),
                   other = written(folder, QStringLiteral("other.txt"), krt().toUtf8());
        for (const bool areImagesFirst : {true, false}) {
            Pasting pasting;
            pasting.dialog->readFiles({areImagesFirst ? images : cameras});
            QVERIFY(!pasting.ok()->isEnabled());
            QVERIFY(pasting.says(areImagesFirst ? "give cameras.txt" : "give images.txt"));
            pasting.dialog->readFiles({areImagesFirst ? cameras : images});
            QVERIFY(pasting.ok()->isEnabled() && pasting.says("Camera of COLMAP"));
            const QString names = pasting.named<QLabel>("Files of the camera")->text();
            QVERIFY(names.contains("images.txt") && names.contains("cameras.txt"));
            // A whole camera replaces them.
            pasting.dialog->readFiles({other});
            QCOMPARE(pasting.named<QLabel>("Files of the camera")->text(), QStringLiteral("other.txt"));
        }
    }

    void blendersMatrixNeedsItsName()
    {
        Pasting pasting;
        const QString matrix = QStringLiteral("<Matrix 4x4 (1.0, 0.0, 0.0, 0.5)\n            (0.0, 1.0, 0.0, 0.7)\n"
                                              "            (0.0, 0.0, 1.0, 9.0)\n            (0.0, 0.0, 0.0, 1.0)>");
        pasting.paste(matrix);
        QVERIFY(pasting.says("write “matrix_world =” before it"));
        // What it says is right.
        pasting.paste("matrix_world = " + matrix + "\nlens = 50\n");
        QVERIFY(!pasting.ok()->isEnabled()); // the size is asked for
        pasting.type("Image size", "640 x 480");
        QVERIFY(pasting.says("Camera of Blender") && pasting.ok()->isEnabled());
    }

    void theReportSaysWhatIsSeen()
    {
        Pasting pasting;
        pasting.paste(krt());
        QVERIFY(pasting.says("The objects are in the image."));
        pasting.type("Far", "5000");
        pasting.type("Near", "1000");
        QVERIFY(pasting.says("Nothing will be seen: the objects are"));
        pasting.type("Near", "0.1");
        pasting.type("Far", "0.2");
        QVERIFY(pasting.says("Nothing will be seen: the objects are"));
        pasting.paste("gluLookAt(30, 20, 50, 60, 40, 100, 0, 1, 0)");
        QVERIFY(pasting.says("Nothing will be seen: no object is in the image."));
    }

    void nothingIsCut_data()
    {
        addColumn<double>("points");
        addColumn<bool>("isChinese");
        for (const double points : {9.0, 13.0}) {
            for (const bool isChinese : {false, true})
                addRow("%g pt, %s", points, isChinese ? "Chinese" : "English") << points << isChinese;
        }
    }

    void nothingIsCut()
    {
        QFETCH(double, points);
        QFETCH(bool, isChinese);
        const QFont before = QApplication::font();
        QFont font = before;
        font.setPointSizeF(points);
        QApplication::setFont(font);
        const Translation translation(isChinese ? QStringList{QStringLiteral("zh-CN")} : QStringList());
        const auto back = qScopeGuard([&before] { QApplication::setFont(before); });
        Pasting pasting;
        for (const QString &text : {krt() + QStringLiteral("dist = [0.1, -0.02, 0.001, 0, 0]\n"), kUnityLens}) {
            pasting.paste(text);
            QTRY_VERIFY2_WITH_TIMEOUT(cutTexts(*pasting.dialog).isEmpty(),
                                      qPrintable(cutTexts(*pasting.dialog).join('\n')), kPatienceMilliseconds);
        }
        QVERIFY(pasting.dialog->width() <= 1280 && pasting.dialog->height() <= 800);
    }
};

UNPROJECTOR_TEST(TestPasteCamera, display)
#include "test_paste_camera.moc"
