// Clicks that the program prints: computed again from their JSON, by core and by the command, they
// are the same points.

#include "tests/support/test.h"

#include "core/scene_file/clicks.h"

#include "tests/gui/depth_ranges.h"
#include "tests/gui/program/program_run.h"
#include "tests/support/patience.h"
#include "tests/support/unprojecting.h"

#include <QFile>
#include <QTemporaryDir>

#include <cmath>

using namespace unprojector;
using namespace unprojector::geometry;
using namespace unprojector::scene_file;
using namespace unprojector::unproject;
using namespace program_run;

namespace {

glm::dvec3 vectorOf(const Json &json)
{
    return {json.at(0).get<double>(), json.at(1).get<double>(), json.at(2).get<double>()};
}

/// The setup to compute the click again, from the JSON alone: its scene is a scene file.
Setup clickedPicture(const Json &scene)
{
    return setupOf(parseScene(scene.dump(), "scene").value());
}

bool isExactly(const Json &json, const glm::dvec3 &expected)
{
    if (vectorOf(json) == expected)
        return true;
    qWarning("%s is not (%.17g, %.17g, %.17g)", json.dump().c_str(), expected.x, expected.y, expected.z);
    return false;
}

} // namespace

class TestScreenshotClicks : public QObject {
    Q_OBJECT

private slots:
    void theNumbersReadBackAndComputedAgainAreTheSame_data()
    {
        addColumn<QString>("factor");
        addColumn<QString>("smooth");
        addColumn<QString>("size");
        // Windows keeps a window on its screen, which may be 1280 x 1024.
        newRow("1x") << "1"
                     << "off"
                     << "900x640";
        newRow("1x, smooth edges") << "1"
                                   << "on"
                                   << "900x640";
        newRow("1.25x") << "1.25"
                        << "off"
                        << "900x640";
        newRow("1.5x") << "1.5"
                       << "off"
                       << "840x600";
        newRow("2x") << "2"
                     << "off"
                     << "700x560";
    }

    void theNumbersReadBackAndComputedAgainAreTheSame()
    {
        QFETCH(QString, factor);
        QFETCH(QString, smooth);
        QFETCH(QString, size);
        const double ratio = factor.toDouble();
        const Run result = run({"--screenshot", path("again.png"), "--size", size, "--smooth-edges", smooth, "--click",
                                "86,200", "--click", "91.4,187.7", "--click", "0,0"},
                               {"QT_SCALE_FACTOR=" + factor});
        QVERIFY2(result.hasExited && result.exitCode == 0, result.errors.constData());
        const Json clicks = Json::parse(result.output.toStdString(), nullptr, false);
        QCOMPARE(clicks.size(), std::size_t(3));
        for (const Json &click : clicks) {
            QCOMPARE(click["scene"]["window"]["devicePixelRatio"].get<double>(), ratio);
            const Setup g = clickedPicture(click["scene"]);
            QCOMPARE(double(g.surface.widthPixels), g.viewport.width);
            QCOMPARE(double(g.surface.heightPixels), g.viewport.height);
            // The pixel and its centre, by hand.
            const double x = click["widget"][0].get<double>() * ratio, y = click["widget"][1].get<double>() * ratio;
            QCOMPARE(click["devicePixel"][0].get<int>(), int(std::floor(x + 1e-6)));
            QCOMPARE(click["devicePixel"][1].get<int>(), int(std::floor(y + 1e-6)));
            const WindowPoint window(vectorOf(click["window"]));
            QVERIFY(window.x == std::floor(x + 1e-6) + 0.5);
            QVERIFY(window.y == g.viewport.height - std::floor(y + 1e-6) - 0.5);
            QVERIFY(window.z >= 0.0 && window.z <= 1.0);
            const auto isSame = [&](const Json &eye, const Json &world, double depth) {
                const Unprojected again = unprojectedAt(g, WindowPoint(window.x, window.y, depth));
                bool isSameByAll = true;
                for (const Method method : kMethods)
                    isSameByAll = isExactly(eye[keyOf(method)], again.eye[method]->coordinates())
                                  && isExactly(world[keyOf(method)], again.world[method]->coordinates()) && isSameByAll;
                return isSameByAll;
            };
            if (click["hit"].get<bool>()) {
                QVERIFY(isSame(click["eye"], click["world"], window.z));
                // The mesh itself is at the depth, within its precision.
                const glm::dvec3 onMesh = vectorOf(click["rayOnMesh"]["world"]);
                QVERIFY(glm::length(onMesh - vectorOf(click["world"]["formula"])) < 1e-4);
            } else {
                QVERIFY(isSame(click["eye"]["near"], click["world"]["near"], 0.0));
                QVERIFY(isSame(click["eye"]["far"], click["world"]["far"], 1.0));
            }
        }
        QVERIFY(!clicks[2]["hit"].get<bool>());
    }

    void theCommandComputesTheSamePoints_data()
    {
        addColumn<QString>("space");
        newRow("world") << "world";
        newRow("eye") << "eye";
        newRow("object") << "object";
    }

