// `unproject scene` with cameras of other programs, and --distortion, as a script runs them.

#include "tests/support/test.h"

#include "core/cameras/foreign_camera.h"
#include "tests/cli/command.h"
#include "tests/core/cameras/opencv_camera.h"

#include <QFile>
#include <QFileInfo>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include <algorithm>
#include <cmath>

namespace {

const QByteArray kK = "K = [[800, 0, 319.5], [0, 800, 239.5], [0, 0, 1]]\nwidth: 640\nheight: 480\n";
const QByteArray kUnit = "OFF\n8 12 0\n-1 -1 -1\n1 -1 -1\n1 1 -1\n-1 1 -1\n-1 -1 1\n1 -1 1\n1 1 1\n-1 1 1\n"
                         "3 0 2 1\n3 0 3 2\n3 4 5 6\n3 4 6 7\n3 0 1 5\n3 0 5 4\n3 1 2 6\n3 1 6 5\n3 2 3 7\n3 2 7 6\n"
                         "3 3 0 4\n3 3 4 7\n";

QByteArray worldPoints()
{
    QByteArray rows = "x,y,z\n";
    for (const auto &point : opencv_camera::kProjected)
        rows += QByteArray::number(point.world.x, 'g', 17) + ',' + QByteArray::number(point.world.y, 'g', 17) + ','
                + QByteArray::number(point.world.z, 'g', 17) + '\n';
    return rows;
}

/// The greatest distance of px and py from the pixels of cv2.projectPoints.
double largestMiss(const Run &projected, bool isDistorted)
{
    const QList<QByteArray> names = projected.lines().value(0).split(',');
    double largest = projected.lines().size() == std::ssize(opencv_camera::kProjected) + 1 ? 0.0 : 1e300;
    for (int row = 1; row < projected.lines().size(); ++row) {
        const QList<QByteArray> cells = projected.lines().at(row).split(',');
        const auto &point = opencv_camera::kProjected[row - 1];
        const glm::dvec2 &expected = isDistorted ? point.distorted : point.pixel;
        largest = std::max({largest, std::abs(cells.value(names.indexOf("px")).toDouble() - 0.5 - expected.x),
                            std::abs(cells.value(names.indexOf("py")).toDouble() - 0.5 - expected.y)});
    }
    return largest;
}

} // namespace

class TestCameraScenes : public QObject {
    Q_OBJECT

private slots:
    void filesAreRecognisedByTheirContents_data()
    {
        QTest::addColumn<QStringList>("arguments");
        QTest::addColumn<QByteArray>("input");
        const QString yaml = m_folder.write("a.dat", opencv_camera::kYaml),
                      xml = m_folder.write("b", opencv_camera::kXml);
        QTest::newRow("a file") << QStringList{yaml} << QByteArray();
        QByteArray wide("\xff\xfe");
        for (const char c : QByteArray(opencv_camera::kYaml))
            wide += QByteArray(1, c) + '\0';
        QTest::newRow("UTF-16") << QStringList{m_folder.write("wide.yml", wide)} << QByteArray();
        QTest::newRow("--from") << QStringList{"--from", xml} << QByteArray();
        QTest::newRow("stdin") << QStringList{"-"} << QByteArray(opencv_camera::kNumPy);
        QTest::newRow("the text itself") << QStringList{"--from", opencv_camera::kReprs} << QByteArray();
        QTest::newRow("--from-matrices") << QStringList{"--from-matrices", "-"} << QByteArray(opencv_camera::kCpp);
    }

    void filesAreRecognisedByTheirContents()
    {
        QFETCH(QStringList, arguments);
        QFETCH(QByteArray, input);
        const Run scene = runCommand(QStringList{"scene"} + arguments, input);
        QVERIFY2(
            scene.errors.contains("Near 0.1 and far 1000 are assumed, because the file has none; --near and --far say "
                                  "otherwise.\n"),
            scene.errors.constData());
        QCOMPARE(scene.exitCode, 0);
        const Run projected = runCommand({"project", m_folder.write("s.json", scene.output), "-"}, worldPoints());
        QCOMPARE(projected.errors, QByteArray());
        QVERIFY(largestMiss(projected, false) <= 1e-10);
    }

