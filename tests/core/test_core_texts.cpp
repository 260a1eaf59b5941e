// What the core says in Chinese: that every text of its source has a translation, and how lines of it are laid out.
#include "core/text/columns.h"
#include "core/text/translation.h"

#include <QDirIterator>
#include <QFile>
#include <QJsonDocument>
#include <QJsonObject>
#include <QRegularExpression>
#include <QSet>
#include <QTest>

#include <algorithm>

using namespace unprojector;
using namespace unprojector::text;

namespace {

QString textOf(const QString &file)
{
    QFile source(file);
    return source.open(QIODevice::ReadOnly) ? QString::fromUtf8(source.readAll()) : QString();
}

/// The literal that begins here with a quote, as the compiler reads it; `at` is behind it then.
QString literal(const QString &code, qsizetype &at)
{
    QString text;
    for (++at; at < code.size() && code[at] != u'"'; ++at) {
        if (code[at] != u'\\') {
            text += code[at];
            continue;
        }
        ++at;
        text += code[at] == u'n' ? QChar(u'\n') : code[at];
    }
    ++at;
    return text;
}

/// The literals in the first argument of a call whose bracket is open; those side by side are one.
QStringList literalsOfCall(const QString &code, qsizetype at)
{
    QStringList texts;
    bool isBeside = false;
    for (int depth = 0; at < code.size();) {
        const QChar c = code[at];
        if (c == u'"') {
            const QString text = literal(code, at);
            if (isBeside)
                texts.last() += text;
            else
                texts << text;
            isBeside = true;
            continue;
        }
        if (c == u'\'')
            at += code[at + 1] == u'\\' ? 3 : 2;
        if (!c.isSpace())
            isBeside = false;
        depth += c == u'(' || c == u'{' ? 1 : c == u')' || c == u'}' ? -1 : 0;
        if (depth < 0 || (c == u',' && depth == 0))
            break;
        ++at;
    }
    return texts;
}

/// All that the core gives to tr() or marks for it.
QSet<QString> textsOfSource()
{
    static const QRegularExpression call(QStringLiteral("(?<![A-Za-z0-9_])(?:tr|marked)\\("));
    static const QRegularExpression comment(QStringLiteral("^\\s*//.*$"), QRegularExpression::MultilineOption);
    QSet<QString> texts;
    QDirIterator files(QStringLiteral(UNPROJECTOR_SOURCE_DIR "/core"), {"*.h", "*.cpp"}, QDir::Files,
                       QDirIterator::Subdirectories);
    while (files.hasNext()) {
        const QString code = textOf(files.next()).remove(comment);
        for (auto it = call.globalMatch(code); it.hasNext();) {
            for (const QString &text : literalsOfCall(code, it.next().capturedEnd()))
                texts << text;
        }
    }
    return texts;
}

QJsonObject catalogue()
{
    return QJsonDocument::fromJson(
               textOf(QStringLiteral(UNPROJECTOR_SOURCE_DIR "/resources/translations/unproject_zh_CN.json")).toUtf8())
        .object();
}

QStringList placesOf(const QString &text)
{
    static const QRegularExpression place(QStringLiteral("%[1-9]"));
    QSet<QString> places;
    for (auto it = place.globalMatch(text); it.hasNext();)
        places << it.next().captured();
    QStringList sorted(places.begin(), places.end());
    sorted.sort();
    return sorted;
}

} // namespace

class TestCoreTexts : public QObject {
    Q_OBJECT

private slots:
    void everyTextHasATranslationAndNoneIsLeftOver();
    void placesOfValuesAgree();
    void textsAreSaidInTheLanguageThatIsSet();
    void valuesStandInTheirPlaces();
    void aTextIsSaidAgain();
    void wideCharactersTakeTwoColumns();
    void linesAreWrappedBetweenCharacters_data();
    void linesAreWrappedBetweenCharacters();
};

void TestCoreTexts::everyTextHasATranslationAndNoneIsLeftOver()
{
    const QSet<QString> texts = textsOfSource();
    const QStringList keys = catalogue().keys();
    const QSet<QString> translated(keys.begin(), keys.end());
    QVERIFY(texts.size() > 100);
    QCOMPARE((texts - translated).values(), QStringList());
    QCOMPARE((translated - texts).values(), QStringList());
}

void TestCoreTexts::placesOfValuesAgree()
{
    const QJsonObject texts = catalogue();
    for (auto it = texts.begin(); it != texts.end(); ++it) {
        QVERIFY2(!it.value().toString().isEmpty(), qPrintable(it.key()));
        QCOMPARE(placesOf(it.value().toString()), placesOf(it.key()));
    }
}

