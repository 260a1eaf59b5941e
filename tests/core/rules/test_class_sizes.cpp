// The size of each class, over all its files, read from the sources.
//
// Counted: classes and structs at the left margin or in a namespace that is not indented, as
// clang-format leaves them; their members by the names m_…; their lines in the header, and the
// files of the same folder that define their functions.
// Not counted: members without m_, and functions in the file of another class or folder.
#include "tests/support/test.h"

#include <QDir>
#include <QDirIterator>
#include <QFile>
#include <QMap>
#include <QRegularExpression>
#include <QSet>
#include <QTemporaryDir>

namespace {

constexpr int kMostLines = 800;
constexpr int kMostMembers = 25;

struct ClassSize {
    int lines = 0;
    int members = 0;
    QStringList slices; ///< other files that define its functions, and have no header
};

/// "SceneView" to "scene_view"
QString fileNameOf(const QString &className)
{
    static const QRegularExpression capital(QStringLiteral("(?<=[a-z0-9])([A-Z])"));
    return QString(className).replace(capital, QStringLiteral("_\\1")).toLower();
}

/// The members m_… in the body of a class: those outside of inner braces, so no function's.
QSet<QString> membersIn(const QString &body)
{
    QString outside;
    int depth = 0;
    for (const QChar c : body) {
        if (c == u'}')
            --depth;
        if (depth == 0)
            outside += c;
        if (c == u'{')
            ++depth;
    }
    static const QRegularExpression comment(QStringLiteral("//[^\n]*")), member(QStringLiteral("\\bm_\\w+"));
    QSet<QString> names;
    for (auto it = member.globalMatch(outside.remove(comment)); it.hasNext();)
        names.insert(it.next().captured());
    return names;
}

/// The classes of a header with their lines and members there.
QMap<QString, ClassSize> classesIn(const QString &header)
{
    static const QRegularExpression classes(
        QStringLiteral("^(?:class|struct) (?:alignas\\(\\w+\\) )?(\\w+)[^;{]*\\{(.*?)^\\};"),
        QRegularExpression::MultilineOption | QRegularExpression::DotMatchesEverythingOption);
    QMap<QString, ClassSize> found;
    for (auto it = classes.globalMatch(header); it.hasNext();) {
        const QRegularExpressionMatch match = it.next();
        found[match.captured(1)] = {
            int(match.captured().count(u'\n')) + 1, int(membersIn(match.captured(2)).size()), {}};
    }
    return found;
}

QString textOf(const QString &path)
{
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()) : QString();
}

/// All classes of the folders with the files that define their functions: the file named after the
/// class, and neighbours without a header.
QMap<QString, ClassSize> classesUnder(const QStringList &folders)
{
    QMap<QString, ClassSize> found;
    for (const QString &folder : folders) {
        QDirIterator it(folder, {"*.h"}, QDir::Files, QDirIterator::Subdirectories);
        while (it.hasNext()) {
            const QFileInfo header(it.next());
            const QMap<QString, ClassSize> classes = classesIn(textOf(header.filePath()));
            for (auto of = classes.cbegin(); of != classes.cend(); ++of) {
                ClassSize size = of.value();
                const QString own = fileNameOf(of.key());
                const QRegularExpression definition("^[^\\s/#].*\\b" + of.key() + "::~?\\w+\\(",
                                                    QRegularExpression::MultilineOption);
                for (const QFileInfo &file : header.dir().entryInfoList({"*.cpp"})) {
                    const QString stem = file.completeBaseName();
                    // A file with a header belongs to that header's class, e.g. SceneViewMenu's,
                    // regardless of its other definitions.
                    if (stem != own && QFile::exists(header.dir().filePath(stem + ".h")))
                        continue;
                    const QString source = textOf(file.filePath());
                    if (!definition.match(source).hasMatch())
                        continue;
                    size.lines += int(source.count(u'\n'));
                    if (stem != own)
                        size.slices << file.fileName();
                }
                if (ClassSize &known = found[of.key()]; size.lines > known.lines) // of two of one name the larger
                    known = size;
            }
        }
    }
    return found;
}

} // namespace

class TestClassSizes : public QObject {
    Q_OBJECT

private slots:
    void membersAreCounted()
    {
        const auto classes = classesIn(QStringLiteral("namespace a {\n"
                                                      "/// Text {\n"
                                                      "class Small : public QObject {\n"
                                                      "public:\n"
                                                      "    int x() const { return m_x + m_far; } // m_none\n"
                                                      "private:\n"
                                                      "    struct Inner {\n        int m_inner;\n    };\n"
                                                      "    int m_x = 0, m_y{3};\n"
                                                      "    std::function<int(int)> m_z; ///< as m_w\n"
                                                      "};\n"
                                                      "struct Plain {\n    int a;\n};\n}\n"));
        QCOMPARE(classes.size(), 2);
        QCOMPARE(classes["Small"].members, 3);
        QCOMPARE(classes["Small"].lines, 10);
        QCOMPARE(classes["Plain"].members, 0);
    }

    void slicesAreFound()
    {
        QTemporaryDir folder;
        const auto write = [&](const QString &name, const QByteArray &text) {
            QFile file(folder.filePath(name));
            QVERIFY(file.open(QIODevice::WriteOnly));
            file.write(text);
        };
        write("scene_view.h", "class SceneView {\n    int m_a;\n};\n");
        write("scene_view.cpp", "void SceneView::a()\n{\n}\n");
        write("scene_view_keys.cpp", "void SceneView::b()\n{\n}\n");
        write("scene_view_menu.h", "class SceneViewMenu {\n};\n");
        write("scene_view_menu.cpp", "void SceneViewMenu::c(SceneView::Kind)\n{\n}\n");
        const auto classes = classesUnder({folder.path()});
        QCOMPARE(classes["SceneView"].slices, QStringList{"scene_view_keys.cpp"});
        QCOMPARE(classes["SceneView"].lines, 9);
        QVERIFY(classes["SceneViewMenu"].slices.isEmpty());
    }

    void classesAreSmall()
    {
        const QString root = QStringLiteral(UNPROJECTOR_SOURCE_DIR "/");
        const auto classes = classesUnder({root + "core", root + "gui"});
        QVERIFY(classes.size() > 300);
        QVERIFY(classes.contains("SceneDocument"));
        QStringList wrong;
        for (auto it = classes.cbegin(); it != classes.cend(); ++it) {
            const ClassSize &is = it.value();
            if (is.lines > kMostLines || is.members > kMostMembers || !is.slices.isEmpty())
                wrong << QStringLiteral("%1 has %2 lines, %3 members%4")
                             .arg(it.key())
                             .arg(is.lines)
                             .arg(is.members)
                             .arg(is.slices.isEmpty() ? QString() : ", and is cut into " + is.slices.join(", "));
        }
        QVERIFY2(wrong.isEmpty(), qPrintable(wrong.join("\n")));
    }
};

UNPROJECTOR_TEST(TestClassSizes)
#include "test_class_sizes.moc"
