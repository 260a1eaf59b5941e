// The folders of the source and which of them may know which: read off the #include lines.
#include <QDirIterator>
#include <QFile>
#include <QMap>
#include <QRegularExpression>
#include <QSet>
#include <QTest>

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

QStringList includesOf(const QString &text)
{
    static const QRegularExpression include(QStringLiteral("^#include \"([^\"]+)\""),
                                            QRegularExpression::MultilineOption);
    QStringList files;
    for (auto it = include.globalMatch(text); it.hasNext();)
        files << it.next().captured(1);
    return files;
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

} // namespace

class TestRooms : public QObject {
    Q_OBJECT

private slots:
    void cyclesAreFound();
    void noRoomKnowsItselfByAnother();
    void nothingPointsBack();
    void everySourceLiesInARoom();
    void namespacesAreFolders();
};

/// A check that could find nothing would prove nothing.
void TestRooms::cyclesAreFound()
{
    QCOMPARE(cycleIn({{"a", {"b"}}, {"b", {"c"}}, {"c", {}}}), QString());
    QCOMPARE(cycleIn({{"a", {"b"}}, {"b", {"c"}}, {"c", {"b"}}}), QStringLiteral("b > c > b"));
}

void TestRooms::noRoomKnowsItselfByAnother()
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
void TestRooms::nothingPointsBack()
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

void TestRooms::everySourceLiesInARoom()
{
    for (const QString &file : sourcesUnder({"core", "gui"})) {
        if (file != QLatin1String("gui/main.cpp"))
            QVERIFY2(file.count(QLatin1Char('/')) >= 2, qPrintable(file + " lies outside the rooms"));
    }
}

/// core/geometry is unprojector::geometry, and so on; all of gui is unprojector::gui.
void TestRooms::namespacesAreFolders()
{
    static const QRegularExpression opening(QStringLiteral("^namespace unprojector(\\S*) \\{"),
                                            QRegularExpression::MultilineOption);
    for (const QString &file : sourcesUnder({"core", "gui"})) {
        const QString room = file.startsWith(QLatin1String("core/")) ? roomOf(file).mid(5) : QStringLiteral("gui");
        const QString text = textOf(file);
        for (auto it = opening.globalMatch(text); it.hasNext();) {
            const QString name = it.next().captured(1);
            QVERIFY2(name == "::" + room || name.startsWith("::" + room + "::"), qPrintable(file + ": " + name));
        }
    }
}

QTEST_GUILESS_MAIN(TestRooms)
#include "test_rooms.moc"
