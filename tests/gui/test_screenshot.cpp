// The program as a script runs it: --screenshot with clicks, its JSON, its picture, its exit codes and its words.

#include "core/scene_file/clicks.h"

#include "tests/gui/depth_ranges.h"
#include "tests/support/unprojecting.h"

#include <nlohmann/json.hpp>

#include <QDir>
#include <QFile>
#include <QImage>
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>

#include <algorithm>
#include <cmath>
#include <limits>

using namespace unprojector;
using namespace unprojector::geometry;
using namespace unprojector::scene_file;
using namespace unprojector::unproject;

namespace {

using Json = nlohmann::ordered_json;

constexpr int kRunMilliseconds = 60000;

constexpr const char *kScene = R"({"unprojector": 1, "window": {"width": 800, "height": 600},
  "projection": {"type": "ortho", "left": -1, "right": 1, "bottom": -1, "top": 1, "near": 1, "far": 100},
  "view": {"eye": [0, 0, 5], "center": [0, 0, 0], "up": [0, 1, 0]}})";

struct Run {
    int exitCode = -1;
    bool hasExited = false;
    QByteArray output, errors;
};

/// @param environment  "NAME=value"; "NAME" alone takes it away
/// @param output       a file for standard output; empty: it is in the result
Run run(const QStringList &arguments, const QStringList &environment = {}, const QString &output = {})
{
    QProcess process;
    QProcessEnvironment variables = QProcessEnvironment::systemEnvironment();
    variables.remove(QStringLiteral("QT_SCALE_FACTOR"));
    for (const QString &variable : environment) {
        if (variable.contains(u'='))
            variables.insert(variable.section(u'=', 0, 0), variable.section(u'=', 1));
        else
            variables.remove(variable);
    }
    process.setProcessEnvironment(variables);
    if (!output.isEmpty())
        process.setStandardOutputFile(output);
    process.start(QStringLiteral(UNPROJECTOR_EXECUTABLE), arguments);
    Run result;
    const bool ended = process.waitForFinished(kRunMilliseconds);
    if (!ended)
        process.kill();
    result.hasExited = ended && process.exitStatus() == QProcess::NormalExit;
    result.exitCode = process.exitCode();
    result.output = process.readAllStandardOutput();
    result.errors = process.readAllStandardError();
    return result;
}

QStringList keysOf(const Json &json)
{
    QStringList keys;
    for (const auto &item : json.items())
        keys << QString::fromStdString(item.key());
    return keys;
}

glm::dvec3 vectorOf(const Json &json)
{
    return {json.at(0).get<double>(), json.at(1).get<double>(), json.at(2).get<double>()};
}

/// What is needed to compute the click again, from the JSON alone: its scene is a scene file.
Picture clickedPicture(const Json &scene)
{
    return pictureOf(parseScene(scene.dump(), "scene").value());
}

bool isExactly(const Json &json, const glm::dvec3 &expected)
{
    if (vectorOf(json) == expected)
        return true;
    qWarning("%s is not (%.17g, %.17g, %.17g)", json.dump().c_str(), expected.x, expected.y, expected.z);
    return false;
}

} // namespace

class TestScreenshot : public QObject {
    Q_OBJECT

private slots:
    void initTestCase();
    void theJsonHasItsContractedShape();
    void theSameClicksMeanTheSamePixels_data();
    void theSameClicksMeanTheSamePixels();
    void theNumbersReadBackAndComputedAgainAreTheSame_data();
    void theNumbersReadBackAndComputedAgainAreTheSame();
    void theCommandComputesTheSamePoints_data();
    void theCommandComputesTheSamePoints();
    void everyDepthRangeIsClickedAndComputedAgain_data() { depthranges::addRows(); }
    void everyDepthRangeIsClickedAndComputedAgain();
    void thePictureHasTheSizeAskedFor_data();
    void thePictureHasTheSizeAskedFor();
    void withoutClicksTheListIsEmpty();
    void aModelFileIsShown();
    void aMistakeIsToldOnStderr_data();
    void aMistakeIsToldOnStderr();
    void whatCannotBePrintedIsTold_data();
    void whatCannotBePrintedIsTold();
    void helpAndVersionNeedNoDisplay_data();
    void helpAndVersionNeedNoDisplay();

private:
    QString path(const QString &name) const { return m_folder.filePath(name); }

    QTemporaryDir m_folder;
};

void TestScreenshot::initTestCase()
{
    QVERIFY(m_folder.isValid());
    QVERIFY(QFile::exists(QStringLiteral(UNPROJECTOR_EXECUTABLE)));
}

