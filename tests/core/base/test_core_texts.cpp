// The Chinese texts of core: every text of its source has a translation, and the layout of lines of
// Chinese is right.
#include "tests/support/test.h"

#include "core/base/columns.h"
#include "core/base/printable.h"
#include "core/base/translation.h"
#include "core/geometry/error_text.h"

#include <QDirIterator>
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QRegularExpression>
#include <QSet>
#include <QXmlStreamReader>

#include <algorithm>
#include <thread>

using namespace unprojector;
using namespace unprojector::base;
using namespace unprojector::geometry;

namespace {

QString textOf(const QString &file)
{
    QFile source(file);
    return source.open(QIODevice::ReadOnly) ? QString::fromUtf8(source.readAll()) : QString();
}

/// Returns the literal that begins here with a quote, as the compiler reads it, and moves `at`
/// behind it.
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

/// The first argument of a call.
struct Argument {
    QStringList literals; ///< those side by side are one
    QString rest;         ///< what else it is made of, without blanks at its ends
};

/// @param at  behind the call's opening bracket
Argument argumentOf(const QString &code, qsizetype at)
{
    QStringList texts;
    QString rest;
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
        rest += c;
        ++at;
    }
    return {texts, rest.trimmed()};
}

/// Returns whether all values of the argument are visible: literals, both of them in a choice, or a
/// name of marked texts.
bool isSeen(const Argument &argument)
{
    static const QRegularExpression name(QStringLiteral("^[A-Za-z_](?:[A-Za-z0-9_.:*()\\[\\]]|->)*$"));
    if (argument.literals.isEmpty())
        return name.match(argument.rest).hasMatch();
    return argument.literals.size() > argument.rest.count(u'?');
}

/// The first arguments of all these calls of some code.
QList<Argument> argumentsIn(QString code, const QString &calls = QStringLiteral("tr|marked"))
{
    const QRegularExpression call(QStringLiteral("(?<![A-Za-z0-9_])(?:%1)\\(").arg(calls));
    static const QRegularExpression comment(QStringLiteral("//[^\"\n]*$"), QRegularExpression::MultilineOption);
    code.remove(comment);
    QList<Argument> arguments;
    for (auto it = call.globalMatch(code); it.hasNext();)
        arguments << argumentOf(code, it.next().capturedEnd());
    return arguments;
}

/// The arguments of these calls in core or gui.
QList<Argument> argumentsOfSource(const QString &room, const QString &calls)
{
    QList<Argument> arguments;
    QDirIterator files(QStringLiteral(UNPROJECTOR_SOURCE_DIR "/") + room, {"*.h", "*.cpp"}, QDir::Files,
                       QDirIterator::Subdirectories);
    while (files.hasNext()) {
        if (const QString file = files.next(); !file.endsWith(QStringLiteral("/base/translation.h")))
            arguments << argumentsIn(textOf(file), calls);
    }
    return arguments;
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

/// The texts of the window, as its translation file has them.
QStringList textsOfWindow()
{
    QXmlStreamReader xml(textOf(QStringLiteral(UNPROJECTOR_SOURCE_DIR "/resources/translations/unprojector_zh_CN.ts")));
    QStringList texts;
    while (!xml.atEnd()) {
        if (xml.readNext() == QXmlStreamReader::StartElement && xml.name() == u"source")
            texts << xml.readElementText();
    }
    return xml.hasError() ? QStringList() : texts;
}

/// A text without its context and without the window's additions: the capital, the full stop, its
/// own signs.
QString bare(const QString &text)
{
    static const QRegularExpression end(QStringLiteral("[\\s.:…!?]+$"));
    return text.section(u'|', 0, 0)
        .toLower()
        .replace(u'×', u'x')
        .replace(u'−', u'-')
        .replace(QRegularExpression(QStringLiteral("[“”]")), QStringLiteral("\""))
        .remove(end);
}

} // namespace

class TestCoreTexts : public QObject {
    Q_OBJECT

private slots:
    /// A text that is no literal where it is translated could stay untranslated and unnoticed.
    void noTextIsHidden()
    {
        for (const Argument &argument : argumentsOfSource("core", "tr|marked"))
            QVERIFY2(isSeen(argument), qPrintable(argument.rest + u'|' + argument.literals.join(u'|')));
    }

    void whatHidesATextIsSeen_data()
    {
        addColumn<QString>("code");
        addColumn<bool>("seen");

        newRow("literal") << QStringLiteral(R"(tr("a" "b", c))") << true;
        newRow("choice") << QStringLiteral(R"(tr(x == ',' ? "a" : "b" "c", d))") << true;
        newRow("name") << QStringLiteral("tr(mistakeOf(part).sentence)") << true;
        newRow("table") << QStringLiteral("tr(kTexts[std::size_t(*kind)])") << true;
        newRow("in-a-comment") << QStringLiteral("int a; // what tr() says") << true;
        newRow("comma-of-a-template") << QStringLiteral(R"(tr(std::is_same_v<S, double> ? "a" : "b"))") << false;
        newRow("half-a-choice") << QStringLiteral(R"(tr(isFew ? few : "b"))") << false;
        newRow("choice-of-names") << QStringLiteral("tr(isFew ? few : many)") << false;
        newRow("sum") << QStringLiteral("tr(a + b)") << false;
    }

