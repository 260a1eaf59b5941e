// No scene file takes memory out of proportion to its few bytes, however it is made.

#include "tests/support/test.h"

#include "core/scene_file/clicks.h"

#include "tests/core/parsed_scenes.h"
#include "tests/core/scene/limited_memory.h"
#include "tests/core/scene_texts.h"

#include <limits>

using namespace unprojector::scene_file;
using namespace scene_texts;

class TestSceneMemory : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { mostBytesAtOnce = std::size_t{256} << 20; }
    void cleanupTestCase() { mostBytesAtOnce = std::numeric_limits<std::size_t>::max(); }
    void aLargeFileTakesLittleMemory_data()
    {
        addColumn<QByteArray>("text");
        addColumn<QByteArray>("message");
        constexpr qsizetype most =
            tests::rounds((8 << 20) - 1000); // memory grows with the text: as much as a test may take
        const auto many = [](const QByteArray &element, qsizetype bytes) {
            return '[' + (element + ',').repeated(bytes / (element.size() + 1)).chopped(1) + ']';
        };
        const auto row = [](const char *name, const QByteArray &text, const char *message) {
            newRow(name) << text << QByteArray(message);
        };
        const char *const noObject = "scene.json: objects[0]: expected an object in { }, found 0";
        row("numbers for clicks", many("0", most), "scene.json: [0]: expected an object in { }, found 0");
        row("numbers for objects", withMember("\"objects\": " + many("0", most)), noObject);
        row("numbers for steps", withMember("\"objects\": [{\"file\": \"a\", \"transform\": " + many("0", most) + "}]"),
            "scene.json: objects[0].transform[0]: expected an object in { }, found 0");
        row("numbers for planes", withMember("\"clipPlanes\": " + many("0", 4000002)),
            "scene.json: clipPlanes: has 2000001 elements; there may be at most 6");
        row("numbers for planes that do not cut", withMember("\"ui\": {\"clipPlanesOff\": " + many("0", 4000002) + "}"),
            "scene.json: ui.clipPlanesOff: has 2000001 elements; there may be at most 6");
        row("as many objects as there can be", withMember("\"objects\": " + many("{\"file\":\"a\"}", most)),
            "it was read");
    }

    void aLargeFileTakesLittleMemory()
    {
        QFETCH(QByteArray, text);
        QFETCH(QByteArray, message);
        try {
            const auto read =
                parseSceneOrClicks(std::string_view(text.constData(), std::size_t(text.size())), "scene.json");
            QCOMPARE(read ? QByteArray("it was read") : messageWithoutPlace(read.error()), message);
        } catch (const std::bad_alloc &) {
            QFAIL("it takes too much memory");
        }
    }
};

UNPROJECTOR_TEST(TestSceneMemory)
#include "test_scene_memory.moc"