void TestScreenshot::theSameClicksMeanTheSamePixels_data()
{
    QTest::addColumn<QStringList>("options");
    QTest::addColumn<QStringList>("environment");
    QTest::newRow("without panels") << QStringList{"--no-panels"} << QStringList();
    QTest::newRow("pipeline") << QStringList{"--place", "pipeline"} << QStringList();
    QTest::newRow("dark") << QStringList{"--appearance", "dark"} << QStringList();
    QTest::newRow("Chinese") << QStringList() << QStringList{"LANGUAGE=zh_CN"};
}

void TestScreenshot::theSameClicksMeanTheSamePixels()
{
    QFETCH(QStringList, options);
    QFETCH(QStringList, environment);
    const QStringList asked{"--screenshot", path("pixels.png"), "--view-size", "600x500", "--click", "300,250"};
    const Run plain = run(asked);
    QVERIFY2(plain.hasExited && plain.exitCode == 0, plain.errors.constData());
    const Run other = run(asked + options, environment);
    QVERIFY2(other.hasExited && other.exitCode == 0, other.errors.constData());
    QCOMPARE(other.output, plain.output);
    const Json clicks = Json::parse(plain.output.toStdString(), nullptr, false);
    QCOMPARE(clicks[0]["scene"]["window"]["width"].get<int>(), 600);
    QCOMPARE(clicks[0]["scene"]["window"]["height"].get<int>(), 500);
    QVERIFY(clicks[0]["hit"].get<bool>());
}

void TestScreenshot::theJsonHasItsContractedShape()
{
    const Run result =
        run({"--screenshot", path("shape.png"), "--view-size", "600x500", "--click", "300,250", "--click", "3,4.5"});
    QVERIFY2(result.hasExited && result.exitCode == 0, result.errors.constData());
    const Json clicks = Json::parse(result.output.toStdString(), nullptr, false);
    QVERIFY(clicks.is_array());
    QCOMPARE(clicks.size(), std::size_t(2));
    const QStringList points{"formula", "matrix", "matrixInFloat"};
    for (const Json &click : clicks) {
        QCOMPARE(keysOf(click),
                 (QStringList{"widget", "devicePixel", "window", "hit", "eye", "world", "object", "scene"}));
        QCOMPARE(keysOf(click["scene"]), (QStringList{"unprojector", "window", "viewport", "depthRange", "projection",
                                                      "view", "objects", "clipPlanes"}));
        QCOMPARE(keysOf(click["scene"]["window"]), (QStringList{"width", "height", "devicePixelRatio"}));
        QCOMPARE(keysOf(click["scene"]["viewport"]), (QStringList{"x", "y", "width", "height"}));
        QCOMPARE(keysOf(click["scene"]["projection"]), (QStringList{"type", "fovy", "aspect", "near", "far"}));
        QCOMPARE(keysOf(click["scene"]["view"]), (QStringList{"eye", "center", "up"}));
        QCOMPARE(click["widget"].size(), std::size_t(2));
        QCOMPARE(click["devicePixel"].size(), std::size_t(2));
        QVERIFY(click["devicePixel"][0].is_number_integer() && click["devicePixel"][1].is_number_integer());
        QCOMPARE(click["window"].size(), std::size_t(3));
        QVERIFY(click["hit"].is_boolean());
    }
    // The first on a surface, the second on the background.
    QVERIFY(clicks[0]["hit"].get<bool>());
    QVERIFY(!clicks[1]["hit"].get<bool>());
    for (const char *space : {"eye", "world"}) {
        QCOMPARE(keysOf(clicks[0][space]), points);
        for (const QString &method : points)
            QCOMPARE(clicks[0][space][method.toStdString()].size(), std::size_t(3));
        QCOMPARE(keysOf(clicks[1][space]), (QStringList{"near", "far"}));
        QCOMPARE(keysOf(clicks[1][space]["near"]), points);
        QCOMPARE(keysOf(clicks[1][space]["far"]), points);
    }
    QCOMPARE(keysOf(clicks[0]["object"]), (QStringList{"index", "name"} + points));
    const std::size_t index = clicks[0]["object"]["index"].get<std::size_t>();
    QVERIFY(clicks[0]["scene"]["objects"].at(index)["name"] == clicks[0]["object"]["name"]);
    QVERIFY(clicks[1]["object"].is_null());
    QCOMPARE(clicks[1]["widget"].dump(), std::string("[3,4.5]"));
    QCOMPARE(clicks[1]["devicePixel"].dump(), std::string("[3,4]"));
    // Only JSON on stdout, and it ends with its line.
    QVERIFY(result.output.startsWith('['));
    QVERIFY(result.output.endsWith("]\n") || result.output.endsWith("]\r\n"));
}

