// Plain words: the texts of the program follow the glossary, have short sentences, and say who does
// what.
//
// The tests read the source tree: the texts of the window (.ts), of core (JSON keys), the lessons,
// the manual, the README, and the docstrings of the headers. The wrong terms are the column "Not"
// of the manual's glossary.
#include "tests/support/test.h"

#include <QDir>
#include <QDirIterator>
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QRegularExpression>
#include <QXmlStreamReader>

namespace {

constexpr int kMostWords = 30;

/// Idioms that hide who does what. They are not terms, so the glossary does not list them.
const QStringList kGhosts{
    "are said",     "are told",   "besides",  "come about",    "comes about", "is said",    "is told",
    "let go",       "lets go",    "nobody",   "somebody",      "take apart",  "tell apart", "told apart",
    "turned round", "turn round", "whatever", "what is to be", "wherever",    "whoever",    "there is nothing of"};
/// Words that have better terms in the window and the messages: view, frame, image, setup.
const QStringList kGhostsOfWindow{"picture", "pictures"};

/// A text and its source: "messages: the file is empty".
struct Text {
    QString where;
    QString text;
};

QString contentsOf(const QString &file)
{
    QFile source(QStringLiteral(UNPROJECTOR_SOURCE_DIR "/") + file);
    return source.open(QIODevice::ReadOnly) ? QString::fromUtf8(source.readAll()) : QString();
}

QStringList filesUnder(const QString &folder, const QString &pattern)
{
    QStringList files;
    QDirIterator it(QStringLiteral(UNPROJECTOR_SOURCE_DIR "/") + folder, {pattern}, QDir::Files,
                    QDirIterator::Subdirectories);
    while (it.hasNext())
        files << QDir(QStringLiteral(UNPROJECTOR_SOURCE_DIR)).relativeFilePath(it.next());
    files.sort();
    return files;
}

QString without(QString text, const char *pattern)
{
    const QRegularExpression expression(QString::fromLatin1(pattern), QRegularExpression::DotMatchesEverythingOption
                                                                          | QRegularExpression::MultilineOption);
    return text.replace(expression, QStringLiteral(" "));
}

QList<Text> windowTexts()
{
    QList<Text> texts;
    QXmlStreamReader xml(contentsOf(QStringLiteral("resources/translations/unprojector_zh_CN.ts")));
    while (!xml.atEnd()) {
        if (xml.readNext() == QXmlStreamReader::StartElement && xml.name() == u"source")
            texts.append({QStringLiteral("window"), xml.readElementText()});
    }
    return texts;
}

QList<Text> messageTexts()
{
    QList<Text> texts;
    const QString json = contentsOf(QStringLiteral("resources/translations/unproject_zh_CN.json"));
    for (const QString &key : QJsonDocument::fromJson(json.toUtf8()).object().keys())
        texts.append({QStringLiteral("messages"), key.section(u'|', 0, 0)});
    return texts;
}

/// Appends the texts of a lesson: all its strings with a space.
void appendTexts(const QJsonValue &value, const QString &where, QList<Text> &texts)
{
    if (value.isString() && value.toString().contains(u' '))
        texts.append({where, without(value.toString(), "<[^>]*>")});
    for (const QJsonValue &inner : value.toArray())
        appendTexts(inner, where, texts);
    for (const QJsonValue &inner : value.toObject())
        appendTexts(inner, where, texts);
}

QList<Text> lessonTexts()
{
    QList<Text> texts;
    for (const QString &file : filesUnder(QStringLiteral("resources/lessons"), QStringLiteral("*.json"))) {
        if (file.contains(u"_zh"))
            continue;
        const QJsonDocument json = QJsonDocument::fromJson(contentsOf(file).toUtf8());
        appendTexts(json.isArray() ? QJsonValue(json.array()) : QJsonValue(json.object()), file, texts);
    }
    return texts;
}

/// The prose of a Markdown page without code and links: one text for each paragraph, list item,
/// heading and table cell.
QList<Text> pageTexts(const QString &file)
{
    QString page = without(contentsOf(file), "^```.*?^```");
    page = without(page, "`[^`\n]*`");
    page = without(page, "\\]\\([^)]*\\)");
    static const QRegularExpression pieces(QStringLiteral("\n\\s*\n|\n(?=\\s*(?:[-*#|]|\\d+\\.))|\\|"));
    QList<Text> texts;
    for (const QString &piece : page.split(pieces, Qt::SkipEmptyParts))
        texts.append({file, piece.simplified()});
    return texts;
}

QList<Text> manualTexts()
{
    QList<Text> texts;
    for (const QString &file : filesUnder(QStringLiteral("resources/manual"), QStringLiteral("*.md"))) {
        if (!file.endsWith(u"glossary.md"))
            texts += pageTexts(file);
    }
    return texts;
}

/// The terms in the glossary's column "Not".
QStringList wrongTerms()
{
    QStringList terms;
    for (const QString &line : contentsOf(QStringLiteral("resources/manual/glossary.md")).split(u'\n')) {
        const QStringList cells = line.split(u'|');
        if (cells.size() != 5 || cells[1].contains(u"---") || cells[3].trimmed() == u"Not")
            continue;
        for (const QString &term : cells[3].split(u',')) {
            if (const QString word = term.trimmed(); !word.isEmpty() && word != u"–")
                terms << word;
        }
    }
    return terms;
}

/// The texts with one of these words, whole and case-insensitive: "window: “tell apart” in: To tell
/// apart".
QStringList usesOf(const QStringList &words, const QList<Text> &texts)
{
    QStringList patterns, found;
    for (const QString &word : words)
        patterns << QRegularExpression::escape(word);
    const QRegularExpression any(QStringLiteral("\\b(?:%1)\\b").arg(patterns.join(u'|')),
                                 QRegularExpression::CaseInsensitiveOption);
    for (const Text &text : texts) {
        if (const auto match = any.match(text.text.simplified()); match.hasMatch())
            found << QStringLiteral("%1: “%2” in: %3").arg(text.where, match.captured(), text.text.simplified());
    }
    return found;
}

/// The sentences with too many words; a colon and a semicolon end a sentence as well.
QStringList longSentences(const QList<Text> &texts)
{
    static const QRegularExpression ends(QStringLiteral("(?<=[.;:?!])\\s+|\\n\\s*\\n|\\n(?=\\S+ {2})"));
    static const QRegularExpression word(QStringLiteral("(?<!\\S)\\S*[A-Za-z]"));
    QStringList found;
    for (const Text &text : texts) {
        for (const QString &sentence : text.text.split(ends)) {
            if (const qsizetype words = sentence.count(word); words > kMostWords)
                found << QStringLiteral("%1: %2 words: %3").arg(text.where).arg(words).arg(sentence.simplified());
        }
    }
    return found;
}

/// Labels, titles and tooltips that are one phrase and end in a full stop: "gui/a.cpp: Near.".
QStringList stoppedLabels(const QString &file, const QString &code)
{
    static const QRegularExpression label(QStringLiteral(
        "(?:setAccessibleName|setToolTip|setTitle|setWindowTitle|setPlaceholderText|add(?:Action|Item|Row|Tab)|"
        "Q(?:Action|CheckBox|GroupBox|PushButton|RadioButton))\\(\\s*(?:this,\\s*)?tr\\(\\s*((?:\"[^\"\\n]*\"\\s*)+)"));
    static const QRegularExpression seam(QStringLiteral("\"\\s*\"")), stop(QStringLiteral("[.!?](?: |\\\\n)"));
    QStringList found;
    for (auto it = label.globalMatch(code); it.hasNext();) {
        const QString text = it.next().captured(1).trimmed().replace(seam, QString()).chopped(1).mid(1);
        if (text.endsWith(u'.') && !text.contains(stop))
            found << file + QStringLiteral(": ") + text;
    }
    return found;
}

/// Docstrings that open without a subject: "a.h: Of the matrix".
QStringList headlessDocstrings(const QString &file, const QString &code)
{
    static const QRegularExpression headless(
        QStringLiteral("^(?:And|As|At|Because|But|By|For|From|How|If|In|Like|Of|On|Or|Since|So|That|Then|To|Unless|"
                       "Until|What|When|Where|Whether|Which|While|Who|Whom|Whose|With|Without)\\b"));
    static const QRegularExpression block(QStringLiteral("^\\s*///(?!<) ?(.*)$")),
        trailing(QStringLiteral("///< ?(.*)$"));
    QStringList found;
    bool isInside = false;
    for (const QString &line : code.split(u'\n')) {
        const auto whole = block.match(line), behind = trailing.match(line);
        const QString first = whole.hasMatch() && !isInside ? whole.captured(1)
                              : behind.hasMatch()           ? behind.captured(1)
                                                            : QString();
        isInside = whole.hasMatch();
        if (headless.match(first).hasMatch())
            found << file + QStringLiteral(": ") + first;
    }
    return found;
}

QByteArray reportOf(const QStringList &found)
{
    return QByteArray::number(found.size()) + ":\n" + found.mid(0, 40).join(u'\n').toUtf8();
}

} // namespace

