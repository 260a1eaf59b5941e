// Scene files among other files: recognised by their contents, never written over a model or over
// another program's changes.
#include "tests/support/test.h"

#include "core/scene_file/scene_file.h"

#include "tests/core/scene_texts.h"

#include <QFile>
#include <QTemporaryDir>

#ifndef Q_OS_WIN
#include <sys/stat.h>
#endif

using namespace unprojector::scene_file;
using namespace unprojector::base;
using namespace scene_texts;

namespace {

class Folder {
public:
    std::filesystem::path operator/(const QString &name) const
    {
        return std::filesystem::path(m_folder.filePath(name).toStdU16String());
    }
    void write(const QString &name, const QByteArray &contents) const
    {
        QFile file(m_folder.filePath(name));
        QVERIFY(file.open(QIODevice::WriteOnly) && file.write(contents) == contents.size());
    }
    QByteArray read(const QString &name) const
    {
        QFile file(m_folder.filePath(name));
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray("none");
    }
    QByteArray filePath(const QString &name) const { return m_folder.filePath(name).toUtf8(); }

private:
    QTemporaryDir m_folder;
};

SceneFile parsed(const char *text)
{
    return parseScene(text, "scene").value();
}

QByteArray textOf(const unprojector::base::Error &error)
{
    return QByteArray::fromStdString(error.message());
}

} // namespace

class TestSceneOnDisk : public QObject {
    Q_OBJECT

private slots:
    void scenesAreKnownByTheirContents_data()
    {
        addColumn<QByteArray>("text");
        addColumn<bool>("isScene");
        const auto row = [](const char *name, const QByteArray &text, bool isScene) {
            newRow(name) << text << isScene;
        };
        row("all keys", kFullScene, true);
        row("the least", kLeastScene, true);
        row("byte order mark", QByteArray("\xEF\xBB\xBF") + kLeastScene, true);
        row("many blanks before", QByteArray(1000, '\n') + kLeastScene, true);
        row("the key stands last", R"({"view": {"eye": [0, [1], {}]}, "window": null, "unprojector": 1})", true);
        row("of another version", R"({"unprojector": 2})", true);
        row("broken behind the key", "{\"unprojector\": 1, \"window\": ", true);
        row("too large to be read", "{\"unprojector\": 1, \"notes\": \"" + QByteArray(9 << 20, 'a') + "\"}", true);
        row("broken before the key", "{\"window\": }, \"unprojector\": 1}", false);
        row("glTF", R"({"asset": {"version": "2.0", "generator": "unprojector"}, "scenes": [{"nodes": [0]}]})", false);
        row("glTF that holds the word deeper",
            R"({"asset": {"version": "2.0"}, "extras": {"unprojector": 1}, "list": [{"unprojector": 1}]})", false);
        row("a list of scenes", "[" + QByteArray(kLeastScene) + "]", false);
        row("the word alone", R"("unprojector")", false);
        row("a number", "1", false);
        row("two documents", "{} " + QByteArray(kLeastScene), false);
        row("nothing", "", false);
        row("blanks", QByteArray(100, ' '), false);
        row("OBJ", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", false);
        row("brackets without end", QByteArray(1 << 20, '{'), false);
        row("lists without end", "{\"a\": " + QByteArray(1 << 20, '['), false);
        row("zero bytes", QByteArray(1000, '\0'), false);
    }

    void scenesAreKnownByTheirContents()
    {
        QFETCH(QByteArray, text);
        QFETCH(bool, isScene);
        const Folder folder;
        for (const char *name : {"scene.json", "scene", "scene.gltf", "scene.obj"}) {
            folder.write(name, text);
            QCOMPARE(isSceneFile(folder / name), isScene);
        }
        QCOMPARE(isSceneText({text.constData(), std::size_t(text.size())}), isScene);
    }

    void whatIsNoFileIsNoScene()
    {
        const Folder folder;
        QVERIFY(!isSceneFile(folder / "none"));
        QVERIFY(!isSceneFile(folder / "."));
        QVERIFY(!isSceneFile(""));
    }

    void pipesAreNotWaitedFor()
    {
#ifdef Q_OS_WIN
        QSKIP("no named pipes among the files");
#else
        const Folder folder;
        QCOMPARE(mkfifo(folder.filePath("pipe.json").constData(), 0600), 0);
        QVERIFY(!isSceneFile(folder / "pipe.json"));
        for (const std::filesystem::path &path : {folder / "pipe.json", std::filesystem::path("/dev/zero")}) {
            const auto scene = readSceneFile(path);
            QVERIFY(!scene && scene.error().kind == unprojector::base::Error::Kind::File);
            const auto written = writeSceneFile(path, parsed(kLeastScene));
            QVERIFY(!written && written.error().kind == unprojector::base::Error::Kind::File);
            QVERIFY(textOf(written.error()).endsWith(": this is a device or a pipe; give the name of a file"));
        }
#endif
    }

    void aModelOfTheSceneIsKept()
    {
        const Folder folder;
        folder.write("face.obj", "v 0 0 0\n");
        SceneFile scene = parsed(kFullScene);
        scene.objects[0].file = "face.obj";
        QVERIFY(writeSceneFile(folder / "scene.json", scene).hasValue());
        const auto written = writeSceneFile(folder / "face.obj", scene);
        QVERIFY(!written && written.error().subject == "objects[0].file");
        QCOMPARE(textOf(written.error()),
                 folder.filePath("face.obj")
                     + ": objects[0].file: the scene shows this model and would overwrite it; give another name");
        QCOMPARE(folder.read("face.obj"), QByteArray("v 0 0 0\n"));
    }

    void whatSomebodyElseWroteIsKept()
    {
        const Folder folder;
        const auto first = writeSceneFile(folder / "scene", parsed(kLeastScene));
        QVERIFY(first.hasValue());
        QCOMPARE(*first, stampOf(folder / "scene"));
        const auto second = writeSceneFile(folder / "scene", parsed(kFullScene), *first);
        QVERIFY(second.hasValue());
        const QByteArray text = folder.read("scene");
        const auto late = writeSceneFile(folder / "scene", parsed(kLeastScene), *first);
        QVERIFY(!late && late.error().kind == unprojector::base::Error::Kind::Changed);
        QVERIFY(
            textOf(late.error()).endsWith(": the file was changed by another program or window since it was opened"));
        QCOMPARE(folder.read("scene"), text);
    }

    void theSystemsReasonIsTold()
    {
#ifdef Q_OS_WIN
        QSKIP("the words are the system's");
#else
        const Folder folder;
        const auto written = writeSceneFile(folder / QString(256, 'a'), parsed(kLeastScene));
        QVERIFY(!written && written.error().kind == unprojector::base::Error::Kind::File);
        QVERIFY2(textOf(written.error()).endsWith("a: the file cannot be written (File name too long)"),
                 textOf(written.error()).constData());
        const auto read = readSceneFile(folder / QString(256, 'a'));
        QVERIFY(!read && read.error().kind == unprojector::base::Error::Kind::File);
        QVERIFY(textOf(read.error()).endsWith("a: the file cannot be read (File name too long)"));
        if (!QFile::exists("/proc/self/mem"))
            return;
        const auto broken = readSceneFile("/proc/self/mem"); // opens, and fails on its first byte
        QVERIFY(!broken && broken.error().kind == unprojector::base::Error::Kind::File);
        QVERIFY(textOf(broken.error()).endsWith("mem: the file cannot be read (Input/output error)"));
#endif
    }
};

UNPROJECTOR_TEST(TestSceneOnDisk)
#include "test_scene_on_disk.moc"
