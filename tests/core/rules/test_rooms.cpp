// The folders of the source and their allowed dependencies, read from the #include lines.
#include "tests/support/test.h"

#include <QDirIterator>
#include <QFile>
#include <QMap>
#include <QRegularExpression>
#include <QSet>

#include <algorithm>
#include <functional>

namespace {

using Graph = QMap<QString, QSet<QString>>;

/// The source files under these folders, relative to the project's.
QStringList sourcesUnder(const QStringList &folders)
{
    QStringList files;
    for (const QString &folder : folders) {
        QDirIterator it(QStringLiteral(UNPROJECTOR_SOURCE_DIR "/") + folder, {"*.h", "*.cpp", "*.inl"}, QDir::Files,
                        QDirIterator::Subdirectories);
        while (it.hasNext())
            files << QDir(QStringLiteral(UNPROJECTOR_SOURCE_DIR)).relativeFilePath(it.next());
    }
    return files;
}

QString textOf(const QString &file)
{
    QFile source(QStringLiteral(UNPROJECTOR_SOURCE_DIR "/") + file);
    return source.open(QIODevice::ReadOnly) ? QString::fromUtf8(source.readAll()) : QString();
}

QStringList matchesIn(const QString &text, const QRegularExpression &pattern)
{
    QStringList found;
    for (auto it = pattern.globalMatch(text); it.hasNext();)
        found << it.next().captured(1);
    return found;
}

QStringList includesOf(const QString &text)
{
    static const QRegularExpression include(QStringLiteral("^#include \"([^\"]+)\""),
                                            QRegularExpression::MultilineOption);
    return matchesIn(text, include);
}

/// The headers of libraries.
QStringList libraryIncludesOf(const QString &text)
{
    static const QRegularExpression include(QStringLiteral("^#include <([^>]+)>"), QRegularExpression::MultilineOption);
    return matchesIn(text, include);
}

/// The include path from a file to a library's header: "a.h > b.h > json.hpp"; empty if there is
/// none. @param textOf  the text of a file by its name
QString wayTo(const QString &header, const QString &file, const std::function<QString(const QString &)> &textOf,
              QSet<QString> &seen)
{
    seen.insert(file);
    const QString text = textOf(file);
    if (libraryIncludesOf(text).contains(header))
        return file + QStringLiteral(" > ") + header;
    for (const QString &next : includesOf(text)) {
        if (seen.contains(next))
            continue;
        if (const QString way = wayTo(header, next, textOf, seen); !way.isEmpty())
            return file + QStringLiteral(" > ") + way;
    }
    return {};
}

QString wayTo(const QString &header, const QString &file, const std::function<QString(const QString &)> &textOf)
{
    QSet<QString> seen;
    return wayTo(header, file, textOf, seen);
}

/// "core/unproject" of "core/unproject/batch/kernels.h": rooms are the folders of the second level.
QString roomOf(const QString &file)
{
    const QStringList parts = file.split(QLatin1Char('/'));
    return parts.size() > 2 ? parts[0] + QLatin1Char('/') + parts[1] : parts[0];
}

/// "a > b > a" for one way round, or nothing.
QString cycleIn(const Graph &graph)
{
    QSet<QString> done;
    QStringList path;
    std::function<QString(const QString &)> visit = [&](const QString &room) -> QString {
        if (const auto at = path.indexOf(room); at >= 0)
            return (path.mid(at) << room).join(QStringLiteral(" > "));
        if (done.contains(room))
            return {};
        path << room;
        for (const QString &next : graph.value(room)) {
            if (const QString cycle = visit(next); !cycle.isEmpty())
                return cycle;
        }
        path.removeLast();
        done.insert(room);
        return {};
    };
    for (const QString &room : graph.keys()) {
        if (const QString cycle = visit(room); !cycle.isEmpty())
            return cycle;
    }
    return {};
}

/// The first name in a source that the headers of Windows define as a macro, with its line;
/// comments and texts are left out.
QString macroOfWindowsIn(const QString &source)
{
    // Raw texts, comments, texts, letters; and the names.
    static const QRegularExpression words(
        QStringLiteral("R\"(\\w*)\\([\\s\\S]*?\\)\\1\"|//[^\\n]*|/\\*[\\s\\S]*?\\*/|\"(?:\\\\.|[^\"\\\\\\n])*\""
                       "|'(?:\\\\.|[^'\\\\\\n])'|\\b(near|far)\\b"));
    for (auto matches = words.globalMatch(source); matches.hasNext();) {
        const QRegularExpressionMatch match = matches.next();
        if (match.hasCaptured(2))
            return QStringLiteral("line %1: %2")
                .arg(QStringView(source).left(match.capturedStart()).count(QLatin1Char('\n')) + 1)
                .arg(match.captured(2));
    }
    return {};
}

} // namespace