    void whatHidesATextIsSeen()
    {
        QFETCH(QString, code);
        QFETCH(bool, seen);
        const QList<Argument> arguments = argumentsIn(code);
        QCOMPARE(std::all_of(arguments.begin(), arguments.end(), isSeen), seen);
    }

    void everyTextHasATranslationAndNoneIsLeftOver()
    {
        QSet<QString> texts;
        // The window has its own tr(), and marks what core words: notes about textures.
        for (const Argument &argument : argumentsOfSource("core", "tr|marked") + argumentsOfSource("gui", "marked")) {
            for (const QString &text : argument.literals)
                texts << text;
        }
        const auto mistakes =
            QJsonDocument::fromJson(
                textOf(QStringLiteral(UNPROJECTOR_SOURCE_DIR "/resources/doctor/mistakes.json")).toUtf8())
                .array();
        for (const auto &mistake : mistakes)
            texts << mistake[u"name"].toString() << mistake[u"sentence"].toString();
        const QStringList keys = catalogue().keys();
        const QSet<QString> translated(keys.begin(), keys.end());
        QVERIFY(texts.size() > 100);
        QCOMPARE((texts - translated).values(), QStringList());
        QCOMPARE((translated - texts).values(), QStringList());
    }

    void placesOfValuesAgree()
    {
        const QJsonObject texts = catalogue();
        for (auto it = texts.begin(); it != texts.end(); ++it) {
            QVERIFY2(!it.value().toString().isEmpty(), qPrintable(it.key()));
            QCOMPARE(placesOf(it.value().toString()), placesOf(it.key()));
        }
    }

    /// “%1” between Chinese characters has a blank on both sides or on none.
    void noQuotesHaveABlankOnOneSide()
    {
        static const QRegularExpression oneSide(QStringLiteral("\\p{Han} “[^”]*”\\p{Han}|\\p{Han}“[^”]*” \\p{Han}"));
        const QJsonObject texts = catalogue();
        for (const QJsonValue text : texts)
            QVERIFY2(!oneSide.match(text.toString()).hasMatch(), qPrintable(text.toString()));
    }

    /// A side that is right and a verdict that is right are two words in Chinese.
    void aWordAloneSaysWhereItStands()
    {
        static const QRegularExpression word(QStringLiteral("^([a-z]+|(%[1-9] ?)+)$"));
        static const QRegularExpression withContext(QStringLiteral("^[^|]+(\\|[a-zA-Z -]+)?$"));
        for (const QString &text : catalogue().keys()) {
            QVERIFY2(!word.match(text).hasMatch(), qPrintable(text));
            QVERIFY2(withContext.match(text).hasMatch(), qPrintable(text));
        }
        QCOMPARE(base::tr("right|verdict"), std::string("right"));
        QCOMPARE(base::tr("%1 %2|sentences", "a|b", "c"), std::string("a|b c"));
        setLanguage(Language::Chinese);
        QCOMPARE(base::tr("right|verdict"), std::string("正确"));
        QCOMPARE(base::tr("right|side of a face"), std::string("right"));
        QCOMPARE(base::tr("%1 %2|sentences", "甲。", "乙。"), std::string("甲。乙。"));
        setLanguage(Language::English);
    }

    /// A value worded in core and in the window means two texts to keep alike. Labels of so few words
    /// may be the same by chance.
    void noTextIsTheWindowsToo()
    {
        constexpr int kMostWordsOfLabel = 3;
        const QStringList texts = textsOfWindow(), keys = catalogue().keys();
        QVERIFY(texts.size() > 1000);
        QSet<QString> ours;
        for (const QString &key : keys)
            ours << bare(key);
        QStringList twice;
        for (const QString &text : texts) {
            if (text.split(u' ').size() > kMostWordsOfLabel && ours.contains(bare(text)))
                twice << text;
        }
        QCOMPARE(twice, QStringList());
    }

    void textsAreSaidInTheLanguageThatIsSet()
    {
        QCOMPARE(base::tr("Usage"), std::string("Usage"));
        setLanguage(Language::Chinese);
        QCOMPARE(base::tr("Usage"), std::string("用法"));
        {
            const InEnglish english;
            QCOMPARE(base::tr("Usage"), std::string("Usage"));
            std::string said;
            std::thread([&said] { said = base::tr("Usage"); }).join();
            QCOMPARE(said, std::string("用法"));
        }
        QCOMPARE(base::tr("Usage"), std::string("用法"));
        const std::string unknown = "said by nobody";
        QCOMPARE(base::tr(unknown), unknown);
        setLanguage(Language::English);
    }

