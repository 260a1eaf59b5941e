// `unproject scene --from-matrices`, as a script runs it.

#include "tests/support/test.h"

#include "tests/cli/command.h"

#include <cmath>

namespace {

// gluLookAt(0,0,5, 0,0,0, 0,1,0) and glFrustum(-1,1,-1,1,1,3), as glGetDoublev gives them.
const QByteArray kModelview = "1 0 0 0  0 1 0 0  0 0 1 0  0 0 -5 1";
const QByteArray kProjection = "1 0 0 0  0 1 0 0  0 0 -2 -1  0 0 -3 0";
const QByteArray kViewport = "0 0 400 300";

} // namespace

class TestSceneCommand : public QObject {
    Q_OBJECT

private slots:
    void whatMatricesPrintsIsTaken_data()
    {
        addColumn<QString>("format");
        addColumn<QString>("conventions");
        const auto add = [](const char *format, const char *conventions) {
            addRow("%s, %s", format, conventions) << format << conventions;
        };
        for (const char *format : {"text", "c", "numpy", "json", "latex"}) {
            add(format, "opengl");
            add(format, "direct3d");
        }
        // All conventions but OpenCV's, which are R, t and K.
        for (const char *conventions : {"vulkan", "metal", "webgpu", "threejs", "unity", "opencascade"})
            add("text", conventions);
    }

    void whatMatricesPrintsIsTaken()
    {
        QFETCH(QString, format);
        QFETCH(QString, conventions);
        // Depths from 0.3 to 1.
        const QByteArray numbers = "modelview 0.8 0 0.6 0  0 1 0 0  -0.6 0 0.8 0  1e-9 0 -5 1 projection " + kProjection
                                   + " viewport 200 0 0 0  0 150 0 0  0 0 0.35 0  210 170 0.65 1";
        const QByteArray none = R"("objects": [])",
                         two = "\"objects\": [{\"name\": \"a\", \"bundled\": \"cube\"}, {\"name\": \"face (2)\", "
                               "\"bundled\": \"cube\"}, {\"name\": \"[3 f\", \"bundled\": \"cube\"}]";
        const Run scene = runCommand({"scene", "--window", "500x400", "--from-matrices", "-"}, numbers);
        QCOMPARE(scene.exitCode, 0);
        QByteArray withObjects = scene.output;
        QVERIFY(withObjects.contains(none));
        withObjects.replace(none, two);
        const QString points = "px,py,depth\n20,90,0.3\n400,300,0.75\n";
        const auto unprojected = [&](const QByteArray &text) {
            QList<double> world;
            for (const QByteArray &line :
                 runCommand({"points", m_folder.write("taken.json", text)}, points.toUtf8()).lines().mid(1)) {
                for (const QByteArray &cell : line.split(',').mid(0, 9))
                    world << cell.toDouble();
            }
            return world;
        };
        const QList<double> expected = unprojected(scene.output);
        QCOMPARE(expected.size(), 18);
        for (const QByteArray &text : {scene.output, withObjects}) {
            const Run matrices = runCommand(
                {"matrices", "--format", format, "--conventions", conventions, m_folder.write("printed.json", text)});
            QCOMPARE(matrices.exitCode, 0);
            const Run again =
                runCommand({"scene", "--conventions", conventions, "--window", "500x400", "--from-matrices", "-"},
                           matrices.output);
            QVERIFY2(again.errors.contains("product: ignored"), again.errors.constData());
            const QList<double> found = unprojected(again.output);
            QCOMPARE(found.size(), expected.size());
            for (qsizetype i = 0; i < found.size(); ++i)
                QVERIFY2(std::abs(found[i] - expected[i]) <= 1e-12, again.output.constData());
            QVERIFY(again.output.contains("\"viewport\": {\"x\": 10, \"y\": 20, \"width\": 400, \"height\": 300}"));
        }
        // The default conventions give the same, to the last digit.
        const Run plain = runCommand({"matrices", "--format", format, m_folder.write("plain.json", withObjects)});
        QCOMPARE(runCommand({"scene", "--window", "500x400", "--from-matrices", "-"}, plain.output).output,
                 scene.output);
    }

private:
    Folder m_folder;
};

UNPROJECTOR_TEST(TestSceneCommand)
#include "test_scene_command.moc"