class TestRooms : public QObject {
    Q_OBJECT

private slots:
    /// A check that could find nothing would prove nothing.
    void cyclesAreFound()
    {
        QCOMPARE(cycleIn({{"a", {"b"}}, {"b", {"c"}}, {"c", {}}}), QString());
        QCOMPARE(cycleIn({{"a", {"b"}}, {"b", {"c"}}, {"c", {"b"}}}), QStringLiteral("b > c > b"));
    }

    void noRoomKnowsItselfByAnother()
    {
        Graph graph;
        for (const QString &file : sourcesUnder({"core", "gui"})) {
            for (const QString &other : includesOf(textOf(file))) {
                if (other.contains(QLatin1Char('/')) && roomOf(other) != roomOf(file))
                    graph[roomOf(file)].insert(roomOf(other));
            }
        }
        QVERIFY(graph.size() > 10);
        QCOMPARE(cycleIn(graph), QString());
    }

    /// tests -> gui -> core, and the command knows no window.
    void nothingPointsBack()
    {
        for (const QString &file : sourcesUnder({"core", "gui"})) {
            for (const QString &other : includesOf(textOf(file))) {
                QVERIFY2(!other.startsWith(QLatin1String("tests/")), qPrintable(file));
                if (file.startsWith(QLatin1String("core/")))
                    QVERIFY2(!other.startsWith(QLatin1String("gui/")), qPrintable(file));
                else
                    QVERIFY2(!other.startsWith(QLatin1String("core/cli/")), qPrintable(file));
            }
        }
    }

    /// Code of one feature of the window that another one needs lies in a room that all of them know.
    /// The shell knows all features.
    void noFeatureKnowsAnother()
    {
        const QStringList common{"gui/document", "gui/text", "gui/view", "gui/widgets", "gui/window"};
        QSet<QString> features;
        for (const QString &file : sourcesUnder({"gui"})) {
            const QString room = roomOf(file);
            if (room == QLatin1String("gui") || room == QLatin1String("gui/shell"))
                continue;
            if (!common.contains(room))
                features.insert(room);
            for (const QString &other : includesOf(textOf(file))) {
                const QString known = roomOf(other);
                QVERIFY2(!known.startsWith(QLatin1String("gui")) || known == room || common.contains(known),
                         qPrintable(file + " includes " + other));
            }
        }
        QVERIFY(features.size() > 5);
        QVERIFY(features.contains(QStringLiteral("gui/landmarks")));
    }

    /// commands -> rows -> terminal.
    void theCommandsRoomsAreInOrder()
    {
        const QStringList order{"core/cli/terminal/", "core/cli/rows/", "core/cli/commands/"};
        const auto levelOf = [&order](const QString &file) {
            const auto found =
                std::find_if(order.begin(), order.end(), [&](const auto &room) { return file.startsWith(room); });
            return found - order.begin();
        };
        for (const QString &file : sourcesUnder({"core/cli"})) {
            for (const QString &other : includesOf(textOf(file))) {
                if (other.startsWith(QLatin1String("core/cli/")))
                    QVERIFY2(levelOf(other) <= levelOf(file), qPrintable(file + " includes " + other));
            }
        }
    }