class TestPlainWords : public QObject {
    Q_OBJECT

private slots:
    void words_data()
    {
        QTest::addColumn<QList<Text>>("texts");
        QTest::addColumn<QStringList>("more");
        QTest::newRow("window") << windowTexts() << kGhostsOfWindow;
        QTest::newRow("messages") << messageTexts() << kGhostsOfWindow;
        QTest::newRow("lessons") << lessonTexts() << QStringList();
        QTest::newRow("manual") << manualTexts() << QStringList();
        QTest::newRow("readme") << pageTexts(QStringLiteral("README.md")) << QStringList();
    }

    void words()
    {
        QFETCH(QList<Text>, texts);
        QFETCH(QStringList, more);
        QVERIFY2(texts.size() > 20, "there are texts to read");
        const QStringList wrong = wrongTerms();
        QVERIFY2(wrong.size() > 5, "the glossary has wrong terms");
        const QStringList found = usesOf(wrong + kGhosts + more, texts);
        QVERIFY2(found.isEmpty(), reportOf(found));
    }

    void sentences_data()
    {
        QTest::addColumn<QList<Text>>("texts");
        QTest::newRow("window") << windowTexts();
        QTest::newRow("messages") << messageTexts();
        QTest::newRow("manual") << manualTexts();
    }

