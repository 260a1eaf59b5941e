// The command by cases: the texts in tests/data/commands.
//
//     # a comment, such as why a number is right
//     -- box.obj             a file of all cases below; its lines follow, indented by four blanks
//     == a model             a case; its folder has these files
//     $ info "a b.obj"       a run: `LC_ALL=zh_CN.UTF-8 info …` sets a variable, `points … > a.csv` writes a file
//     < px,py                a line of its standard input
//     > {"vertices": 8}      a line of its output
//     ! stdin: is empty      a line of its messages
//     >> out.csv             the lines > below are this file's; `>> a.csv = b.csv`: it is the same as b.csv
//     = 1                    its exit code; left out: 0
//
// What is not written down is not there: no other output, no changed and no further file. Texts are exact, but
// `...` is any text in a line, or any lines if alone, and 6±1e-9 a number from 6 - 1e-9 to 6 + 1e-9. \xNN is a byte,
// \x without digits nothing, and a line that ends with \ has no line end.

#include "tests/support/test.h"

#include "tests/cli/command.h"

#include <QDirIterator>
#include <QRegularExpression>

#include <cmath>
#include <utility>

namespace {

using Texts = QMap<QString, QByteArray>;

QByteArray unescaped(const QString &line)
{
    const bool isOpen = line.endsWith('\\');
    QByteArray text = line.chopped(isOpen ? 1 : 0).toUtf8();
    for (qsizetype at = 0; (at = text.indexOf("\\x", at)) >= 0; ++at)
        text.replace(at, 4, QByteArray::fromHex(text.mid(at + 2, 2)));
    return isOpen ? text : text + '\n';
}

void verify(const QByteArray &text, const QByteArray &expected)
{
    static const QString number(R"(([-+]?[0-9]*\.?[0-9]+(?:e[-+]?[0-9]+)?))");
    static const QRegularExpression around(number + R"(\xC2\xB1)" + number);
    const QString all = '\n' + QString::fromLatin1(expected);
    QString pattern = QRegularExpression::escape(QString(all).replace(around, "\1"));
    pattern.replace("\\\1", "(?<![0-9.])" + number + "(?![0-9])");
    // Each "..." ends where the text behind it is first found: that takes no time.
    pattern.replace("\\\n\\.\\.\\.\\\n", "\n)(?>(?s:.*?)(?:(?<=\n)|\\z)").replace("\\.\\.\\.", ")(?>[^\n]*?");
    const auto found = QRegularExpression("\\A(?>" + pattern + "\\z)").match('\n' + QString::fromLatin1(text));
    bool isExpected = found.hasMatch();
    int i = 0;
    for (auto it = around.globalMatch(all); it.hasNext() && isExpected;) {
        const QRegularExpressionMatch goal = it.next();
        const double difference = found.captured(++i).toDouble() - goal.captured(1).toDouble();
        isExpected = std::abs(difference) <= goal.captured(2).toDouble();
    }
    QVERIFY2(isExpected, "expected\n" + expected + "\nfound\n" + text);
}

/// @param said   the text of a run by the sign of its lines; ">> NAME" for a file
/// @param files  in the folder; they become those that the run leaves
void verifyRun(Texts said, const Folder &folder, Texts &files)
{
    const QStringList command = QString::fromUtf8(said.take("$")).split(" > ");
    QStringList words = QProcess::splitCommand(command[0]);
    for (QString &word : words)
        word = QString::fromUtf8(unescaped(word).chopped(1));
    Variables variables{{"LC_ALL", "C"}};
    for (; words.value(0).contains('='); words.removeFirst())
        variables[words[0].section('=', 0, 0)] = words[0].section('=', 1);
    for (auto it = files.begin(); it != files.end(); ++it) {
        QDir().mkpath(QFileInfo(folder.path(it.key())).path());
        folder.write(it.key(), it.value());
    }
    QDir::setCurrent(folder.path("."));
    const Run run = runCommand(words, said.take("<"), variables);
    QDir::setCurrent(QDir::rootPath()); // a system may keep a folder that a process is in
    verify(run.errors, said.take("!"));
    bool isNumber = true;
    const int exitCode = said.contains("=") ? said.take("=").trimmed().toInt(&isNumber) : 0;
    QVERIFY2(isNumber, "the exit code is one number");
    QCOMPARE(run.exitCode, exitCode);
    Texts found;
    for (QDirIterator it(folder.path("."), QDir::Files | QDir::Hidden, QDirIterator::Subdirectories); it.hasNext();) {
        QFile file(it.next());
        QVERIFY(file.open(QIODevice::ReadOnly));
        found[QDir(folder.path(".")).relativeFilePath(file.fileName())] = file.readAll();
    }
    found[command.value(1)] = files[command.value(1)] = run.output; // no name: it goes to no file
    said[">"];                                                      // silence is expected as well
    for (auto it = said.begin(); it != said.end(); ++it) {
        const QStringList names = it.key().mid(3).split(" = ");
        for (const QString &name : names)
            QVERIFY2(name.isEmpty() || found.contains(name), qUtf8Printable("there is no " + name)); // "": no output
        files[names[0]] = found[names[0]];
        if (names.size() > 1)
            QCOMPARE(found[names[0]], found[names[1]]);
        else
            verify(found[names[0]], it.value());
    }
    QCOMPARE(found.keys(), files.keys());
    QVERIFY2(found == files, "a file has changed");
    files.remove("");
}

} // namespace

