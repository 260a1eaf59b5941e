// The program as a script runs it: --screenshot with clicks, its JSON, its picture, its exit codes
// and its words.

#include "tests/support/test.h"

#include "tests/gui/program/program_run.h"

#include <QFile>
#include <QFileInfo>
#include <QImage>
#include <QSet>
#include <QTemporaryDir>

#include <cmath>
#include <utility>

using namespace program_run;

namespace {

constexpr const char *kScene = R"({"unprojector": 1, "window": {"width": 800, "height": 600},
  "projection": {"type": "ortho", "left": -1, "right": 1, "bottom": -1, "top": 1, "near": 1, "far": 100},
  "view": {"eye": [0, 0, 5], "center": [0, 0, 0], "up": [0, 1, 0]}})";

QStringList keysOf(const Json &json)
{
    QStringList keys;
    for (const auto &item : json.items())
        keys << QString::fromStdString(item.key());
    return keys;
}

} // namespace

class TestScreenshot : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        QVERIFY(m_folder.isValid());
        QVERIFY(QFile::exists(QStringLiteral(UNPROJECTOR_EXECUTABLE)));
    }

    void aLessonHasItsOwnView()
    {
        const Run result = run({"--screenshot", path("lesson.png"), "--lesson", "first:2", "--click", "112,412"});
        QVERIFY2(result.hasExited && result.exitCode == 0, result.errors.constData());
        const Json click = Json::parse(result.output.toStdString(), nullptr, false)[0];
        QCOMPARE(click["scene"]["window"]["width"].get<int>(), 500);
        QCOMPARE(click["scene"]["window"]["height"].get<int>(), 500);
        const Json point = click["world"]["formula"];
        for (const auto &[place, wanted] : {std::pair(0, 3.0), std::pair(1, -1.0), std::pair(2, 5.0)})
            QVERIFY(std::fabs(point[std::size_t(place)].get<double>() - wanted) < 1e-6);
    }

    void theJsonHasItsContractedShape()
    {
        const Run result = run(
            {"--screenshot", path("shape.png"), "--view-size", "600x500", "--click", "300,250", "--click", "3,4.5"});
        QVERIFY2(result.hasExited && result.exitCode == 0, result.errors.constData());
        const Json clicks = Json::parse(result.output.toStdString(), nullptr, false);
        QVERIFY(clicks.is_array());
        QCOMPARE(clicks.size(), std::size_t(2));
        const QStringList points{"formula", "matrix", "matrixInFloat"};
        for (const Json &click : clicks) {
            QStringList keys{"widget", "devicePixel", "window", "hit", "eye", "world", "object", "rayOnMesh", "scene"};
            if (click["hit"] == true)
                keys.insert(6, "uncertainty");
            QCOMPARE(keysOf(click), keys);
            QCOMPARE(keysOf(click["scene"]),
                     (QStringList{"unprojector", "generator", "window", "viewport", "depthRange", "projection", "view",
                                  "objects", "clipPlanes", "ui"}));
            QCOMPARE(keysOf(click["scene"]["ui"]), QStringList{"projectionFollowsViewport"});
            QCOMPARE(keysOf(click["scene"]["window"]), (QStringList{"width", "height", "devicePixelRatio"}));
            QCOMPARE(keysOf(click["scene"]["viewport"]), (QStringList{"x", "y", "width", "height"}));
            // No double is 600 / 500: the aspect is left out, so that the click comes back with all digits.
            QCOMPARE(keysOf(click["scene"]["projection"]), (QStringList{"type", "fovy", "near", "far"}));
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
        QCOMPARE(keysOf(clicks[0]["rayOnMesh"]),
                 (QStringList{"hit", "object", "triangle", "barycentric", "world", "objectPoint", "normal", "distance",
                              "vertex", "edge", "uncertainty"}));
        QVERIFY(clicks[0]["rayOnMesh"]["object"] == clicks[0]["object"]["name"]);
        QVERIFY(clicks[1]["rayOnMesh"] == Json({{"hit", false}}));
        QCOMPARE(clicks[1]["widget"].dump(), std::string("[3,4.5]"));
        QCOMPARE(clicks[1]["devicePixel"].dump(), std::string("[3,4]"));
        // Only JSON on stdout, and it ends with its line.
        QVERIFY(result.output.startsWith('['));
        QVERIFY(result.output.endsWith("]\n") || result.output.endsWith("]\r\n"));
    }

    void theSameClicksMeanTheSamePixels()
    {
        const QStringList asked{"--screenshot", path("pixels.png"), "--view-size", "600x500", "--click", "300,250"};
        const Run plain = run(asked);
        QVERIFY2(plain.hasExited && plain.exitCode == 0, plain.errors.constData());
        struct Other {
            QStringList options, environment;
        };
        for (const Other &otherwise :
             {Other{{"--no-panels"}, {}}, Other{{"--place", "pipeline", "--appearance", "dark"}, {"LANGUAGE=zh_CN"}}}) {
            const Run other = run(asked + otherwise.options, otherwise.environment);
            QVERIFY2(other.hasExited && other.exitCode == 0, other.errors.constData());
            QCOMPARE(other.output, plain.output);
        }
        const Json clicks = Json::parse(plain.output.toStdString(), nullptr, false);
        QCOMPARE(clicks[0]["scene"]["window"]["width"].get<int>(), 600);
        QCOMPARE(clicks[0]["scene"]["window"]["height"].get<int>(), 500);
        QVERIFY(clicks[0]["hit"].get<bool>());
    }

    void thePictureHasTheSizeAskedFor_data()
    {
        addColumn<QString>("factor");
        addColumn<QString>("size");
        addColumn<QSize>("pixels");
        newRow("1x") << "1"
                     << "1001x703" << QSize(1001, 703);
        newRow("1.5x") << "1.5"
                       << "801x603" << QSize(1202, 905); // 1201.5 x 904.5
        newRow("2x") << "2"
                     << "700x560" << QSize(1400, 1120);
    }

    void thePictureHasTheSizeAskedFor()
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

    void withoutClicksTheListIsEmpty()
    {
        const Run result = run({"--screenshot", path("none.png")});
        QVERIFY2(result.hasExited && result.exitCode == 0, result.errors.constData());
        QCOMPARE(result.output.trimmed(), QByteArray("[]"));
        QCOMPARE(QImage(path("none.png")).size(), QSize(1280, 800));
    }

    void aModelFileIsShown()
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

    void aMistakeIsToldOnStderr_data()
    {
        addColumn<QStringList>("arguments");
        addColumn<QString>("words");
        QFile broken(path("broken.obj"));
        QVERIFY(broken.open(QIODevice::WriteOnly));
        broken.write("v 0 0 0\nf 1 2 9\n");
        broken.close();
        QFile scene(path("scene.png")); // recognised by its contents
        QVERIFY(scene.open(QIODevice::WriteOnly));
        scene.write(kScene);
        scene.close();
        const auto write = [this](const QString &name, const QByteArray &text) {
            QFile file(path(name));
            QVERIFY(file.open(QIODevice::WriteOnly) && file.write(text) == text.size());
        };
        write("skin.png", "no picture");
        write("skin.mtl", "newmtl m\nmap_Kd skin.png\n");
        write("skin.obj", "mtllib skin.mtl\nusemtl m\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
        const QString picture = path("never.png");
        const auto row = [](const char *name, const QStringList &arguments, const QString &words) {
            newRow(name) << arguments << words;
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
        row("unknown lesson", {"--screenshot", picture, "--lesson", "kitchen"}, "--lesson is kitchen");
        row("unknown step", {"--screenshot", picture, "--lesson", "first:8"}, "first:1-7");
        row("no step", {"--screenshot", picture, "--lesson", "first:"}, "--lesson is first:;");
        row("a lesson and a model", {"--screenshot", picture, "--lesson", "first", broken.fileName()}, "not both");
        row("unknown colours", {"--screenshot", picture, "--appearance", "pink"}, "--appearance is pink");
        row("unknown language", {"--screenshot", picture, "--language", "fr"}, "--language is fr");
#ifdef UNPROJECTOR_IS_TRANSLATED
        row("told in a language", {"--screenshot", picture, "--language", "zh_CN", "--place", "kitchen"},
            "--place 是 kitchen");
#endif
        row("gigantic size", {"--screenshot", picture, "--size", "99999x99999"}, "--size is 99999x99999");
        row("click with one number", {"--screenshot", picture, "--click", "12"}, "--click is 12");
        row("click with words", {"--screenshot", picture, "--click", "left,top"}, "--click is left,top");
        row("click that is not a number", {"--screenshot", picture, "--click", "nan,3"}, "nan,3");
        row("click right of the view", {"--screenshot", picture, "--click", "5000,10"},
            "5000,10 lies outside the view");
        row("click above the view", {"--screenshot", picture, "--click", "10,-1"}, "10,-1 lies outside the view");
        row("one click inside, one outside", {"--screenshot", picture, "--click", "10,10", "--click", "10,5000"},
            "10,5000 lies outside the view");
        row("click without a picture", {"--click", "10,10"}, "--screenshot");
        row("edges", {"--screenshot", picture, "--smooth-edges", "3"}, "--smooth-edges is 3");
        row("unknown option", {"--screnshot", picture}, "screnshot");
        row("Qt's own help", {"--help-all"}, "help-all");
        row("no such folder", {"--screenshot", path("no/such/folder/out.png")}, "there is no such folder");
        row("unknown picture format", {"--screenshot", path("out.xyz")}, "out.xyz is not an image name");
        row("a model for a picture", {"--screenshot", path("broken.obj")}, "broken.obj is not an image name");
        const QString isInput = "scene.png is also opened and would be overwritten; give the image another name.";
        row("the scene that it opens", {"--screenshot", path("scene.png"), path("scene.png")}, isInput);
        row("the scene by another way", {"--screenshot", path("./scene.png"), path("scene.png")}, isInput);
        row("a texture of a model that it opens", {"--screenshot", path("skin.png"), path("skin.obj")},
            "skin.png: the open scene uses this file and would destroy it.");
        row("one of several", {"--screenshot", path("scene.png"), broken.fileName(), path("scene.png")}, isInput);
    }

    void aMistakeIsToldOnStderr()
    {
        QFETCH(QStringList, arguments);
        QFETCH(QString, words);
        const Run result = run(arguments);
        QVERIFY(result.hasExited);
        QCOMPARE(result.exitCode, 2);
        const QString errors = textOf(result.errors);
        QVERIFY2(errors.startsWith(QStringLiteral("unprojector: "))
                     || errors.contains(QStringLiteral("\nunprojector: ")),
                 qPrintable(errors));
        QVERIFY2(errors.contains(words), qPrintable(errors));
        QVERIFY2(result.output.isEmpty(), result.output.constData());
        QVERIFY(!QFile::exists(path("never.png")));
        QVERIFY(QFileInfo(path("broken.obj")).size() > 0);
        QCOMPARE(QFileInfo(path("skin.png")).size(), qint64(10));
        QFile scene(path("scene.png"));
        QVERIFY(scene.open(QIODevice::ReadOnly));
        QCOMPARE(scene.readAll(), QByteArray(kScene));
    }

    void whatCannotBePrintedIsTold_data()
    {
        addColumn<QStringList>("arguments");
        newRow("help") << QStringList{"--help"};
        newRow("version") << QStringList{"--version"};
        newRow("clicks") << QStringList{"--screenshot", path("full.png"), "--click", "10,10"};
    }

    void whatCannotBePrintedIsTold()
    {
        QFETCH(QStringList, arguments);
        if (!QFile::exists("/dev/full"))
            QSKIP("no device that is always full");
        const Run result = run(arguments, {}, "/dev/full");
        QVERIFY(result.hasExited);
        QCOMPARE(result.exitCode, 2);
        QVERIFY2(result.errors.contains("No space left on device"), result.errors.constData());
    }

    void helpAndVersionNeedNoDisplay_data()
    {
        addColumn<QString>("option");
        addColumn<QByteArray>("words");
        newRow("help") << "--help" << QByteArray("--screenshot");
        newRow("short help") << "-h" << QByteArray("--click");
        newRow("version") << "--version" << QByteArray("Unprojector ");
    }

    void helpAndVersionNeedNoDisplay()
    {
        QFETCH(QString, option);
        QFETCH(QByteArray, words);
        const Run result = run({option}, {"DISPLAY", "WAYLAND_DISPLAY", "QT_QPA_PLATFORM"});
        QVERIFY2(result.hasExited && result.exitCode == 0, result.errors.constData());
        QVERIFY2(result.output.contains(words), result.output.constData());
    }

    void withoutADisplayItEndsInWords()
    {
#ifdef Q_OS_LINUX
        // A screenshot without a display fails with a message, not with the platform plugin's abort.
        const Run picture = run({"--screenshot", path("never.png")}, {"DISPLAY", "WAYLAND_DISPLAY", "QT_QPA_PLATFORM"});
        QVERIFY(picture.hasExited);
        QCOMPARE(picture.exitCode, 2);
        QVERIFY2(picture.errors.contains("display"), picture.errors.constData());
        const QStringList nowhere{"DISPLAY=:9876", "WAYLAND_DISPLAY", "QT_QPA_PLATFORM=xcb"};
        for (const QStringList &words : {QStringList(), QStringList { "--screenshot", path("never.png") }}) {
            const Run result = run(words, nowhere);
            QVERIFY(result.hasExited);
            QCOMPARE(result.exitCode, 2);
            QVERIFY2(result.errors.startsWith("unprojector: No window can be opened (")
                         && result.errors.contains(":9876") && result.errors.count('\n') == 1,
                     result.errors.constData());
        }
#else
        QSKIP("no displays by name");
#endif
    }

    void anOldOpenGLIsRefusedInWords()
    {
        const Run result = run({"--screenshot", path("old.png"), "--click", "10,10"}, {"MESA_GL_VERSION_OVERRIDE=2.1"});
        QVERIFY(result.hasExited);
        if (result.exitCode == 0)
            QSKIP("only Mesa's OpenGL can be made old");
        QCOMPARE(result.exitCode, 2);
        QVERIFY2(result.errors.contains("unprojector: This computer has OpenGL 2.1 ("), result.errors.constData());
        QVERIFY2(result.errors.contains("; the view needs 3.3. "), result.errors.constData());
        QVERIFY(!QFile::exists(path("old.png")));
    }

    void withoutOpenGLItEndsInWords()
    {
#ifdef Q_OS_LINUX
        const Run result = run({"--screenshot", path("never.png")}, {"DISPLAY", "QT_QPA_PLATFORM=offscreen"});
        QVERIFY(result.hasExited);
        QCOMPARE(result.exitCode, 2);
        QVERIFY2(result.errors.contains("unprojector: OpenGL is missing; the view needs OpenGL 3.3. "),
                 result.errors.constData());
        QVERIFY(!QFile::exists(path("never.png")));
#else
        QSKIP("no platform without OpenGL");
#endif
    }

    void aNameInAnyLettersIsPrinted()
    {
        const Run result = run({"--screenshot", path("never.png"), path(QStringLiteral("茶壶 é.obj"))});
        QVERIFY(result.hasExited);
        QCOMPARE(result.exitCode, 2);
        QVERIFY2(textOf(result.errors).contains(QStringLiteral("茶壶 é.obj")), result.errors.constData());
    }

private:
    QString path(const QString &name) const
    {
        return m_folder.filePath(name);
    }

    QTemporaryDir m_folder;
};

UNPROJECTOR_TEST(TestScreenshot, display)
#include "test_screenshot.moc"