    void whatMatricesPrintsForOpenCvIsTaken()
    {
        const Run scene =
            runCommand({"scene", m_folder.write("c.yml", opencv_camera::kYaml), "--pose", "world-to-camera"});
        const QString file = m_folder.write("first.json", scene.output);
        for (const char *format : {"text", "numpy", "c", "json"}) {
            const Run printed = runCommand({"matrices", file, "--conventions", "opencv", "--format", format});
            const Run again =
                runCommand({"scene", "-", "--size", "640x480", "--pose", "world-to-camera"}, printed.output);
            QVERIFY2(again.exitCode == 0, again.errors + printed.output);
            const Run projected =
                runCommand({"project", m_folder.write("again.json", again.output), "-"}, worldPoints());
            QVERIFY2(largestMiss(projected, false) <= 1e-3, format);
        }
    }

    /// The objects decide the direction; the scene has them, so `pick` meets them.
    void callsAreTaken()
    {
        const QByteArray calls = "gluLookAt(0, 0, 5, 0, 0, 0, 0, 1, 0);\ngluPerspective(90, 1, 1, 9);\n";
        const Run made = runCommand({"scene", "--from-matrices", "-"}, calls + "glViewport(0, 0, 200, 200);");
        QCOMPARE(made.exitCode, 0);
        QVERIFY2(made.errors.contains("gluLookAt: eye (0, 0, 5)"), made.errors);
        const QString scene = m_folder.write("calls.json", made.output);
        const Run projected = runCommand({"project", scene, "-"}, "x,y,z\n1,2,0\n"); // 20 pixels a unit
        QCOMPARE(projected.exitCode, 0);
        const QList<QByteArray> names = projected.lines().value(0).split(','),
                                cells = projected.lines().value(1).split(',');
        QVERIFY(std::abs(cells.value(names.indexOf("px")).toDouble() - 120.0) < 1e-9);
        QVERIFY(std::abs(cells.value(names.indexOf("py")).toDouble() - 60.0) < 1e-9);
        // The size may come from an option; without it, the viewport is missing.
        QCOMPARE(runCommand({"scene", "--from-matrices", "-", "--window", "200x200"}, calls).exitCode, 0);
        const Run without = runCommand({"scene", "--from-matrices", "-"}, calls);
        QVERIFY(without.exitCode != 0);
        QVERIFY2(without.errors.contains("viewport: 0 numbers found, 4 are needed"), without.errors);
        // --order is for numbers.
        const Run ordered =
            runCommand({"scene", "--from-matrices", "-", "--order", "row"}, calls + "glViewport(0, 0, 200, 200);");
        QCOMPARE(ordered.output, made.output);
    }

    /// One program with two files, one with an image chosen, one without a size.
    void otherProgramsAreTaken()
    {
        const QString cameras = m_folder.write("cameras.txt", "1 SIMPLE_PINHOLE 640 480 500 320 240\n");
        const QString images = m_folder.write("images.txt", "1 1 0 0 0 0 0 2 1 a.jpg\n\n2 1 0 0 0 0 0 4 1 b.jpg\n\n");
        const auto pixelOf = [this](const Run &made) {
            const Run projected =
                runCommand({"project", m_folder.write("made.json", made.output), "-"}, "x,y,z\n1,0.5,0\n");
            const QList<QByteArray> names = projected.lines().value(0).split(','),
                                    cells = projected.lines().value(1).split(',');
            return cells.value(names.indexOf("px")) + ' ' + cells.value(names.indexOf("py"));
        };
        const Run first = runCommand({"scene", cameras, images}),
                  second = runCommand({"scene", cameras, images, "--image", "b.jpg"});
        QVERIFY2(first.exitCode == 0, first.errors);
        QVERIFY2(first.errors.contains("The first of 2 images is read, a.jpg"), first.errors);
        QCOMPARE(pixelOf(first), QByteArray("570 365"));
        QCOMPARE(pixelOf(second), QByteArray("445 302.5"));
        QVERIFY(!second.errors.contains("The first of"));
        const QByteArray unreal = "Location X=0 Y=0 Z=0\nRotation P=0 Y=0 R=0\nFOV 90\n";
        const Run without = runCommand({"scene", "-"}, unreal),
                  with = runCommand({"scene", "-", "--size", "200x200"}, unreal);
        QVERIFY(without.exitCode != 0);
        QVERIFY2(without.errors.contains("--size 800x600"), without.errors);
        QVERIFY2(with.exitCode == 0, with.errors);
        QVERIFY2(with.errors.contains("(x, -y, z) here"), with.errors);
    }