void TestScreenshot::theNumbersReadBackAndComputedAgainAreTheSame_data()
{
    QTest::addColumn<QString>("factor");
    QTest::addColumn<QString>("smooth");
    QTest::addColumn<QString>("size");
    // Windows keeps a window on its screen, which may be 1280 x 1024.
    QTest::newRow("1x") << "1"
                        << "off"
                        << "900x640";
    QTest::newRow("1x, smooth edges") << "1"
                                      << "on"
                                      << "900x640";
    QTest::newRow("1.25x") << "1.25"
                           << "off"
                           << "900x640";
    QTest::newRow("1.5x") << "1.5"
                          << "off"
                          << "840x600";
    QTest::newRow("2x") << "2"
                        << "off"
                        << "700x560";
}

void TestScreenshot::theNumbersReadBackAndComputedAgainAreTheSame()
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
        const Picture g = clickedPicture(click["scene"]);
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
        } else {
            QVERIFY(isSame(click["eye"]["near"], click["world"]["near"], 0.0));
            QVERIFY(isSame(click["eye"]["far"], click["world"]["far"], 1.0));
        }
    }
    QVERIFY(!clicks[2]["hit"].get<bool>());
}

void TestScreenshot::theCommandComputesTheSamePoints_data()
{
    QTest::addColumn<QString>("space");
    QTest::newRow("world") << "world";
    QTest::newRow("eye") << "eye";
    QTest::newRow("object") << "object";
}

