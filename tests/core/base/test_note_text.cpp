// The import notes of commands about a model file.

#include "tests/support/test.h"

#include "core/base/translation.h"
#include "core/mesh/import/note_text.h"

#include <QRegularExpression>

using namespace unprojector;
using namespace unprojector::mesh;

class TestNoteText : public QObject {
    Q_OBJECT

private slots:
    void saysWhatIsNotAsInTheFile_data()
    {
        addColumn<int>("kind");
        addColumn<int>("count");
        addColumn<QByteArray>("detail");
        addColumn<QByteArray>("expected");
        const auto row = [](const char *name, ModelNote::Kind kind, int count, const char *detail,
                            const char *expected) {
            newRow(name) << int(kind) << count << QByteArray(detail) << QByteArray(expected);
        };
        using enum ModelNote::Kind;
        row("no picture", TextureMissing, 0, "皮.png",
            "the image \"皮.png\" is missing or cannot be read: its surfaces are shown without it");
        row("picture too large", TextureScaledDown, 8192, "a.png",
            "the image \"a.png\" is too large and is shown with a width of 8192 pixels");
        row("no materials", MaterialsMissing, 0, "a.mtl",
            "the materials \"a.mtl\" are missing or cannot be read: their surfaces are shown without colours and "
            "images");
        row("unknown material", MaterialUnknown, 1, "red",
            "no material is called \"red\": its surfaces are shown in grey");
        row("unknown materials", MaterialUnknown, 3, "red",
            "no material is called \"red\" or by 2 other names of the file: its surfaces are shown in grey");
        row("one line", LinesLeftOut, 1, "", "1 line or point is not shown");
        row("lines", LinesLeftOut, 3, "", "3 lines and points are not shown");
        row("a face", FacesLeftOut, 1, "", "1 face refers to vertices that the file does not have and cannot be shown");
        row("texture coordinates", TexcoordsLeftOut, 2, "",
            "2 faces refer to texture coordinates that the file does not have: shown without an image");
        row("normals", NormalsLeftOut, 2, "",
            "2 faces refer to normals that the file does not have: they are computed instead");
        row("words behind a vertex", NumbersLeftOut, 1, "",
            "1 vertex has words behind the coordinates that are not used");
        row("colours", ColorsUndeclared, 0, "",
            "the numbers behind the coordinates are used as colours, though the header does not declare any");
        row("a weight", WeightsLeftOut, 1, "",
            "1 vertex has a fourth number, the weight of rational curves: it is not used");
        row("an unknown line", LinesUnknown, 1, "\"V\" 7",
            "not used: 1 line that begins with a word unknown to the format, \"V\" 7");
        row("bytes at the end", BytesLeftOut, 7, "", "7 bytes behind all that the file declares are not used");
        row("a part", PartLeftOut, 0, "EXT_x", "\"EXT_x\" is not shown");
        row("a part, several times", PartLeftOut, 4, "curv", "\"curv\" is not shown (4 times)");
        row("flat triangles", FlatTriangles, 2, "",
            "not drawn: 2 triangles whose corners are equal or on one line in single precision");
        row("too small", TooSmallToDraw, 0, "1e-33",
            "cannot be drawn: graphics cards round 1e-33, which the model measures, to 0 or to few digits; scale it "
            "up");
        row("no scene", SceneMissing, 0, "", "the file has no scene: all its nodes are shown");
        row("no positions", PositionsMissing, 1, "", "1 part of a mesh has no positions and is not shown");
        row("unknown pictures", PictureUnknown, 2, "",
            "2 textures have neither PNG nor JPEG images: their surfaces are shown without them");
        row("an extension", ExtensionLeftOut, 0, "KHR_x",
            "the glTF extension \"KHR_x\", which the file requires, is not applied: the shape is whole without it, but "
            "colours, light, motion or data may be missing");
        row("an extension that may be missing", SubstituteShown, 0, "KHR_x",
            "the glTF extension \"KHR_x\" is not supported: the shape that the file has without it is shown");
        row("a skin", SkinsApplied, 1, "", "1 mesh has a skin: it is shown where the file's nodes have its joints");
        row("skins", SkinsApplied, 2, "",
            "2 meshes have skins: they are shown where the file's nodes have their joints");
        row("a node listed again", NodesListedAgain, 1, "",
            "the scene lists 1 node twice or beside its parent: it is shown once");
        row("nodes listed again", NodesListedAgain, 2, "",
            "the scene lists 2 nodes twice or beside their parents: each is shown once");
        row("a hidden mesh", MeshesHidden, 1, "",
            "1 mesh is hidden by the file (KHR_node_visibility) and is not shown");
        row("hidden meshes", MeshesHidden, 4, "",
            "4 meshes are hidden by the file (KHR_node_visibility) and are not shown");
        row("an element", ElementsLeftOut, 1, "polygon", "1 element \"polygon\" of the file is not read");
        row("elements", ElementsLeftOut, 3, "polygon", "3 elements \"polygon\" of the file are not read");
        row("a mesh elsewhere", NodesLeftOut, 1, "",
            "1 mesh is not in the scene that the file opens with and is not shown");
        row("meshes elsewhere", NodesLeftOut, 2, "",
            "2 meshes are not in the scene that the file opens with and are not shown");
        row("a corner", CornersLeftOut, 1, "",
            "1 corner at the end of a part of a mesh makes no whole triangle and is not used");
        row("corners", CornersLeftOut, 2, "",
            "2 corners at the ends of parts of meshes make no whole triangles and are not used");
        row("a file elsewhere", ReadOutside, 1, "../a.png",
            "the file \"../a.png\" outside the model's folder was read");
        row("two files elsewhere", ReadOutside, 2, "../a.png",
            "the file \"../a.png\" and 1 other one outside the model's folder were read");
        row("files elsewhere", ReadOutside, 3, "../a.png",
            "the file \"../a.png\" and 2 other ones outside the model's folder were read");
        row("a name that would steer a terminal", PartLeftOut, 0, "a\x1b[2J\nb", "\"a?[2J?b\" is not shown");
    }

    void saysWhatIsNotAsInTheFile()
    {
        QFETCH(int, kind);
        QFETCH(int, count);
        QFETCH(QByteArray, detail);
        QFETCH(QByteArray, expected);
        const std::string text =
            noteText({static_cast<ModelNote::Kind>(kind), static_cast<std::size_t>(count), detail.toStdString()});
        QCOMPARE(QByteArray::fromStdString(text), expected);
    }

    void saysItInChinese_data() { saysWhatIsNotAsInTheFile_data(); }

    /// Quoted text of the file stays untranslated.
    void saysItInChinese()
    {
        QFETCH(int, kind);
        QFETCH(int, count);
        QFETCH(QByteArray, detail);
        base::setLanguage(base::Language::Chinese);
        const QString text = QString::fromStdString(
            noteText({static_cast<ModelNote::Kind>(kind), static_cast<std::size_t>(count), detail.toStdString()}));
        base::setLanguage(base::Language::English);
        static const QRegularExpression words(QStringLiteral("\\b[a-z]{2,}[,;:]? [a-z]{2,}\\b"));
        QVERIFY2(!words.match(text).hasMatch(), qPrintable(text));
        QVERIFY2(count < 2 || text.contains(QString::number(count)) || text.contains(QString::number(count - 1)),
                 qPrintable(text));
    }
};

UNPROJECTOR_TEST(TestNoteText)
#include "test_note_text.moc"