    void sentences()
    {
        QFETCH(QList<Text>, texts);
        const QStringList found = longSentences(texts);
        QVERIFY2(found.isEmpty(), reportOf(found));
    }

    void labels()
    {
        QStringList found;
        for (const QString &file : filesUnder(QStringLiteral("gui"), QStringLiteral("*.cpp")))
            found += stoppedLabels(file, contentsOf(file));
        QVERIFY2(found.isEmpty(), reportOf(found));
    }

    void docstrings_data()
    {
        QTest::addColumn<QString>("folder");
        QTest::newRow("core") << QStringLiteral("core");
        QTest::newRow("gui") << QStringLiteral("gui");
    }

    void docstrings()
    {
        QFETCH(QString, folder);
        QStringList found;
        for (const QString &file : filesUnder(folder, QStringLiteral("*.h")))
            found += headlessDocstrings(file, contentsOf(file));
        QVERIFY2(found.isEmpty(), reportOf(found));
    }

    /// Tests the checks: each finds its mistake and accepts correct text.
    void checksSee()
    {
        const QList<Text> texts{{"a", "The Work\nplace is open"}, {"b", "workplaces"}};
        QCOMPARE(usesOf({"work place"}, texts), QStringList("a: “Work place” in: The Work place is open"));
        QString words = QStringLiteral("word ").repeated(kMostWords);
        QCOMPARE(longSentences({{"a", words + "1 2"}, {"b", words + "end: " + words}}).size(), 1);
        const QString code =
            QStringLiteral("b->setToolTip(tr(\"Near \"\n \"plane.\")); c->setToolTip(tr(\"Near. Far.\"));\n");
        QCOMPARE(stoppedLabels("a", code), QStringList("a: Near plane."));
        const QString header =
            QStringLiteral("/// The matrix\n/// Of rows.\nint a; ///< Of rows\n/// Whether it is\nint b;\n");
        QCOMPARE(headlessDocstrings("a", header), QStringList({"a: Of rows", "a: Whether it is"}));
    }
};

UNPROJECTOR_TEST(TestPlainWords)
#include "test_plain_words.moc"
