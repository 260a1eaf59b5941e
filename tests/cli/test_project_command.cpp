// `unproject project`: the way forward, as a script runs it.

#include "tests/support/test.h"

#include "tests/cli/command.h"

#include <algorithm>
#include <cmath>

namespace {

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

    void pointsOnThePlanesComeBack_data()
    {
        addColumn<QByteArray>("projection");
        addColumn<QByteArray>("depthRange");
        newRow("frustum") << QByteArray(kFrustum) << QByteArray("[0, 1]");
        newRow("frustum, reversed depths") << QByteArray(kFrustum) << QByteArray("[1, 0]");
        newRow("frustum, part of the depths") << QByteArray(kFrustum) << QByteArray("[0.1, 0.3]");
        newRow("thin box") << QByteArray(
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

private:
    Folder m_folder;
    QString m_scene;
};

UNPROJECTOR_TEST(TestProjectCommand, threads)
#include "test_project_command.moc"
