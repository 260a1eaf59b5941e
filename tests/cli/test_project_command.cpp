// `unproject project`: the way forward, as a script runs it.

#include "tests/support/test.h"

#include "tests/cli/command.h"

#include <algorithm>
#include <cmath>

namespace {

const QByteArray kHeader = "x,y,z,eye_x,eye_y,eye_z,clip_x,clip_y,clip_z,clip_w,ndc_x,ndc_y,ndc_z,window_x,window_y,"
                           "window_z,widget_x,widget_y,px,py,depth";

/// A camera that looks askew from (31.7, -12.3, 55.1).
QByteArray askew(const QByteArray &projection, const QByteArray &depthRange)
{
    return R"({"unprojector": 1, "window": {"width": 801, "height": 599}, "depthRange": )" + depthRange
           + ", \"projection\": " + projection
           + R"(, "view": {"eye": [31.7, -12.3, 55.1], "center": [1, 2, 3], "up": [0.1, 1, 0.3]}})";
}

const char *const kFrustum =
    R"({"type": "frustum", "left": -0.1, "right": 0.13, "bottom": -0.07, "top": 0.11, "near": 0.1, "far": 1234.5})";

} // namespace

class TestProjectCommand : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { m_scene = m_folder.write("scene.json", kFrustumScene); }

    void literalStages_data()
    {
        QTest::addColumn<QByteArray>("row");
        QTest::newRow("near plane, top-right corner")
            << QByteArray("1,0.75,4,1,0.75,-1,1,1,-1,1,1,1,-1,800,600,0,800,0,800,0,0");
        QTest::newRow("far plane, centre") << QByteArray("0,0,1,0,0,-4,0,0,4,4,0,0,1,400,300,1,400,300,400,300,1");
        QTest::newRow("behind the eye") << QByteArray(
            "1,0,6,1,0,1,1,0,-4.333333333333334,-1,-1,-0,4.333333333333334,0,300,"
            "2.666666666666667,0,300,0,300,2.666666666666667");
    }

    void literalStages()
    {
        QFETCH(QByteArray, row);
        const QList<QByteArray> cells = row.split(',');
        const Run run = runCommand({"project", m_scene}, "x,y,z\n" + cells.mid(0, 3).join(',') + '\n');
        VERIFY_SUCCEEDED(run);
        QCOMPARE(run.lines().at(0), kHeader);
        const QList<QByteArray> written = run.lines().at(1).split(',');
        QCOMPARE(written.size(), cells.size());
        for (int k = 0; k < cells.size(); ++k)
            QVERIFY2(std::abs(written[k].toDouble() - cells[k].toDouble()) <= 1e-12, written[k].constData());
    }

    void aPixelRatioDividesTheWidget()
    {
        QByteArray text = kFrustumScene;
        text.replace("\"height\": 600}", "\"height\": 600, \"devicePixelRatio\": 2}");
        const QString scene = m_folder.write("dense.json", text);
        const Run run = runCommand({"project", scene}, "x,y,z\n1,0.75,1\n");
        const QList<QByteArray> cells = run.lines().at(1).split(',');
        QCOMPARE(cells.mid(13, 2), (QList<QByteArray>{"1000", "750"}));               // window
        QCOMPARE(cells.mid(16, 4), (QList<QByteArray>{"500", "225", "1000", "450"})); // widget, device
    }

    void backwardOfForwardIsThePoint()
    {
        const Run forward = runCommand({"project", m_scene}, "x,y,z\n0.25,-0.5,2\n");
        const Run back = runCommand({"points", m_scene}, forward.output);
        QCOMPARE(back.exitCode, 0);
        const QList<QByteArray> cells = back.lines().at(1).split(',');
        const double expected[] = {0.25, -0.5, 2.0};
        for (int k = 0; k < 3; ++k)
            QVERIFY(std::abs(cells[kHeader.count(',') + 1 + k].toDouble() - expected[k]) <= 1e-14);
    }

    void pointsOnThePlanesComeBack_data()
    {
        QTest::addColumn<QByteArray>("projection");
        QTest::addColumn<QByteArray>("depthRange");
        QTest::newRow("frustum") << QByteArray(kFrustum) << QByteArray("[0, 1]");
        QTest::newRow("frustum, reversed depths") << QByteArray(kFrustum) << QByteArray("[1, 0]");
        QTest::newRow("frustum, part of the depths") << QByteArray(kFrustum) << QByteArray("[0.1, 0.3]");
        QTest::newRow("thin box") << QByteArray(
            R"({"type": "ortho", "left": -1, "right": 1.3, "bottom": -0.7, "top": 1.1, "near": 54.3, "far": 56.1})")
                                  << QByteArray("[0, 1]");
    }

    /// Points of a tilted camera, on its planes as exactly as doubles allow: rounding puts many depths
    /// outside.
    void pointsOnThePlanesComeBack()
    {
        QFETCH(QByteArray, projection);
        QFETCH(QByteArray, depthRange);
        const QString scene = m_folder.write("askew.json", askew(projection, depthRange));
        const QByteArray ends = depthRange.mid(1, depthRange.size() - 2);
        QByteArray pixels("px,py,depth\n");
        for (const QByteArray &end : {ends.split(',').first(), ends.split(',').last()}) {
            for (int i = 0; i < 500; ++i)
                pixels += QByteArray::number(i * 1.61) + ',' + QByteArray::number(i * 1.17) + ',' + end + '\n';
        }
        const Run planes = runCommand({"points", "--method", "formula", scene}, pixels);
        QCOMPARE(planes.exitCode, 0);
        const Run forward = runCommand({"project", scene}, QByteArray(planes.output).replace("formula_", ""));
        QCOMPARE(forward.exitCode, 0);
        const double low = std::min(ends.split(',').first().toDouble(), ends.split(',').last().toDouble());
        const double high = std::max(ends.split(',').first().toDouble(), ends.split(',').last().toDouble());
        int outside = 0; // by window_z, which is as it was computed
        for (const QByteArray &line : forward.lines().mid(1)) {
            const double windowDepth = line.split(',').at(15).toDouble();
            outside += windowDepth < low || windowDepth > high ? 1 : 0;
        }
        QVERIFY2(outside > 10, QByteArray::number(outside));
        const Run back = runCommand({"points", scene}, forward.output);
        QCOMPARE(back.errors, QByteArray());
        QCOMPARE(back.exitCode, 0);
    }

    void pointsOutsideStayOutside_data()
    {
        QTest::addColumn<QByteArray>("scene");
        QTest::addColumn<QByteArray>("row");
        QTest::newRow("before the near plane") << kFrustumScene << QByteArray("0,0,4.000000001");
        QTest::newRow("before the near plane, by little") << kFrustumScene << QByteArray("0,0,4.0000000000001");
        QTest::newRow("behind the far plane") << kFrustumScene << QByteArray("0,0,0.999999999");
        QTest::newRow("behind the far plane, by little") << kFrustumScene << QByteArray("0.5,0.25,0.9999999999995");
        QTest::newRow("behind the eye") << kFrustumScene << QByteArray("0,0,6");
        // w is what rounding left of it, the depth anything.
        QTest::newRow("in the plane of the eye") << askew(kFrustum, "[0, 1]") << QByteArray("46,18.4,55.1");
        QTest::newRow("in the plane of the eye, elsewhere")
            << askew(kFrustum, "[0, 1]") << QByteArray("31.7,39.8,69.4");
    }

    void pointsOutsideStayOutside()
    {
        QFETCH(QByteArray, scene);
        QFETCH(QByteArray, row);
        const QString file = m_folder.write("outside.json", scene);
        const Run forward = runCommand({"project", file}, "x,y,z\n" + row + '\n');
        const Run back = runCommand({"points", file}, forward.output);
        QCOMPARE(back.exitCode, 1);
        QVERIFY2(back.errors.contains("lies outside the depth range 0 to 1") || forward.exitCode == 1,
                 back.errors.constData());
    }

    void badRowsAreNamed_data()
    {
        QTest::addColumn<QByteArray>("row");
        QTest::addColumn<int>("cells");
        QTest::addColumn<QByteArray>("message");
        QTest::newRow("in the plane of the eye")
            << QByteArray("1,2,5") << 10 << QByteArray("stdin:2: the point has no window position");
        QTest::newRow("overflow") << QByteArray("1,1.7e308,0") << 6
                                  << QByteArray("stdin:2: the point has no window position");
        QTest::newRow("text") << QByteArray("1,2,c") << 3 << QByteArray("stdin:2:5: z: \"c\" is not a number");
    }

    void badRowsAreNamed()
    {
        QFETCH(QByteArray, row);
        QFETCH(int, cells);
        QFETCH(QByteArray, message);
        const Run run = runCommand({"project", m_scene}, "x,y,z\n" + row + "\n0,0,1\n");
        QCOMPARE(run.exitCode, 1);
        QCOMPARE(run.lines().size(), 3);
        const QList<QByteArray> written = run.lines().at(1).split(',');
        QCOMPARE(written.size(), kHeader.count(',') + 1);
        for (int k = 0; k < written.size(); ++k)
            QCOMPARE(written[k].isEmpty(), k >= cells);
        QVERIFY2(run.errors.startsWith(message), run.errors.constData());
    }

    void objectsOwnCoordinates()
    {
        const Run object = runCommand({"project", "--space", "object:face", m_scene}, "x,y,z\n0.5,0.375,0.5\n");
        const Run world = runCommand({"project", m_scene}, "x,y,z\n1,0.75,4\n");
        QCOMPARE(object.lines().at(1).mid(sizeof("0.5,0.375,0.5,") - 1),
                 world.lines().at(1).mid(sizeof("1,0.75,4,") - 1));
        const Run eye = runCommand({"project", "--space", "eye", m_scene}, "x,y,z\n1,0.75,-1\n");
        QCOMPARE(eye.lines().at(1).mid(sizeof("1,0.75,-1,") - 1), world.lines().at(1).mid(sizeof("1,0.75,4,") - 1));
        const Run clip = runCommand({"project", "--space", "clip", m_scene}, "x,y,z\n");
        QCOMPARE(clip.errors, QByteArray("--space clip: give world, eye or object:NAME\n"));
        QCOMPARE(clip.exitCode, 2);
    }

    /// An object that lies far away in its own space is moved to where the camera looks. The sum of
    /// both is exact in a double here, so the world point shows the digits.
    void objectsFarAwayKeepTheirPixels()
    {
        QByteArray text = askew(kFrustum, "[0, 1]");
        text.replace("\"view\"", R"("objects": [{"name": "far", "file": "face.obj",
                                "transform": [{"translate": [-150000000, 149999999.75, -1.25e8]}]}], "view")");
        const QString scene = m_folder.write("far.json", text);
        QByteArray inObject("x,y,z\n"), inWorld("x,y,z\n");
        for (int i = 0; i < 200; ++i) {
            const double x = i / 16.0 - 5.0, y = i / 32.0 - 2.5, z = 3.0 - i / 64.0;
            const auto number = [](double value) { return QByteArray::number(value, 'g', 17); };
            inWorld += number(x) + ',' + number(y) + ',' + number(z) + '\n';
            inObject += number(x + 150000000.0) + ',' + number(y - 149999999.75) + ',' + number(z + 1.25e8) + '\n';
        }
        const Run object = runCommand({"project", "--space", "object:far", scene}, inObject);
        const Run world = runCommand({"project", scene}, inWorld);
        QCOMPARE(object.exitCode, 0);
        QCOMPARE(object.lines().size(), qsizetype(201));
        for (qsizetype i = 1; i < object.lines().size();
             ++i) // all but the point, and the depth, which knows its uncertainty
            QCOMPARE(object.lines()[i].split(',').mid(3, 17), world.lines()[i].split(',').mid(3, 17));
    }

    void jsonLines()
    {
        const Run run = runCommand({"project", "--format", "jsonl", m_scene}, "x,y,z\n1,2,5\n");
        QVERIFY(run.output.startsWith("{\"x\":1,\"y\":2,\"z\":5,\"eye_x\":1,\"eye_y\":2,"));
        QVERIFY(run.output.endsWith("\"px\":null,\"py\":null,\"depth\":null}\n"));
    }

private:
    Folder m_folder;
    QString m_scene;
};

UNPROJECTOR_TEST(TestProjectCommand, threads)
#include "test_project_command.moc"
