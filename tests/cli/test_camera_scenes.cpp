// `unproject scene` with cameras of other programs, and --distortion, as a script runs them.

#include "tests/support/test.h"

#include "core/cameras/foreign_camera.h"
#include "tests/cli/command.h"
#include "tests/core/cameras/opencv_camera.h"

#include <QFile>

#include <algorithm>
#include <cmath>

namespace {

const QByteArray kK = "K = [[800, 0, 319.5], [0, 800, 239.5], [0, 0, 1]]\nwidth: 640\nheight: 480\n";

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
        addColumn<QStringList>("arguments");
        addColumn<QByteArray>("input");
        const QString yaml = m_folder.write("a.dat", opencv_camera::kYaml),
                      xml = m_folder.write("b", opencv_camera::kXml);
        newRow("a file") << QStringList{yaml} << QByteArray();
        QByteArray wide("\xff\xfe");
        for (const char c : QByteArray(opencv_camera::kYaml))
            wide += QByteArray(1, c) + '\0';
        newRow("UTF-16") << QStringList{m_folder.write("wide.yml", wide)} << QByteArray();
        newRow("--from") << QStringList{"--from", xml} << QByteArray();
        newRow("stdin") << QStringList{"-"} << QByteArray(opencv_camera::kNumPy);
        newRow("the text itself") << QStringList{"--from", opencv_camera::kReprs} << QByteArray();
        newRow("--from-matrices") << QStringList{"--from-matrices", "-"} << QByteArray(opencv_camera::kCpp);
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

    /// The window has the same limit.
    void largeFilesAreRefused()
    {
        const QString file = m_folder.write("large.yml", {});
        QVERIFY(QFile::resize(file, qint64(unprojector::cameras::kMostCameraBytes) + 1));
        const Run scene = runCommand({"scene", file});
        QVERIFY2(scene.errors.contains("longer than 256 MiB; give the file of one camera"), scene.errors);
        QVERIFY(scene.exitCode != 0);
    }

private:
    Folder m_folder;
};

UNPROJECTOR_TEST(TestCameraScenes)
#include "test_camera_scenes.moc"
