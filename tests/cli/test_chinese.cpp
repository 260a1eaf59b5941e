// The command in Chinese: the choice of the language, and no English left in the help.

#include "tests/support/test.h"

#include "core/base/columns.h"
#include "core/cli/terminal/language_choice.h"
#include "tests/cli/command.h"

#include <QRegularExpression>

using namespace unprojector;
using cli::LanguageWishes;

namespace {

const Variables kChinese{{"LC_ALL", "zh_CN.UTF-8"}};

const char *const kCommands[] = {"points",  "pick", "project",  "info", "scene",     "cloud",
                                 "compare", "map",  "matrices", "code", "landmarks", "doctor"};

/// Returns whether the line has two English words side by side, apart from typed ones: commands,
/// and options with their values.
bool hasEnglish(QString line)
{
    static const QRegularExpression typed(QStringLiteral("unproject [a-z]+|--[a-z-]+ [a-z]+"));
    static const QRegularExpression words(QStringLiteral("\\b[a-z]{2,} [a-z]{2,}\\b"));
    return words.match(line.remove(typed)).hasMatch();
}

bool isExample(const QString &line)
{
    static const QRegularExpression start(QStringLiteral("^  +(?:unproject|printf|parallel|projection) "));
    return start.match(line).hasMatch();
}

/// The line without a list of words at its end, which the program adds unfolded: "…：double, float"
/// behind a description, "…：--table --repeats" behind an option.
QString withoutList(QString line)
{
    static const QRegularExpression list(QStringLiteral("(?:[\\w.-]+,? )+[\\w.-]*$"));
    return line.remove(list);
}

/// Returns whether a line of the help has its description in the column of those that continue it,
/// or has none because that begins in the next line.
bool isInColumn(const std::string &line, const QString &next)
{
    constexpr std::size_t kDescriptions = 30;
    const std::string_view start = base::firstColumns(line, kDescriptions);
    const std::string_view head = start.substr(0, start.find_last_not_of(' ') + 1);
    if (base::columnsOf(start) == kDescriptions && head.size() < start.size())
        return head.find("  ", 2) == head.npos && line.size() > start.size() && line[start.size()] != ' ';
    static const QRegularExpression description(QStringLiteral("^ {30}[^ ]"));
    return base::columnsOf(line) >= kDescriptions && line.find("  ", 2) == line.npos
           && description.match(next).hasMatch();
}

} // namespace

class TestChinese : public QObject {
    Q_OBJECT

private slots:
    void theLanguageIsTheUsers_data()
    {
        addColumn<QStringList>("wishes"); // LC_ALL, LC_MESSAGES, LANG, LANGUAGE, the system's
        addColumn<bool>("isChinese");

        newRow("nothing") << QStringList{"", "", "", "", ""} << false;
        newRow("lang") << QStringList{"", "", "zh_CN.UTF-8", "", ""} << true;
        newRow("messages-before-lang") << QStringList{"", "zh_CN.UTF-8", "en_US.UTF-8", "", ""} << true;
        newRow("all-before-messages") << QStringList{"en_US.UTF-8", "zh_CN.UTF-8", "zh_CN.UTF-8", "", ""} << false;
        newRow("list-before-all") << QStringList{"en_US.UTF-8", "", "", "zh_CN", ""} << true;
        newRow("first-of-list") << QStringList{"zh_CN.UTF-8", "", "", "en:zh_CN", ""} << false;
        newRow("first-known-of-list") << QStringList{"de_DE.UTF-8", "", "", "de:zh_CN:en", ""} << true;
        newRow("none-known-of-list") << QStringList{"zh_CN.UTF-8", "", "", "de:fr", ""} << false;
        newRow("c-before-list") << QStringList{"C", "", "zh_CN.UTF-8", "zh_CN", ""} << false;
        newRow("c-utf8-before-list") << QStringList{"C.UTF-8", "", "", "zh_CN", ""} << false;
        newRow("posix") << QStringList{"POSIX", "", "zh_CN.UTF-8", "", ""} << false;
        newRow("list-alone") << QStringList{"", "", "", "zh_CN", ""} << false;
        newRow("no-encoding") << QStringList{"", "", "zh_CN", "", ""} << true;
        newRow("utf8-otherwise") << QStringList{"", "", "zh_CN.utf8@pinyin", "", ""} << true;
        newRow("other-encoding") << QStringList{"", "", "zh_CN.GB18030", "", ""} << false;
        newRow("singapore") << QStringList{"", "", "zh_SG.UTF-8", "", ""} << true;
        newRow("traditional") << QStringList{"", "", "zh_TW.UTF-8", "", ""} << false;
        newRow("system") << QStringList{"", "", "", "", "zh-CN:en-US"} << true;
        newRow("system-with-script") << QStringList{"", "", "", "", "zh-Hans-CN"} << true;
        newRow("system-english-first") << QStringList{"", "", "", "", "en-US:zh-CN"} << false;
        newRow("environment-before-system") << QStringList{"", "", "en_US.UTF-8", "", "zh-CN"} << false;
    }

    void theLanguageIsTheUsers()
    {
        QFETCH(QStringList, wishes);
        QFETCH(bool, isChinese);
        const LanguageWishes given{wishes[0].toStdString(), wishes[1].toStdString(), wishes[2].toStdString(),
                                   wishes[3].toStdString(), wishes[4].toStdString()};
        QCOMPARE(cli::chosenLanguage(given) == base::Language::Chinese, isChinese);
    }

    void helpIsChinese_data()
    {
        addColumn<QStringList>("words");
        newRow("program") << QStringList{"--help"};
        for (const char *command : kCommands)
            newRow(command) << QStringList{command, "--help"};
    }

    void helpIsChinese()
    {
        QFETCH(QStringList, words);
        const Run run = runCommand(words, {}, kChinese);
        VERIFY_SUCCEEDED(run);
        const QString help = QString::fromUtf8(run.output);
        QVERIFY(help.contains(QStringLiteral("\n用法：unproject")));
        QVERIFY(help.contains(QStringLiteral("\n选项：\n")));
        QVERIFY(!help.contains(QChar::ReplacementCharacter));
        const QStringList lines = help.split(u'\n');
        const QStringList headings{QStringLiteral("参数："), QStringLiteral("选项："), QStringLiteral("命令：")};
        bool isEntry = false;
        for (qsizetype i = 0; i < lines.size(); ++i) {
            const QString &line = lines[i];
            if (isExample(line))
                continue;
            QVERIFY2(!hasEnglish(line), qPrintable(line));
            QVERIFY2(base::columnsOf(withoutList(line).toStdString()) <= 80, qPrintable(line));
            if (!line.startsWith(u' '))
                isEntry = headings.contains(line);
            QVERIFY2(!isEntry || !line.startsWith(u' ') || isInColumn(line.toStdString(), lines.value(i + 1)),
                     qPrintable(line));
        }
    }

    /// A user who prefers English gets it byte for byte, in any locale.
    void englishIsNotTouched()
    {
        for (const QStringList &words : {QStringList{"--help"}, QStringList{"map", "--help"}}) {
            const Run english = runCommand(words, {}, {{"LC_ALL", "C"}});
            const Run preferred = runCommand(words, {}, {{"LC_ALL", "zh_CN.UTF-8"}, {"LANGUAGE", "en"}});
            QVERIFY(english.output.contains("\nUsage: unproject"));
            QCOMPARE(preferred.output, english.output);
        }
    }
};

UNPROJECTOR_TEST(TestChinese)
#include "test_chinese.moc"