void TestScreenshot::theCommandComputesTheSamePoints()
{
    QFETCH(QString, space);
    const Run printed =
        run({"--screenshot", path("same.png"), "--size", "900x640", "--click", "86,200", "--click", "91.4,187.7"});
    QVERIFY2(printed.hasExited && printed.exitCode == 0, printed.errors.constData());
    const Json clicks = Json::parse(printed.output.toStdString(), nullptr, false);
    const std::string name = clicks[0]["object"]["name"].get<std::string>();
    QProcess command;
    command.start(QStringLiteral(UNPROJECT_COMMAND),
                  {"points", "--format", "jsonl", "--space",
                   space == "object" ? "object:" + QString::fromStdString(name) : space, "-"});
    command.write(printed.output);
    command.closeWriteChannel();
    QVERIFY(command.waitForFinished(kRunMilliseconds));
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

/// A surface and the background: a far-plane depth that a float or the buffer rounds is background all the same.
void TestScreenshot::everyDepthRangeIsClickedAndComputedAgain()
{
    const DepthRange range = depthranges::ofThisRow();
    const auto write = [this](const char *name, const QByteArray &text) {
        QFile file(path(name));
        return file.open(QIODevice::WriteOnly) && file.write(text) == text.size();
    };
    QVERIFY(write("half.obj", "v -50 -50 1.25\nv 0 -50 1.25\nv 0 50 1.25\nv -50 50 1.25\nf 1 2 3 4\n"));
    QVERIFY(
        write("half.json", QByteArray(R"({"unprojector": 1, "window": {"width": 800, "height": 600}, "depthRange": )")
                               + '[' + QByteArray::number(range.atNear) + ',' + QByteArray::number(range.atFar)
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
    QVERIFY(command.waitForFinished(kRunMilliseconds));
    const QList<QByteArray> rows = command.readAllStandardOutput().trimmed().split('\n');
    const Json row = Json::parse(rows[0].toStdString(), nullptr, false);
    QVERIFY(row["formula_x"] == clicks[0]["world"]["formula"][0]
            && row["formula_z"] == clicks[0]["world"]["formula"][2]);
}

void TestScreenshot::thePictureHasTheSizeAskedFor_data()
{
    QTest::addColumn<QString>("factor");
    QTest::addColumn<QString>("size");
    QTest::addColumn<QSize>("pixels");
    QTest::newRow("1x") << "1"
                        << "1001x703" << QSize(1001, 703);
    QTest::newRow("1.5x") << "1.5"
                          << "801x603" << QSize(1202, 905); // 1201.5 x 904.5
    QTest::newRow("2x") << "2"
                        << "700x560" << QSize(1400, 1120);
}

void TestScreenshot::thePictureHasTheSizeAskedFor()
{
    QFETCH(QString, factor);
    QFETCH(QString, size);
    QFETCH(QSize, pixels);
    const QString picture = path("size-" + factor + ".png");
    const Run result =
        run({"--screenshot", picture, "--size", size, "--click", "86,200"}, {"QT_SCALE_FACTOR=" + factor});
    QVERIFY2(result.hasExited && result.exitCode == 0, result.errors.constData());
    const QImage image(picture);
    QVERIFY(!image.isNull());
#ifdef Q_OS_WIN
    if (image.width() < pixels.width() - 1 || image.height() < pixels.height() - 1)
        QSKIP("the screen is smaller than the window asked for, and Windows keeps windows on their screen");
#endif
    // Qt rounds halves of a picture's size as it likes.
    QVERIFY2(std::abs(image.width() - pixels.width()) <= 1 && std::abs(image.height() - pixels.height()) <= 1,
             qPrintable(QStringLiteral("%1 x %2").arg(image.width()).arg(image.height())));
    // It is a picture of something.
    QSet<QRgb> colors;
    for (int y = 0; y < image.height(); y += 7) {
        for (int x = 0; x < image.width(); x += 7)
            colors.insert(image.pixel(x, y));
    }
    QVERIFY(colors.size() > 100);
}

void TestScreenshot::withoutClicksTheListIsEmpty()
{
    const Run result = run({"--screenshot", path("none.png")});
    QVERIFY2(result.hasExited && result.exitCode == 0, result.errors.constData());
    QCOMPARE(result.output.trimmed(), QByteArray("[]"));
    QCOMPARE(QImage(path("none.png")).size(), QSize(1280, 800));
}

void TestScreenshot::aModelFileIsShown()
{
    QFile file(path("triangle.obj"));
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write("v -50 -50 1.25\nv 50 -50 1.25\nv 0 50 1.25\nf 1 2 3\n");
    file.close();
    const Run result =
        run({"--screenshot", path("triangle.png"), "--size", "900x640", "--click", "200,280", file.fileName()});
    QVERIFY2(result.hasExited && result.exitCode == 0, result.errors.constData());
    const Json click = Json::parse(result.output.toStdString(), nullptr, false).at(0);
    QVERIFY(click["hit"].get<bool>());
    QVERIFY(std::abs(click["world"]["formula"][2].get<double>() - 1.25) < 1e-3);
    QVERIFY(std::abs(click["world"]["matrix"][2].get<double>() - 1.25) < 1e-3);
}

void TestScreenshot::aMistakeIsToldOnStderr_data()
{
    QTest::addColumn<QStringList>("arguments");
    QTest::addColumn<QString>("words");
    QFile broken(path("broken.obj"));
    QVERIFY(broken.open(QIODevice::WriteOnly));
    broken.write("v 0 0 0\nf 1 2 9\n");
    broken.close();
    QFile scene(path("scene.png")); // told to be one by what it holds
    QVERIFY(scene.open(QIODevice::WriteOnly));
    scene.write(kScene);
    scene.close();
    const QString picture = path("never.png");
    const auto row = [](const char *name, const QStringList &arguments, const QString &words) {
        QTest::newRow(name) << arguments << words;
    };
    row("missing file", {"--screenshot", picture, path("missing.obj")}, "missing.obj");
    row("broken file", {"--screenshot", picture, broken.fileName()}, "broken.obj");
    row("unknown format", {"--screenshot", picture, QStringLiteral(UNPROJECTOR_EXECUTABLE)},
        "OBJ, STL, PLY, OFF, glTF or GLB");
    row("size without a height", {"--screenshot", picture, "--size", "1280"}, "--size is 1280");
    row("size with words", {"--screenshot", picture, "--size", "wide x high"}, "--size is wide x high");
    row("size of nothing", {"--screenshot", picture, "--size", "0x0"}, "--size is 0x0");
    row("negative size", {"--screenshot", picture, "--size", "-800x600"}, "--size is -800x600");
    row("view size without a height", {"--screenshot", picture, "--view-size", "640"}, "--view-size is 640");
    row("two sizes", {"--screenshot", picture, "--size", "640x480", "--view-size", "640x480"}, "not both");
    row("unknown place", {"--screenshot", picture, "--place", "kitchen"}, "--place is kitchen");
    row("unknown colours", {"--screenshot", picture, "--appearance", "pink"}, "--appearance is pink");
    row("gigantic size", {"--screenshot", picture, "--size", "99999x99999"}, "--size is 99999x99999");
    row("click with one number", {"--screenshot", picture, "--click", "12"}, "--click is 12");
    row("click with words", {"--screenshot", picture, "--click", "left,top"}, "--click is left,top");
    row("click that is not a number", {"--screenshot", picture, "--click", "nan,3"}, "nan,3");
    row("click right of the view", {"--screenshot", picture, "--click", "5000,10"}, "5000,10 lies outside the view");
    row("click above the view", {"--screenshot", picture, "--click", "10,-1"}, "10,-1 lies outside the view");
    row("one click inside, one outside", {"--screenshot", picture, "--click", "10,10", "--click", "10,5000"},
        "10,5000 lies outside the view");
    row("click without a picture", {"--click", "10,10"}, "--screenshot");
    row("edges", {"--screenshot", picture, "--smooth-edges", "3"}, "--smooth-edges is 3");
    row("unknown option", {"--screnshot", picture}, "screnshot");
    row("Qt's own help", {"--help-all"}, "help-all");
    row("no such folder", {"--screenshot", path("no/such/folder/out.png")}, "there is no such folder");
    row("unknown picture format", {"--screenshot", path("out.xyz")}, "out.xyz is no picture's name");
    row("a model for a picture", {"--screenshot", path("broken.obj")}, "broken.obj is no picture's name");
    const QString isInput = "scene.png is opened too and would be overwritten; give the picture another name.";
    row("the scene that it opens", {"--screenshot", path("scene.png"), path("scene.png")}, isInput);
    row("the scene by another way", {"--screenshot", path("./scene.png"), path("scene.png")}, isInput);
    row("one of several", {"--screenshot", path("scene.png"), broken.fileName(), path("scene.png")}, isInput);
}

void TestScreenshot::aMistakeIsToldOnStderr()
{
    QFETCH(QStringList, arguments);
    QFETCH(QString, words);
    const Run result = run(arguments);
    QVERIFY(result.hasExited);
    QCOMPARE(result.exitCode, 2);
    const QString errors = QString::fromLocal8Bit(result.errors);
    QVERIFY2(errors.startsWith(QStringLiteral("unprojector: ")) || errors.contains(QStringLiteral("\nunprojector: ")),
             qPrintable(errors));
    QVERIFY2(errors.contains(words), qPrintable(errors));
    QVERIFY2(result.output.isEmpty(), result.output.constData());
    QVERIFY(!QFile::exists(path("never.png")));
    QVERIFY(QFileInfo(path("broken.obj")).size() > 0);
    QFile scene(path("scene.png"));
    QVERIFY(scene.open(QIODevice::ReadOnly));
    QCOMPARE(scene.readAll(), QByteArray(kScene));
}

void TestScreenshot::whatCannotBePrintedIsTold_data()
{
    QTest::addColumn<QStringList>("arguments");
    QTest::newRow("help") << QStringList{"--help"};
    QTest::newRow("version") << QStringList{"--version"};
    QTest::newRow("clicks") << QStringList{"--screenshot", path("full.png"), "--click", "10,10"};
}

void TestScreenshot::whatCannotBePrintedIsTold()
{
    QFETCH(QStringList, arguments);
    if (!QFile::exists("/dev/full"))
        QSKIP("no device that is always full");
    const Run result = run(arguments, {}, "/dev/full");
    QVERIFY(result.hasExited);
    QCOMPARE(result.exitCode, 2);
    QVERIFY2(result.errors.contains("No space left on device"), result.errors.constData());
}

void TestScreenshot::helpAndVersionNeedNoDisplay_data()
{
    QTest::addColumn<QString>("option");
    QTest::addColumn<QByteArray>("words");
    QTest::newRow("help") << "--help" << QByteArray("--screenshot");
    QTest::newRow("short help") << "-h" << QByteArray("--click");
    QTest::newRow("version") << "--version" << QByteArray("Unprojector ");
}

void TestScreenshot::helpAndVersionNeedNoDisplay()
{
    QFETCH(QString, option);
    QFETCH(QByteArray, words);
    const Run result = run({option}, {"DISPLAY", "WAYLAND_DISPLAY", "QT_QPA_PLATFORM"});
    QVERIFY2(result.hasExited && result.exitCode == 0, result.errors.constData());
    QVERIFY2(result.output.contains(words), result.output.constData());
#ifdef Q_OS_LINUX
    // Without one, a picture is refused in words, not by the platform plugin's abort.
    const Run picture = run({"--screenshot", path("never.png")}, {"DISPLAY", "WAYLAND_DISPLAY", "QT_QPA_PLATFORM"});
    QVERIFY(picture.hasExited);
    QCOMPARE(picture.exitCode, 2);
    QVERIFY2(picture.errors.contains("display"), picture.errors.constData());
#endif
}

QTEST_GUILESS_MAIN(TestScreenshot)
#include "test_screenshot.moc"