    void objectsDecideAndAreInTheScene()
    {
        const QString model = m_folder.write("unit.off", kUnit), scene = m_folder.path("with.json");
        const Run run = runCommand({"scene", "-", "--objects", model, "-o", scene},
                                   kK + "R = [[1, 0, 0], [0, 1, 0], [0, 0, 1]]\nt = [0, 0, -5]\n");
        QVERIFY2(run.errors.contains("stdin: The pose is read as camera-to-world, because only this reading shows the "
                                     "objects; --pose says otherwise.\n"),
                 run.errors.constData());
        QCOMPARE(run.exitCode, 0);
        const Run picked = runCommand({"pick", scene, "--at", "320,240", "--json"});
        const QJsonObject pick = QJsonDocument::fromJson(picked.output).object();
        QVERIFY2(picked.output.contains("unit.off"), picked.output + picked.errors);
        QVERIFY2(!pick.isEmpty(), picked.output);
        // Another scene's objects go into this one.
        const Run second = runCommand({"scene", "-", "--objects", scene},
                                      kK + "R = [[1, 0, 0], [0, 1, 0], [0, 0, 1]]\nt = [0, 0, 5]\n");
        QVERIFY2(second.output.contains("unit.off"), second.errors + second.output);
        QVERIFY(second.errors.contains("the objects are in the image"));
        // Scenes of matrices take objects too.
        const Run matrices =
            runCommand({"scene", "--from-matrices", "-", "--objects", model},
                       "1 0 0 0 0 1 0 0 0 0 1 0 0 0 -5 1 1 0 0 0 0 1 0 0 0 0 -2 -1 0 0 -3 0 0 0 40 30");
        QVERIFY2(matrices.output.contains("unit.off"), matrices.errors + matrices.output);
    }

    void optionsSayOtherwise()
    {
        const QByteArray text = kK + "c2w = [[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 5], [0, 0, 0, 1]]\n";
        const auto pixelOfOrigin = [&](const QStringList &options) {
            const Run scene = runCommand(QStringList{"scene", "-"} + options, text);
            const Run run = runCommand({"project", m_folder.write("o.json", scene.output), "-"}, "x,y,z\n0.5,0,0\n");
            const QList<QByteArray> cells = run.lines().value(1).split(',');
            const QList<QByteArray> names = run.lines().value(0).split(',');
            return cells.value(names.indexOf("px")) + ' ' + cells.value(names.indexOf("eye_z"));
        };
        QCOMPARE(pixelOfOrigin({"--axes", "opengl"}), QByteArray("400 -5"));
        QCOMPARE(pixelOfOrigin({"--axes", "opengl", "--pixel-centers", "half"}), QByteArray("399.5 -5"));
        QCOMPARE(pixelOfOrigin({"--axes", "opencv", "--pose", "world-to-camera"}), QByteArray("400 -5"));
        const Run scene =
            runCommand({"scene", "-", "--axes", "opengl", "--near", "2", "--far", "8", "--size", "640x400"}, text);
        QCOMPARE(scene.errors, QByteArray("stdin: The image is 640x400, as --size says; the file says 640x480.\n"));
        const QJsonObject json = QJsonDocument::fromJson(scene.output).object();
        QCOMPARE(json["window"].toObject()["height"].toInt(), 400);
        QVERIFY(json["window"].toObject()["fixed"].toBool());
        const QJsonObject projection = json["projection"].toObject();
        QCOMPARE(projection["near"].toDouble(), 2.0);
        QCOMPARE(projection["far"].toDouble(), 8.0);
        const Run ignored = runCommand({"scene", "--from-matrices", "-", "--near", "2"},
                                       "1 0 0 0 0 1 0 0 0 0 1 0 0 0 -5 1 1 0 0 0 0 1 0 0 0 0 -2 -1 0 0 -3 0 0 0 40 30");
        QVERIFY2(ignored.errors.contains("are ignored"), ignored.errors);
    }

