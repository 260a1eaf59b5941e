// The page of formulas in the other languages: the same page as the English one, and shown where
// the program speaks them.

#include "tests/support/test.h"

#include "gui/lessons/formulas_window.h"
#include "gui/text/formula_markup.h"
#include "gui/text/translation.h"
#include "tests/support/errata.h"
#include "tests/support/patience.h"

#include <QDir>
#include <QFile>
#include <QRegularExpression>
#include <QScrollBar>
#include <QSet>
#include <QTextBrowser>

#include <cstdlib>
#include <utility>

namespace unprojector::gui {
namespace {

const QString kEnglish = QStringLiteral("formulas.html");
const QString kChinese = QStringLiteral("formulas_zh_CN.html");

QString source(const QString &name)
{
    QFile file(QStringLiteral(":/help/") + name);
    return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()) : QString();
}

/// Everything of a page that the pattern finds, in its order.
QStringList found(const QString &page, const QString &pattern)
{
    QStringList result;
    const QRegularExpression expression(pattern, QRegularExpression::DotMatchesEverythingOption);
    for (auto matches = expression.globalMatch(page); matches.hasNext();)
        result << matches.next().captured();
    return result;
}

bool hasChinese(const QString &text)
{
    static const QRegularExpression character(QStringLiteral("[\\x{4e00}-\\x{9fff}]"));
    return text.contains(character);
}

} // namespace

class TestHelpLanguages : public QObject {
    Q_OBJECT

private slots:
    void aPageIsTheEnglishOne_data()
    {
        addColumn<QString>("name");
        addColumn<QString>("pattern");
        const std::pair<const char *, const char *> parts[] = {
            {"headings, paragraphs and tables", "</?(h[1-3]|p|table|tr|t[dh]|br)\\b"},
            {"anchors", "<a name=\"[^\"]*\"|<formula[^>]*>"},
            {"links", "<a href=\"[^\"]*\""},
            {"formulas", "<formula.*?</formula>"},
            {"figures", "<img src=\"[^\"]*\""},
            {"style", "<style>.*?</style>"},
        };
        QStringList names = QDir(QStringLiteral(":/help")).entryList();
        QVERIFY(names.removeOne(kEnglish));
        QVERIFY(names.contains(kChinese));
        for (const QString &name : std::as_const(names)) {
            for (const auto &[part, pattern] : parts)
                addRow("%s: %s", qPrintable(name), part) << name << QString::fromLatin1(pattern);
        }
    }

    void aPageIsTheEnglishOne()
    {
        QFETCH(QString, name);
        QFETCH(QString, pattern);
        const QStringList expected = found(source(kEnglish), pattern);
        QVERIFY(!expected.isEmpty());
        QCOMPARE(found(source(name), pattern), expected);
    }

    void aLinkLeadsToOnePlace_data()
    {
        addColumn<QString>("name");
        for (const QString &name : QDir(QStringLiteral(":/help")).entryList())
            newRow(qPrintable(name)) << name;
    }

    void aLinkLeadsToOnePlace()
    {
        QFETCH(QString, name);
        const QString page = typeset(source(name));
        const QStringList places = found(page, QStringLiteral("(?<=<a name=[\"'])[^\"']*"));
        QCOMPARE(QSet<QString>(places.begin(), places.end()).size(), places.size());
        const QStringList targets = found(page, QStringLiteral("(?<=<a href=\"#)[^\"]*"));
        QVERIFY(targets.size() > 10);
        for (const QString &target : targets)
            QVERIFY2(places.contains(target), qPrintable(target));
        FormulasWindow window; // and every place is found, a cell of a table's as well
        window.page().setHtml(page);
        window.show();
        int last = -1;
        for (const char *anchor : kErrata) {
            window.showFormula(QString::fromLatin1(anchor));
            const int at = window.page().verticalScrollBar()->value();
            QVERIFY2(at > last || at == window.page().verticalScrollBar()->maximum(), anchor);
            last = at;
        }
    }

    void everyParagraphIsChinese()
    {
        const QStringList paragraphs = found(source(kChinese), QStringLiteral("<(h[1-3]|p|th)\\b.*?</\\1>"));
        QVERIFY(paragraphs.size() > 80);
        for (const QString &paragraph : paragraphs)
            QVERIFY2(hasChinese(paragraph), qPrintable(paragraph));
    }

    void noChineseSentenceIsBroken()
    {
        // Rich text shows a line break as a space.
        const QString body = source(kChinese).section(QStringLiteral("<body>"), 1);
        const QStringList broken = found(body, QStringLiteral("[\\x{3000}-\\x{9fff}\\x{ff00}-\\x{ffef}]\\n[^\\n<]*"));
        QCOMPARE(broken, QStringList());
    }

    /// Chinese fonts have no italics: slanted by the program, the characters look deformed.
    void noChineseIsSlanted()
    {
        const QStringList slanted = found(typeset(source(kChinese)), QStringLiteral("<(i|em)>.*?</\\1>"));
        QVERIFY(slanted.size() > 100); // letters of the formulas
        for (const QString &one : slanted)
            QVERIFY2(!hasChinese(one), qPrintable(one));
    }

    void theWindowShowsThePageOfItsLanguage_data()
    {
        addColumn<QString>("language");
        addColumn<QString>("title");
        newRow("English") << "en-US"
                          << "From a pixel to a world coordinate";
        newRow("one that the program does not speak") << "fr-FR"
                                                      << "From a pixel to a world coordinate";
#ifdef UNPROJECTOR_IS_TRANSLATED
        newRow("Chinese") << "zh-CN" << QStringLiteral("从像素到世界坐标");
#endif
    }

    void theWindowShowsThePageOfItsLanguage()
    {
        QFETCH(QString, language);
        QFETCH(QString, title);
        const Translation translation({language});
        FormulasWindow window;
        QVERIFY(window.page().toPlainText().startsWith(title));
        window.show();
        for (const int width : {0, 700, 760, 761, 900, 1000}) { // columns in per cent are rounded differently in each
            if (width > 0)
                window.resize(width, 700);
            QTRY_COMPARE_WITH_TIMEOUT(window.page().horizontalScrollBar()->maximum(), 0, kPatienceMilliseconds);
        }
        const QScrollBar *bar = window.page().verticalScrollBar();
        int last = -1;
        for (const char *name : {"contents", "forward", "ortho", "weng", "w9", "closed", "errors"}) {
            window.showFormula(QString::fromLatin1(name));
            QTRY_VERIFY2_WITH_TIMEOUT(bar->value() > last, name, kPatienceMilliseconds);
            last = bar->value();
        }
    }
};

} // namespace unprojector::gui

UNPROJECTOR_TEST(unprojector::gui::TestHelpLanguages)
#include "test_help_languages.moc"