    void everySourceLiesInARoom()
    {
        for (const QString &file : sourcesUnder({"core", "gui"})) {
            if (file != QLatin1String("gui/main.cpp"))
                QVERIFY2(file.count(QLatin1Char('/')) >= 2, qPrintable(file + " lies outside the rooms"));
        }
    }

    /// core/geometry is unprojector::geometry, and so on; all of gui is unprojector::gui. The library for
    /// other programs is unprojector itself.
    void namespacesAreFolders()
    {
        static const QRegularExpression opening(QStringLiteral("^namespace unprojector(\\S*) \\{"),
                                                QRegularExpression::MultilineOption);
        for (const QString &file : sourcesUnder({"core", "gui"})) {
            const QString room = file.startsWith(QLatin1String("core/")) ? roomOf(file).mid(5) : QStringLiteral("gui");
            const QString text = textOf(file);
            for (auto it = opening.globalMatch(text); it.hasNext();) {
                const QString name = it.next().captured(1);
                if (room == QLatin1String("library") && name.isEmpty())
                    continue;
                QVERIFY2(name == "::" + room || name.startsWith("::" + room + "::"), qPrintable(file + ": " + name));
            }
        }
    }

    void waysToHeavyHeadersAreFound()
    {
        const QMap<QString, QString> texts{{"a.h", "#include \"b.h\"\n"},
                                           {"b.h", "#include \"a.h\"\n#include <heavy.hpp>\n"},
                                           {"c.h", "#include <light.hpp>\n#include \"a.h\" // as <heavy.hpp>\n"}};
        const auto textOf = [&](const QString &file) { return texts.value(file); };
        QCOMPARE(wayTo("heavy.hpp", "a.h", textOf), QStringLiteral("a.h > b.h > heavy.hpp"));
        QCOMPARE(wayTo("heavy.hpp", "c.h", textOf), QStringLiteral("c.h > a.h > b.h > heavy.hpp"));
        QCOMPARE(wayTo("light.hpp", "a.h", textOf), QString());
    }

    /// Headers of libraries that take a second or more to compile, and the rooms and headers that may
    /// include them. A header of another room would pass them on to everything that includes it: most
    /// of the program includes scene.h and scene_document.h.
    void heavyHeadersStayInTheirRooms_data()
    {
        QTest::addColumn<QString>("header");
        QTest::addColumn<QStringList>("rooms");
        QTest::newRow("json") << "nlohmann/json.hpp" << QStringList{"core/scene_file", "core/mesh"};
        QTest::newRow("cli11") << "CLI/CLI.hpp" << QStringList{"core/cli"};
        QTest::newRow("multiprecision") << "boost/multiprecision/cpp_bin_float.hpp"
                                        << QStringList{"core/cli", "core/unproject/exact_unprojection.h"};
        QTest::newRow("property tree") << "boost/property_tree/xml_parser.hpp" << QStringList{};
        for (const char *header :
             {"QtCore", "QtGui", "QtWidgets", "QtOpenGL", "QtTest", "glm/glm.hpp", "glm/ext.hpp",
              "glm/gtc/quaternion.hpp", "glm/gtc/type_precision.hpp", "glm/gtx/transform.hpp", "regex", "iostream"})
            QTest::newRow(header) << header << QStringList{};
    }

    void heavyHeadersStayInTheirRooms()
    {
        QFETCH(QString, header);
        QFETCH(QStringList, rooms);
        int count = 0;
        for (const QString &file : sourcesUnder({"core", "gui"})) {
            if (!file.endsWith(QLatin1String(".h")) || rooms.contains(roomOf(file)) || rooms.contains(file))
                continue;
            ++count;
            const QString way = wayTo(header, file, textOf);
            QVERIFY2(way.isEmpty(), qPrintable(way));
        }
        QVERIFY(count > 200);
    }

