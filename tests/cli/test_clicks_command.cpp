// Clicks as the window prints them, through the command: the same points, to the last digit.

#include "tests/support/test.h"

#include "core/scene_file/clicks.h"

#include "tests/cli/command.h"
#include "tests/support/unprojecting.h"

#include <QJsonDocument>

using namespace unprojector;
using namespace unprojector::geometry;
using namespace unprojector::scene;
using namespace unprojector::scene_file;
using namespace unprojector::unproject;
using namespace unprojector::mesh;

namespace {

/// Two objects, the second one turned and stretched, in an 800 x 600 window at 1.25 device pixels a
/// logical one.
Scene twoObjects()
{
    Scene scene;
    const auto model = std::make_shared<Model>();
    model->name = "Teapot";
    scene.objects = {{"left", {}, model, {Translate{{-40, 0, 0}}}},
                     {"right", {}, model, {Translate{{0.1, 0.2, 0.3}}, Rotate{33.3, {1, 2, 3}}, Scale{{1, 2, 3}}}}};
    return scene;
}

Click clickAt(double x, double y, double depth, bool hit, double eyeX = 0.1)
{
    const Surface surface = surfaceFromWidget(800, 600, 1.25);
    const Setup setup{surface,
                      wholeSurface(surface),
                      {1.0, 0.0},
                      Projection(Perspective{0.7, 1.3, 0.1, 50.0}),
                      LookAt{WorldPoint(eyeX, 0.2, 5.3), WorldPoint(0.0, 0.1, 0.0), {0, 1, 0.1}}};
    return clickOf(
        pickAt(setup, WidgetPoint(x, y), {depth, hit ? std::optional<std::size_t>(1) : std::nullopt, 24}).value(),
        twoObjects());
}

QByteArray textOf(const std::vector<Click> &clicks)
{
    return QByteArray::fromStdString(clicksText(clicks).value());
}

/// The numbers of a row; an empty cell is a NaN.
QList<double> numbersOf(const QByteArray &row)
{
    QList<double> numbers;
    for (const QByteArray &cell : row.split(','))
        numbers << (cell.isEmpty() ? std::nan("") : cell.toDouble());
    return numbers;
}

void verifyPoint(const QList<double> &row, int column, const std::optional<glm::dvec3> &point)
{
    for (int i = 0; i < 3; ++i)
        QVERIFY2(row.at(column + i) == (*point)[i], qPrintable(QString::number(column)));
}

constexpr std::size_t kFormula = std::size_t(Method::Formula), kMatrix = std::size_t(Method::Matrix);

} // namespace

class TestClicksCommand : public QObject {
    Q_OBJECT

private slots:
    void theSamePointsToTheLastDigit_data()
    {
        addColumn<QString>("space");
        newRow("world") << "world";
        newRow("eye") << "eye";
        newRow("object") << "object:right";
    }

    void theSamePointsToTheLastDigit()
    {
        QFETCH(QString, space);
        const std::vector<Click> clicks{clickAt(400, 300, 0.0123456789, true), clickAt(411.4, 222.2, 0.0191, true)};
        QVERIFY(clicks[0].object && clicks[0].object->name == "right");
        const QString file = m_folder.write("clicks.json", textOf(clicks));
        const Run run = runCommand({"points", "--space", space, file});
        VERIFY_SUCCEEDED(run);
        const auto lines = run.lines();
        QCOMPARE(lines.size(), 3);
        QCOMPARE(lines[0],
                 QByteArray("px,py,depth,formula_x,formula_y,formula_z,matrix_x,matrix_y,matrix_z,difference"));
        for (int i = 0; i < 2; ++i) {
            const Click &click = clicks[std::size_t(i)];
            const ClickPoint &point = space == "eye"     ? click.eye.surface
                                      : space == "world" ? click.world.surface
                                                         : click.object->point;
            const QList<double> row = numbersOf(lines[i + 1]);
            QCOMPARE(row.size(), 10);
            QCOMPARE(row[0], click.devicePixel.i + 0.5);
            QCOMPARE(row[1], click.devicePixel.j + 0.5);
            QCOMPARE(row[2], click.window.z);
            verifyPoint(row, 3, point[kFormula]);
            verifyPoint(row, 6, point[kMatrix]);
        }
        // Standard input gives one click alone, one method, as JSON.
        QCOMPARE(runCommand({"points", "--space", space, "-"}, textOf(clicks)).output, run.output);
        const QByteArray alone = textOf({clicks[1]}).trimmed().mid(1).chopped(1);
        const Run one = runCommand({"points", "--no-header", "--method", "formula", "--space", space, "-"}, alone);
        QCOMPARE(one.lines(), QList<QByteArray>{lines[2].split(',').mid(0, 6).join(',')});
        const Run json = runCommand({"points", "--format", "jsonl", "--space", space, file});
        QCOMPARE(json.lines().size(), 2);
        QVERIFY(json.output.startsWith("{\"px\":500.5,\"py\":375.5,\"depth\":0.0123456789,\"formula_x\":"));
    }