class TestCommands : public QObject {
    Q_OBJECT

private slots:
    void cases_data()
    {
        addColumn<QStringList>("lines");
        static const QRegularExpression ofFiles("^(?:(?:   |--) .*|#.*)?$");
        const QString chosen = qEnvironmentVariable("CASES", "*") + ".txt";
        const QFileInfoList infos = QDir(UNPROJECTOR_TEST_DATA "/commands").entryInfoList({chosen}, QDir::Files);
        QVERIFY2(!infos.isEmpty(), qPrintable("there is no " + chosen));
        for (const QFileInfo &info : infos) {
            QFile file(info.filePath());
            QVERIFY(file.open(QIODevice::ReadOnly | QIODevice::Text));
            QStringList cases = ('\n' + QString::fromUtf8(file.readAll())).split("\n== ");
            QVERIFY2(cases.size() > 1, qPrintable(info.fileName() + ": no case"));
            QStringList files = cases.takeFirst().split('\n'), names;
            for (const QString &text : cases) {
                const qsizetype end = (text + "\n-- ").indexOf("\n-- ");
                const QStringList lines = files + text.left(end).split('\n').mid(1) + QStringList("$");
                const QString name = info.baseName() + ": " + text.section('\n', 0, 0);
                QVERIFY2(!names.contains(name), qPrintable(name + ": the name is there twice"));
                newRow(qUtf8Printable(names.emplaceBack(name))) << lines;
                files += text.mid(end).split('\n');
            }
            for (const QString &line : files)
                QVERIFY2(ofFiles.match(line).hasMatch(), qPrintable(info.fileName() + ": a file's line? " + line));
        }
    }

    void cases()
    {
        QFETCH(QStringList, lines);
        static const QRegularExpression known("^(?:(   |--|>>|[$<>!=])(?: (.*))?|#.*)?$");
        const Folder folder;
        Texts files, said;
        QString file, output;
        int runs = -1; // the last line ends the last run
        for (const QString &line : lines) {
            const QRegularExpressionMatch parts = known.match(line);
            QVERIFY2(parts.hasMatch(), qUtf8Printable("unreadable: " + line));
            const QString sign = parts.captured(1), rest = parts.captured(2);
            if (sign == "$" && ++runs > 0)
                verifyRun(std::exchange(said, {}), folder, files);
            if (QTest::currentTestFailed())
                return;
            if (sign == "$")
                said[output = sign] = rest.toUtf8();
            else if (sign == "--")
                files[file = rest].clear();
            else if (sign == "   ")
                files[file] += unescaped(rest);
            else if (sign == ">>")
                said[output = line].clear();
            else if (!sign.isEmpty())
                said[sign == ">" && output != "$" ? output : sign] += unescaped(rest);
        }
        QVERIFY2(runs > 0, "no run");
    }
};

UNPROJECTOR_TEST(TestCommands, threads, each commands)
#include "test_commands.moc"
