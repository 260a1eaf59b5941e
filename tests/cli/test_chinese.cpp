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
        QVERIFY(help.contains(QStringLiteral("\n用法: unproject")));
        QVERIFY(!help.contains(QChar::ReplacementCharacter));
        for (const QString &line : help.split(u'\n')) {
            if (isExample(line))
                continue;
            QVERIFY2(!hasEnglish(line), qPrintable(line));
            const bool isOption = line.startsWith(QStringLiteral("  "));
            QVERIFY2(isOption || base::columnsOf(line.toStdString()) <= 80, qPrintable(line));
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