    void aClickOnTheBackgroundHasEmptyCells()
    {
        const QString file =
            m_folder.write("rays.json", textOf({clickAt(1, 2, 0.0, false), clickAt(400, 300, 0.01, true)}));
        const Run run = runCommand({"points", "--no-header", file});
        QCOMPARE(run.exitCode, 1);
        QCOMPARE(run.errors,
                 file.toUtf8() + ": [0]: background: nothing was drawn there, so the click has no point, only a ray\n");
        QCOMPARE(run.lines().at(0), QByteArray("1.5,2.5,0,,,,,,,"));
        QVERIFY(!run.lines().at(1).contains(",,"));
    }

    void clicksOfDifferentScenes()
    {
        const std::vector<Click> clicks{clickAt(400, 300, 0.01, true), clickAt(400, 300, 0.01, true, 7.5)};
        const QString file = m_folder.write("different.json", textOf(clicks));
        const Run run = runCommand({"points", "--no-header", file});
        for (int i = 0; i < 2; ++i)
            verifyPoint(numbersOf(run.lines().at(i)), 3, clicks[std::size_t(i)].world.surface[kFormula]);
        const Run matrices = runCommand({"matrices", file});
        QCOMPARE(matrices.exitCode, 2);
        QCOMPARE(matrices.errors,
                 file.toUtf8() + ": its clicks have different scenes; give one click, or the scene of one\n");
    }

    void otherCommandsTakeTheScene_data()
    {
        addColumn<QStringList>("command");
        addColumn<QByteArray>("input");
        newRow("matrices") << QStringList{"matrices"} << QByteArray();
        newRow("project") << QStringList{"project"} << QByteArray("x,y,z\n0,0,0\n1,2,3\n");
        newRow("project from an object") << QStringList{"project", "--space", "object:right"}
                                         << QByteArray("x,y,z\n0,0,0\n");
        newRow("compare") << QStringList{"compare", "--pixels", "3", "--depths", "3", "--json"} << QByteArray();
    }

    void otherCommandsTakeTheScene()
    {
        QFETCH(QStringList, command);
        QFETCH(QByteArray, input);
        const std::vector<Click> clicks{clickAt(400, 300, 0.01, true), clickAt(1, 1, 0.01, false)};
        const QByteArray scene = QByteArray::fromStdString(sceneText(clicks[0].scene).value());
        const Run byScene = runCommand(command + QStringList{m_folder.write("alone.json", scene)}, input);
        QCOMPARE(byScene.exitCode, 0);
        QVERIFY(!byScene.output.isEmpty());
        const Run byClicks = runCommand(command + QStringList{m_folder.write("both.json", textOf(clicks))}, input);
        QCOMPARE(byClicks.errors, QByteArray());
        // Only the times of a comparison and the file's name differ.
        if (command[0] != "compare")
            QCOMPARE(byClicks.output, byScene.output);
        QCOMPARE(byClicks.exitCode, 0);
    }

    void aTableGoesThroughTheClicksScene()
    {
        const Click click = clickAt(400, 300, 0.01, true);
        const QString clicks = m_folder.write("scene-of.json", textOf({click}));
        const QString table = m_folder.write("table.csv", "px,py,depth\n500.5,375.5,0.01\n");
        const Run run = runCommand({"points", "--no-header", clicks, table});
        QCOMPARE(run.exitCode, 0);
        QCOMPARE(run.lines().size(), 1);
        const QList<double> row = numbersOf(run.lines().at(0));
        QVERIFY(std::abs(row[3] - (*click.world.surface[kFormula]).x) < 1e-12);
        // Standard input works as well.
        const Run piped = runCommand({"points", "--no-header", clicks, "-"}, "px,py,depth\n500.5,375.5,0.01\n");
        QCOMPARE(piped.output, run.output);
    }

    void mistakesAreTold_data()
    {
        addColumn<QStringList>("arguments");
        addColumn<QByteArray>("input");
        addColumn<QByteArray>("message");
        const QByteArray click = textOf({clickAt(400, 300, 0.01, true)});
        const auto row = [](const char *name, const QStringList &arguments, const QByteArray &input,
                            const QByteArray &message) { newRow(name) << arguments << input << message + '\n'; };
        row("no scene in no clicks", {"matrices", "-"}, "[]",
            "stdin: it has no click and so no scene; give a scene file");
        row("no such object", {"points", "--space", "object:none", "-"}, click,
            "the scene has no object \"none\"; it has: left, right");
        row("pixels", {"points", "--pixel", "-"}, click,
            "--pixel is for tables of pixels; clicks already have the centres of their pixels");
        row("a broken scene", {"points", "-"}, QByteArray(click).replace("\"unprojector\": 1", "\"unprojector\": 2"),
            "stdin:29:22: [0].scene.unprojector: version 2 cannot be read, only version 1");
        row("both from standard input", {"project", "-"}, kFrustumScene,
            "the scene and the points cannot both come from standard input; give a file for one of them");
    }

    void mistakesAreTold()
    {
        QFETCH(QStringList, arguments);
        QFETCH(QByteArray, input);
        QFETCH(QByteArray, message);
        const Run run = runCommand(arguments, input);
        QCOMPARE(run.errors, message);
        QCOMPARE(run.exitCode, 2);
    }

private:
    Folder m_folder;
};

UNPROJECTOR_TEST(TestClicksCommand)
#include "test_clicks_command.moc"
