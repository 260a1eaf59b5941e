// What commands say about a model file that is not shown as it is.

#include "core/mesh_import/note_text.h"

#include <QTest>

using namespace unprojector;
using namespace unprojector::mesh_import;
using namespace unprojector::scene;

class TestNoteText : public QObject {
    Q_OBJECT

private slots:
    void saysWhatIsNotAsInTheFile_data();
    void saysWhatIsNotAsInTheFile();
};

void TestNoteText::saysWhatIsNotAsInTheFile_data()
{
    QTest::addColumn<int>("kind");
    QTest::addColumn<int>("count");
    QTest::addColumn<QByteArray>("detail");
    QTest::addColumn<QByteArray>("expected");
    const auto row = [](const char *name, ModelNote::Kind kind, int count, const char *detail, const char *expected) {
        QTest::newRow(name) << int(kind) << count << QByteArray(detail) << QByteArray(expected);
    };
    using enum ModelNote::Kind;
    row("no picture", TextureMissing, 0, "皮.png",
        "the picture \"皮.png\" is not there or cannot be read: its surfaces are shown without it");
    row("picture too large", TextureScaledDown, 8192, "a.png",
        "the picture \"a.png\" is too large and is shown with a width of 8192 pixels");
    row("no materials", MaterialsMissing, 0, "a.mtl",
        "the materials \"a.mtl\" are not there or cannot be read: their surfaces are shown without colours and "
        "pictures");
    row("unknown material", MaterialUnknown, 1, "red", "no material is called \"red\": its surfaces are shown in grey");
    row("unknown materials", MaterialUnknown, 3, "red",
        "no material is called \"red\" or by 2 other names of the file: its surfaces are shown in grey");
    row("one line", LinesLeftOut, 1, "", "1 line or point is not shown");
    row("lines", LinesLeftOut, 3, "", "3 lines and points are not shown");
    row("a face", FacesLeftOut, 1, "", "1 face refers to vertices that the file does not have and cannot be shown");
    row("texture coordinates", TexcoordsLeftOut, 2, "",
        "2 faces refer to texture coordinates that the file does not have: shown without a picture");
    row("normals", NormalsLeftOut, 2, "",
        "2 faces refer to normals that the file does not have: they are computed instead");
    row("words behind a vertex", NumbersLeftOut, 1, "", "1 vertex has words behind the coordinates that are not used");
    row("bytes at the end", BytesLeftOut, 7, "", "7 bytes behind all that the file declares are not used");
    row("a part", PartLeftOut, 0, "EXT_x", "\"EXT_x\" is not shown");
    row("a part, several times", PartLeftOut, 4, "curv", "\"curv\" is not shown (4 times)");
    row("a useless part", PartUnusable, 0, "TEXCOORD_1 without a picture", "not used: TEXCOORD_1 without a picture");
    row("a name that would steer a terminal", PartLeftOut, 0, "a\x1b[2J\nb", "\"a?[2J?b\" is not shown");
}

void TestNoteText::saysWhatIsNotAsInTheFile()
{
    QFETCH(int, kind);
    QFETCH(int, count);
    QFETCH(QByteArray, detail);
    QFETCH(QByteArray, expected);
    const std::string text =
        noteText({static_cast<ModelNote::Kind>(kind), static_cast<std::size_t>(count), detail.toStdString()});
    QCOMPARE(QByteArray::fromStdString(text), expected);
}

QTEST_APPLESS_MAIN(TestNoteText)
#include "test_note_text.moc"