    /// A header with "using namespace" passes the names of a namespace on to everything that includes
    /// it.
    void noHeaderTakesANamespace()
    {
        static const QRegularExpression directive(QStringLiteral("^\\s*(using namespace [\\w:]+)"),
                                                  QRegularExpression::MultilineOption);
        QCOMPARE(
            matchesIn(QStringLiteral("// using namespace a;\nusing b::c;\n    using namespace d::e;\n"), directive),
            QStringList{QStringLiteral("using namespace d::e")});
        for (const QString &file : sourcesUnder({"core", "gui", "tests"})) {
            if (!file.endsWith(QLatin1String(".cpp")))
                QVERIFY2(matchesIn(textOf(file), directive).isEmpty(), qPrintable(file));
        }
    }

    /// The dialogs of gui/widgets/file_dialogs.h start in the folder last used. Qt's own start where the
    /// program was started.
    void allFileDialogsStartInAKnownFolder()
    {
        const QStringList own{"gui/widgets/file_dialogs.cpp", "gui/widgets/save_name.cpp"};
        int count = 0;
        for (const QString &file : sourcesUnder({"gui"})) {
            const bool hasDialog = textOf(file).contains(QLatin1String("QFileDialog"));
            count += hasDialog ? 1 : 0;
            QVERIFY2(!hasDialog || own.contains(file), qPrintable(file));
        }
        QCOMPARE(count, own.size());
    }

    /// Each question opens a file on Linux, and a model can have 100,000 meshes: threads::coreCount()
    /// asks once.
    void theSystemIsAskedForItsCoresInOnePlace()
    {
        QStringList asking;
        for (const QString &file : sourcesUnder({"core", "gui"})) {
            if (textOf(file).contains(QLatin1String("hardware_concurrency")))
                asking << file;
        }
        QCOMPARE(asking, QStringList{"core/threads/parallel.cpp"});
    }

    /// Only PlainTextBox survives a paste of nothing.
    void allTextBoxesTakeAnEmptyClipboard()
    {
        static const QRegularExpression edited(
            "(?:new|public|make_unique<)\\s*(?:QPlainTextEdit|QTextEdit)\\b|QGraphicsTextItem|setReadOnly\\(false\\)|"
            "Qt::TextEdit(?:able|orInteraction)|^\\s*(?:QPlainTextEdit|QTextEdit) \\w+[;({]",
            QRegularExpression::MultilineOption);
        QStringList found;
        for (const QString &file : sourcesUnder({"gui"})) {
            if (file.startsWith(QLatin1String("gui/widgets/plain_text_box.")))
                continue;
            if (const auto match = edited.match(textOf(file)); match.hasMatch())
                found << file + QStringLiteral(": ") + match.captured();
        }
        QCOMPARE(found, QStringList());
    }

    void namesThatWindowsTakesAreFound()
    {
        QCOMPARE(macroOfWindowsIn(QStringLiteral("int a;\nfloat far = 1;\n")), QStringLiteral("line 2: far"));
        QCOMPARE(macroOfWindowsIn(QStringLiteral("f(R\"(near)\", 'x', near);")), QStringLiteral("line 1: near"));
        QCOMPARE(
            macroOfWindowsIn(QStringLiteral("// far\n/* near\n */ f(\"near \\\" far\", nearPlane, R\"a(far)a\");")),
            QString());
    }

    void noNameIsAMacroOfWindows()
    {
        for (const QString &file : sourcesUnder({"core", "gui", "tests"})) {
            const QString found = macroOfWindowsIn(textOf(file));
            QVERIFY2(found.isEmpty(), qPrintable(file + QStringLiteral(", ") + found));
        }
    }
};

UNPROJECTOR_TEST(TestRooms)
#include "test_rooms.moc"
