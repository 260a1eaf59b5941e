// Notes about what a reader or writer changed.

#include "tests/support/test.h"

#include "core/base/note.h"
#include "core/base/translation.h"

using namespace unprojector;
using namespace unprojector::base;

namespace {

// Texts of core, so that they have a translation.
constexpr auto kScene = "the file has no scene: all its nodes are shown";
constexpr auto kElement = "%1 element \"%2\" of the file is not read";
constexpr auto kElements = "%1 elements \"%2\" of the file are not read";
constexpr auto kImage = "the image \"%1\" is missing or cannot be read: its surfaces are shown without it";

} // namespace

class TestNote : public QObject {
    Q_OBJECT

private slots:
    void isWordedWhenItIsShown()
    {
        const Note plain{kScene}, one{kElement, {"polygon"}, kElements, 1}, many{kElement, {"polygon"}, kElements, 3};
        QCOMPARE(plain.text(), kScene);
        QCOMPARE(one.text(), "1 element \"polygon\" of the file is not read");
        QCOMPARE(many.text(), "3 elements \"polygon\" of the file are not read");
        setLanguage(Language::Chinese);
        const std::string chinese = many.text(), picture = Note{kImage, {"皮.png"}}.text();
        setLanguage(Language::English);
        QCOMPARE(chinese, "文件中未读取的 “polygon” 元素：3");
        QCOMPARE(picture, "图片 “皮.png” 不存在或无法读取：其表面不带图片显示");
    }

    void escapesNamesThatWouldSteerATerminal()
    {
        QCOMPARE((Note{"%1 is not shown", {"a\x1b[2J\nb"}}.text()), "a\\x1b[2J\\x0ab is not shown");
    }

    void countsTheSameOnce()
    {
        std::vector<Note> notes;
        addNote(notes, 0, kElement, kElements, {"polygon"});
        QVERIFY(notes.empty());
        for (const char *name : {"polygon", "ring", "polygon"})
            addNote(notes, 2, kElement, kElements, {name});
        QCOMPARE(notes, (std::vector<Note>{{kElement, {"polygon"}, kElements, 4}, {kElement, {"ring"}, kElements, 2}}));
    }
};

UNPROJECTOR_TEST(TestNote)
#include "test_note.moc"