    void aLensIsRefusedWithTheWayOut()
    {
        const QString camera = m_folder.write("lens.yml", opencv_camera::kLensYaml);
        const Run run = runCommand({"scene", camera});
        QCOMPARE(run.exitCode, 2);
        QCOMPARE(run.output, QByteArray());
        for (const char *said :
             {"k1 = -0.28, k2 = 0.11, p1 = 0.0012, p2 = -7e-04, k3 = 0.02", "--undistorted", "--distortion"})
            QVERIFY2(run.errors.contains(said), run.errors.constData());
        const Run dropped = runCommand({"scene", camera, "--undistorted"});
        QCOMPARE(dropped.exitCode, 0);
        QVERIFY2(dropped.errors.contains("The distortion coefficients are dropped"), dropped.errors.constData());
    }

    /// project applies the lens as cv2.projectPoints does; points undoes it.
    void pixelsOfALensAreUndone()
    {
        const QString camera = m_folder.write("lens.yml", opencv_camera::kLensYaml), scene = m_folder.path("lens.json");
        QCOMPARE(runCommand({"scene", camera, "--undistorted", "--near", "2", "--far", "12", "-o", scene}).exitCode, 0);
        for (const QString &lens : {camera, QStringLiteral("-0.28,0.11,0.0012,-0.0007,0.02")}) {
            const Run projected = runCommand({"project", scene, "-", "--distortion", lens}, worldPoints());
            QCOMPARE(projected.errors, QByteArray());
            QVERIFY(largestMiss(projected, true) <= 1e-10);
            const Run points = runCommand({"points", scene, "-", "--distortion", lens}, projected.output);
            QCOMPARE(points.errors, QByteArray());
            const QList<QByteArray> names = points.lines().at(0).split(',');
            for (int row = 1; row < points.lines().size(); ++row) {
                const QList<QByteArray> cells = points.lines().at(row).split(',');
                const auto &world = opencv_camera::kProjected[row - 1].world;
                for (int k = 0; k < 3; ++k) {
                    const QByteArray name = QByteArray("formula_") + "xyz"[k];
                    QVERIFY(std::abs(cells.at(names.indexOf(name)).toDouble() - world[k]) <= 1e-9);
                }
            }
        }
        // Another K than the file's counts, and this is reported.
        const Run other = runCommand({"project", scene, "-", "--distortion", "-"}, worldPoints());
        QCOMPARE(other.exitCode, 2);
        const QString another = m_folder.write("other.txt", kK + "dist = -0.28 0.11 0.0012 -0.0007 0.02\n");
        const Run said = runCommand({"project", scene, "-", "--distortion", another}, worldPoints());
        QVERIFY2(said.errors.contains("its K (fx 800, fy 800, cx 319.5, cy 239.5) differs from the scene's"),
                 said.errors);
        QVERIFY(largestMiss(said, true) <= 1e-10);
    }

    void aLensAnswersOnlyWhereItCan()
    {
        const QString scene = m_folder.path("plain.json");
        QCOMPARE(
            runCommand({"scene", "-", "--near", "1", "--far", "9", "-o", scene}, kK + "rvec = 0 0 0\ntvec = 0 0 0\n")
                .exitCode,
            0);
        const Run points = runCommand({"points", scene, "-", "--distortion", "-0.5,0,0,0,0", "--pixel"},
                                      "px,py,depth\n319,239,0.5\n2000,239,0.5\n");
        QCOMPARE(points.exitCode, 1);
        QCOMPARE(points.errors, QByteArray("stdin:3:1: px: the distortion cannot be undone here: no position of the "
                                           "undistorted image has this pixel\n"));
        QVERIFY(points.lines().at(2).startsWith("2000,239,0.5,,"));
        const Run projected =
            runCommand({"project", scene, "-", "--distortion", "-0.5,0,0,0"}, "x,y,z\n0,0,2\n6,0,2\n");
        QCOMPARE(projected.exitCode, 1);
        QVERIFY2(projected.errors.contains("the distortion folds the image over"), projected.errors);
        QVERIFY(projected.lines().at(1).endsWith("320,240,0.5625"));
        QVERIFY(projected.lines().at(2).endsWith(",,,"));
    }

