// No scene file takes memory out of proportion to its few bytes, however it is made.

#include "tests/support/test.h"

#include "core/scene_file/clicks.h"

#include "tests/core/parsed_scenes.h"
#include "tests/core/scene_texts.h"

#include <cstdlib>
#include <limits>
#include <new>

using namespace unprojector::scene_file;
using namespace scene_texts;

namespace {

/// Larger allocations fail while this test runs, so that a failure is a row and not a machine without
/// memory: the limit is more than one piece of a scene or of its text ever takes.
std::size_t mostBytesAtOnce = std::numeric_limits<std::size_t>::max();

} // namespace

#ifndef UNPROJECTOR_IS_SANITIZED // it has its own, which the other tests of this program need

void *operator new(std::size_t bytes)
{
    void *memory = bytes <= mostBytesAtOnce ? std::malloc(bytes > 0 ? bytes : 1) : nullptr;
    if (memory == nullptr)
        throw std::bad_alloc();
    return memory;
}

void operator delete(void *memory) noexcept
{
    std::free(memory);
}

void operator delete(void *memory, std::size_t) noexcept
{
    std::free(memory);
}

#endif

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