void TestCoreTexts::textsAreSaidInTheLanguageThatIsSet()
{
    QCOMPARE(text::tr("Usage"), std::string("Usage"));
    setLanguage(Language::Chinese);
    QCOMPARE(text::tr("Usage"), std::string("用法"));
    {
        const InEnglish english;
        QCOMPARE(text::tr("Usage"), std::string("Usage"));
    }
    QCOMPARE(text::tr("Usage"), std::string("用法"));
    const std::string unknown = "said by nobody";
    QCOMPARE(text::tr(unknown), unknown);
    setLanguage(Language::English);
}

void TestCoreTexts::valuesStandInTheirPlaces()
{
    QCOMPARE(text::tr("99 % of %2 are %1", "%2", 7), std::string("99 % of 7 are %2"));
    QCOMPARE(filled("%1%3", {"a"}), std::string("a%3"));
    QCOMPARE(filled("%", {"a"}), std::string("%"));
}

/// What a mesh's reader has noted is English, and said in Chinese later.
void TestCoreTexts::aTextIsSaidAgain()
{
    using Values = std::vector<std::string>;
    QCOMPARE(valuesIn("ratio 1.5, flipped", "ratio %1, flipped"), std::optional(Values{"1.5"}));
    QCOMPARE(valuesIn("a, b of c", "%1, %2 of %3"), std::optional(Values{"a", "b", "c"}));
    QCOMPARE(valuesIn("right", "right"), std::optional(Values{}));
    QCOMPARE(valuesIn("rightly", "right"), std::optional<Values>());
    QCOMPARE(valuesIn("ratio ", "ratio %1"), std::optional<Values>());
    QCOMPARE(valuesIn("a of ", "%1 of %2"), std::optional<Values>());
    QCOMPARE(valuesIn("", "%1"), std::optional<Values>());

    const std::initializer_list<std::string_view> patterns{"ratio %1", "to %1 bits"};
    QCOMPARE(saidAgain("to 16 bits", patterns), std::string("to 16 bits"));
    setLanguage(Language::Chinese);
    QCOMPARE(saidAgain("to 16 bits", patterns), std::string("舍入到 16 位"));
    QCOMPARE(saidAgain("to few bits", {}), std::string("to few bits"));
    setLanguage(Language::English);
}

void TestCoreTexts::wideCharactersTakeTwoColumns()
{
    QCOMPARE(columnsOf("a 点，"), std::size_t(6));
    QCOMPARE(columnsOf("“±”"), std::size_t(3));
    QCOMPARE(padded("点", 4), std::string("点  "));
    QCOMPARE(padded("world", 4), std::string("world"));
    QCOMPARE(paddedLeft("点", 4), std::string("  点"));
}

void TestCoreTexts::linesAreWrappedBetweenCharacters_data()
{
    QTest::addColumn<QString>("text");
    QTest::addColumn<int>("columns");
    QTest::addColumn<int>("indent");
    QTest::addColumn<QString>("wrapped");

    QTest::newRow("fits") << "一二三" << 6 << 0 << "一二三";
    QTest::newRow("too-long") << "一二三四" << 7 << 0 << "一二三\n四";
    QTest::newRow("no-sign-first") << "一二三，四" << 6 << 0 << "一二\n三，四";
    QTest::newRow("no-opening-last") << "一二（三四" << 6 << 0 << "一二\n（三四";
    QTest::newRow("words-stay-whole") << "一 world二" << 6 << 0 << "一\nworld\n二";
    QTest::newRow("blank-at-the-end") << "ab cd" << 2 << 0 << "ab\ncd";
    QTest::newRow("word-too-long") << "abcdef 一" << 4 << 0 << "abcdef\n一";
    QTest::newRow("indented") << "一二三" << 6 << 2 << "一二\n  三";
    QTest::newRow("own-line-ends") << "一\n\n二" << 6 << 2 << "一\n\n  二";
}

void TestCoreTexts::linesAreWrappedBetweenCharacters()
{
    QFETCH(QString, text);
    QFETCH(int, columns);
    QFETCH(int, indent);
    QFETCH(QString, wrapped);
    QCOMPARE(QString::fromStdString(
                 unprojector::text::wrapped(text.toStdString(), std::size_t(columns), std::size_t(indent))),
             wrapped);
}

QTEST_APPLESS_MAIN(TestCoreTexts)
#include "test_core_texts.moc"