    /// The window has the same limit.
    void largeFilesAreRefused()
    {
        const QString file = m_folder.write("large.yml", {});
        QVERIFY(QFile::resize(file, qint64(unprojector::cameras::kMostCameraBytes) + 1));
        const Run scene = runCommand({"scene", file});
        QVERIFY2(scene.errors.contains("longer than 256 MiB; give the file of one camera"), scene.errors);
        QVERIFY(scene.exitCode != 0);
    }

    void badArgumentsAreNamed_data()
    {
        QTest::addColumn<QStringList>("arguments");
        QTest::addColumn<QByteArray>("message");
        const QString file = m_folder.write("k.txt", kK), scene = m_folder.path("bad.json");
        runCommand({"scene", file, "-o", scene});
        const auto inScene = [&](const QStringList &arguments) { return QStringList{"scene"} + arguments; };
        QTest::newRow("nothing given") << inScene({}) << QByteArray("FILE (or --from-matrices) is required");
        QTest::newRow("no such file") << inScene({m_folder.path("none.yml")})
                                      << m_folder.path("none.yml").toUtf8() + ": there is no such file\n";
        QTest::newRow("one of two is missing") << inScene({file, m_folder.path("none.yml")})
                                               << m_folder.path("none.yml").toUtf8() + ": there is no such file\n";
        QTest::newRow("another text") << inScene({m_folder.write("text.md", "Hello 1 2 3\n")})
                                      << QByteArray("no camera of a known program, and no matrices");
        QTest::newRow("a value with its line")
            << inScene({m_folder.write("bad.txt", "# c\nK = 1 2 3\n")})
            << QByteArray("bad.txt:2: K: it has 3 numbers; a camera matrix has nine, by rows\n");
        QTest::newRow("no such image") << inScene({file, "--image", "3"})
                                       << QByteArray("there is one camera without a name; leave --image out\n");
        QTest::newRow("axes") << inScene({file, "--axes", "left"})
                              << QByteArray("--axes: \"left\" is not one of direct3d, opencv, opengl, ros, unreal\n");
        QTest::newRow("near behind far") << inScene({file, "--near", "5", "--far", "2"})
                                         << QByteArray(
                                                "near is 5 and far is 2; near must be greater than 0 and smaller "
                                                "than far. Give --near and --far\n");
        QTest::newRow("no such model") << inScene({file, "--objects", m_folder.path("none.ply")})
                                       << QByteArray("none.ply: there is no such file");
        QTest::newRow("a model beside a camera") << inScene({file, m_folder.write("unit.off", kUnit)})
                                                 << QByteArray("unit.off: this is a model, not a camera; give it with "
                                                               "--objects\n");
        QTest::newRow("an option about matrices")
            << inScene({file, "--orthonormal"})
            << QByteArray("the text is of a camera, and --orthonormal is only about matrices; leave it out\n");
        QTest::newRow("over its input") << inScene({file, "-o", file}) << QByteArray("this is the input");
        QTest::newRow("lens: no numbers")
            << QStringList{"points", scene, "-", "--distortion", "1,a"}
            << QByteArray("--distortion 1,a: this is neither a file of a camera nor a list");
        QTest::newRow("lens: too few") << QStringList{"points", scene, "-", "--distortion", "1,2,3"}
                                       << QByteArray("there are 3 distortion coefficients; give four or five");
        QTest::newRow("lens: more than known") << QStringList{"project", scene, "-", "--distortion", "1,2,3,4,5,6,7,8"}
                                               << QByteArray("the distortion has k4 = 6, k5 = 7, k6 = 8");
        QTest::newRow("lens: none in the file") << QStringList{"points", scene, "-", "--distortion", file}
                                                << QByteArray("there are no distortion coefficients");
    }

    void badArgumentsAreNamed()
    {
        QFETCH(QStringList, arguments);
        QFETCH(QByteArray, message);
        const Run run = runCommand(arguments, "px,py,depth,x,y,z\n1,1,0.5,0,0,5\n");
        QVERIFY2(run.errors.contains(message), run.errors.constData());
        QCOMPARE(run.exitCode, 2);
        QCOMPARE(run.output, QByteArray());
    }

private:
    Folder m_folder;
};

UNPROJECTOR_TEST(TestCameraScenes)
#include "test_camera_scenes.moc"