    void valuesStandInTheirPlaces()
    {
        QCOMPARE(base::tr("99 % of %2 are %1", "%2", 7), std::string("99 % of 7 are %2"));
        QCOMPARE(filled("%1%3", {"a"}), std::string("a%3"));
        QCOMPARE(filled("%", {"a"}), std::string("%"));
        QCOMPARE(filled("缺少 %1；%2 个 %3", {"宽度", "3", "像素"}), std::string("缺少宽度；3 个像素"));
        QCOMPARE(filled("%1 不是 %2 或 %3", {"近面", "z", "我的 扫描.ply"}), std::string("近面不是 z 或我的 扫描.ply"));
    }

    /// Digits that are noise are cut from the number that another one is compared with, unless they
    /// tell the two apart.
    void numbersOfErrorsCompareAsTheyRead()
    {
        using geometry::ErrorCode;
        const auto said = [](ErrorCode code, double value, double other) {
            return QString::fromStdString(errorText({code, value, other}));
        };
        QVERIFY(said(ErrorCode::NearNotBeforeFar, 40.0, 31.880000000000003).endsWith("far (31.88)"));
        QVERIFY(said(ErrorCode::NearNotBeforeFar, 99.99997, 99.99996).endsWith("far (99.99996)"));
        QVERIFY(said(ErrorCode::NearNotBeforeFar, 1.00000001, 1.0).endsWith("far (1)"));
        QVERIFY(said(ErrorCode::ViewNotRigid, 0.0001, 0.0).contains("has the length 1.00005;"));
    }

    void controlsAreWrittenOut_data()
    {
        addColumn<QByteArray>("text");
        addColumn<QByteArray>("line");
        newRow("nothing") << QByteArray() << QByteArray();
        newRow("letters, a tab, an escape that is written out") << QByteArray("a\tb \\x1b") << QByteArray("a\tb \\x1b");
        newRow("Chinese, joiners") << QByteArray("\u9762\u200d\u8138") << QByteArray("\u9762\u200d\u8138");
        newRow("a colour") << QByteArray("\033[31mred") << QByteArray("\\x1b[31mred");
        newRow("a title") << QByteArray("\033]0;title\a") << QByteArray("\\x1b]0;title\\x07");
        newRow("NUL, DEL") << QByteArray("a\0b\x7f", 4) << QByteArray("a\\x00b\\x7f");
        newRow("line ends") << QByteArray("a\r\nb") << QByteArray("a\\x0d\\x0ab");
        newRow("C1") << QByteArray("\xc2\x9b"
                                   "31m")
                     << QByteArray("\\u009b31m");
        newRow("C1 as a byte") << QByteArray("\x9b"
                                             "31m")
                               << QByteArray("\\x9b31m");
        newRow("Latin-1 between UTF-8") << QByteArray("\u9762\xe9\u8138\xe9") << QByteArray("\u9762\\xe9\u8138\\xe9");
        newRow("cut off") << QByteArray("a\xe2\x80") << QByteArray("a\\xe2\\x80");
        newRow("overrides") << QByteArray("\u202a\u202b\u202c\u202d\u202e")
                            << QByteArray("\\u202a\\u202b\\u202c\\u202d\\u202e");
        newRow("isolates") << QByteArray("\u2066\u2067\u2068\u2069") << QByteArray("\\u2066\\u2067\\u2068\\u2069");
        newRow("separators") << QByteArray("\u2028\u2029") << QByteArray("\\u2028\\u2029");
        newRow("a tag") << QByteArray("\U000e0041") << QByteArray("\\U000e0041");
    }

    void controlsAreWrittenOut()
    {
        QFETCH(QByteArray, text);
        QFETCH(QByteArray, line);
        const auto bytes = [](const std::string &printed) { return QByteArray::fromStdString(printed); };
        QCOMPARE(bytes(printableLine(text.toStdString())), line);
        QCOMPARE(bytes(printableLines(text.toStdString())), line.replace("\\x0a", "\n"));
    }

    void quotedBeginningsShowWhatIsWrong()
    {
        const auto shown = [](const char *text) { return QByteArray::fromStdString(printableBeginning(text, 5)); };
        QCOMPARE(shown("\u22125"), QByteArray("\u22125")); // a minus that is no hyphen
        QCOMPARE(shown("\u0661\u0662"), QByteArray("\u0661\u0662"));
        QCOMPARE(shown("a b"), QByteArray("a b"));
        QCOMPARE(shown("\u00a05\u2009\u3000"), QByteArray("\\u00a05\\u2009\\u3000"));
        QCOMPARE(shown("\xe9\x1b"), QByteArray("\\xe9\\x1b"));
        QCOMPARE(shown("\u9762\u8138\u9762\u8138\u9762\u8138"), QByteArray("\u9762\u8138\u9762\u8138\u9762\u2026"));
    }

    void wideCharactersTakeTwoColumns()
    {
        QCOMPARE(columnsOf("a 点，"), std::size_t(6));
        QCOMPARE(columnsOf("“±”"), std::size_t(3));
        QCOMPARE(padded("点", 4), std::string("点  "));
        QCOMPARE(padded("world", 4), std::string("world"));
        QCOMPARE(paddedLeft("点", 4), std::string("  点"));
    }
};

UNPROJECTOR_TEST(TestCoreTexts)
#include "test_core_texts.moc"