    void theCommandComputesTheSamePoints()
    {
        QFETCH(QString, space);
        const Run printed = run({"--screenshot", path("same.png"), "--view-size", "600x500", "--click", "300,250",
                                 "--click", "305.4,247.7"});
        QVERIFY2(printed.hasExited && printed.exitCode == 0, printed.errors.constData());
        const Json clicks = Json::parse(printed.output.toStdString(), nullptr, false);
        QVERIFY(clicks.is_array() && clicks[0]["object"].is_object() && clicks[1]["object"] != clicks[0]["object"]);
        const std::string name = clicks[0]["object"]["name"].get<std::string>();
        QProcess command;
        command.start(QStringLiteral(UNPROJECT_COMMAND),
                      {"points", "--format", "jsonl", "--space",
                       space == "object" ? "object:" + QString::fromStdString(name) : space, "-"});
        command.write(printed.output);
        command.closeWriteChannel();
        QVERIFY(command.waitForFinished(kPatienceMilliseconds));
        QVERIFY2(command.exitCode() == 0, command.readAllStandardError().constData());
        const QList<QByteArray> rows = command.readAllStandardOutput().trimmed().split('\n');
        QCOMPARE(rows.size(), 2);
        for (int i = 0; i < rows.size(); ++i) {
            const Json row = Json::parse(rows[i].toStdString(), nullptr, false);
            const Json &points = clicks[std::size_t(i)][space.toStdString()];
            QVERIFY(row["formula_x"] == points["formula"][0] && row["formula_y"] == points["formula"][1]);
            QVERIFY(row["formula_z"] == points["formula"][2] && row["matrix_x"] == points["matrix"][0]);
            QVERIFY(row["matrix_y"] == points["matrix"][1] && row["matrix_z"] == points["matrix"][2]);
        }
    }

    void everyDepthRangeIsClickedAndComputedAgain_data() { depthranges::addRows(); }

    /// A surface and the background: a far-plane depth that a float or the buffer rounds is background
    /// all the same.
    void everyDepthRangeIsClickedAndComputedAgain()
    {
        const DepthRange range = depthranges::ofThisRow();
        const auto write = [this](const char *name, const QByteArray &text) {
            QFile file(path(name));
            return file.open(QIODevice::WriteOnly) && file.write(text) == text.size();
        };
        QVERIFY(write("half.obj", "v -50 -50 1.25\nv 0 -50 1.25\nv 0 50 1.25\nv -50 50 1.25\nf 1 2 3 4\n"));
        QVERIFY(write("half.json",
                      QByteArray(R"({"unprojector": 1, "window": {"width": 800, "height": 600}, "depthRange": )") + '['
                          + QByteArray::number(range.atNear) + ',' + QByteArray::number(range.atFar)
                          + R"(], "projection": {"type": "frustum", "left": -1, "right": 1, "bottom": -0.75,
        "top": 0.75, "near": 1, "far": 100}, "view": {"eye": [0, 0, 5], "center": [0, 0, 0], "up": [0, 1, 0]},
        "objects": [{"name": "half", "file": "half.obj"}]})"));
        const Run printed = run({"--screenshot", path("half.png"), "--size", "900x640", "--click", "40,200", "--click",
                                 "400,200", path("half.json")});
        QVERIFY2(printed.hasExited && printed.exitCode == 0, printed.errors.constData());
        const Json clicks = Json::parse(printed.output.toStdString(), nullptr, false);
        QVERIFY(clicks[0]["hit"].get<bool>() && !clicks[1]["hit"].get<bool>());
        const glm::dvec3 point = vectorOf(clicks[0]["world"]["formula"]);
        QVERIFY2(std::abs(point.z - 1.25) < 1e-5, qPrintable(QString::number(point.z, 'g', 17)));
        QCOMPARE(float(clicks[1]["window"][2].get<double>()), float(range.atFar));
        QVERIFY(std::abs(vectorOf(clicks[1]["eye"]["near"]["formula"]).z + 1.0) < 1e-12);
        QVERIFY(std::abs(vectorOf(clicks[1]["eye"]["far"]["formula"]).z + 100.0) < 1e-10);
        QProcess command;
        command.start(QStringLiteral(UNPROJECT_COMMAND), {"points", "--format", "jsonl", "-"});
        command.write(printed.output);
        command.closeWriteChannel();
        QVERIFY(command.waitForFinished(kPatienceMilliseconds));
        const QList<QByteArray> rows = command.readAllStandardOutput().trimmed().split('\n');
        const Json row = Json::parse(rows[0].toStdString(), nullptr, false);
        QVERIFY(row["formula_x"] == clicks[0]["world"]["formula"][0]
                && row["formula_z"] == clicks[0]["world"]["formula"][2]);
    }

private:
    QString path(const QString &name) const { return m_folder.filePath(name); }

    QTemporaryDir m_folder;
};

UNPROJECTOR_TEST(TestScreenshotClicks, display)
#include "test_screenshot_clicks.moc"
