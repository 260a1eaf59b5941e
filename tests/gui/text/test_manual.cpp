// The manual: its pages, and the window that shows them.

#include "tests/support/test.h"

#include "gui/lessons/find_bar.h"
#include "gui/lessons/manual_pages.h"
#include "gui/lessons/manual_window.h"
#include "gui/shell/appearance.h"
#include "gui/text/help_anchors.h"
#include "gui/widgets/help_link.h"
#include "tests/support/patience.h"

#include <QAction>
#include <QDir>
#include <QFile>
#include <QImage>
#include <QLineEdit>
#include <QScrollBar>
#include <QSet>
#include <QTextBlock>
#include <QTextBrowser>
#include <QTextTable>
#include <QTreeWidget>
#include <QtGui/qtguiglobal.h>

#include <algorithm>
#include <functional>

namespace unprojector::gui {
namespace {

const ManualPage *pageNamed(const std::vector<ManualPage> &pages, const QString &name)
{
    const auto page = std::find_if(pages.begin(), pages.end(), [&](const ManualPage &one) { return one.name == name; });
    return page == pages.end() ? nullptr : &*page;
}

/// Returns whether a page has the section of an address: "picking.md#limits".
bool isThere(const std::vector<ManualPage> &pages, const QString &address)
{
    const ManualPlace place = manualPlace(address);
    const ManualPage *page = pageNamed(pages, place.page);
    return page && (place.slug.isEmpty() || page->has(place.slug));
}

void eachFragment(const QTextDocument &text, const std::function<void(const QTextCharFormat &)> &look)
{
    for (QTextBlock block = text.begin(); block.isValid(); block = block.next()) {
        for (auto it = block.begin(); !it.atEnd(); ++it)
            look(it.fragment().charFormat());
    }
}

/// The line at the upper edge of the page.
QString firstLine(ManualWindow &window)
{
    return window.page().cursorForPosition({4, window.page().fontMetrics().height()}).block().text();
}

QStringList listed(ManualWindow &window)
{
    QStringList texts;
    for (int i = 0; i < window.contents().topLevelItemCount(); ++i) {
        const QTreeWidgetItem *item = window.contents().topLevelItem(i);
        texts << item->text(0);
        for (int k = 0; k < item->childCount(); ++k)
            texts << u'/' + item->child(k)->text(0);
    }
    return texts;
}

QAction *tool(ManualWindow &window, const QString &text)
{
    for (QAction *action : window.findChildren<QAction *>()) {
        if (action->text() == text)
            return action;
    }
    return nullptr;
}

} // namespace

class TestManual : public QObject {
    Q_OBJECT

private slots:
    void aSlugIsGitHubs_data()
    {
        addColumn<QString>("title");
        addColumn<QString>("slug");
        newRow("spaces") << "Left and right"
                         << "left-and-right";
        newRow("punctuation") << "The Comparison panel, top to bottom"
                              << "the-comparison-panel-top-to-bottom";
        newRow("dash between spaces") << "A – b"
                                      << "a--b";
        newRow("hyphen and line") << "Half-pixel m_v"
                                  << "half-pixel-m_v";
        newRow("Chinese") << QStringLiteral("读取 坐标（世界）") << QStringLiteral("读取-坐标世界");
    }

    void aSlugIsGitHubs()
    {
        QFETCH(QString, title);
        QTEST(headingSlug(title), "slug");
    }

    void everyPageIsLinkedAndHasText_data()
    {
        addColumn<QString>("name");
        const QStringList files = QDir(QStringLiteral(":/manual")).entryList({QStringLiteral("*.md")});
        QVERIFY(files.size() >= 16);
        for (const QString &file : files)
            newRow(qPrintable(file)) << file.chopped(3);
    }

    void everyPageIsLinkedAndHasText()
    {
        QFETCH(QString, name);
        const std::vector<ManualPage> pages = manualPages(QStringLiteral("manual"));
        const ManualPage *page = pageNamed(pages, name);
        QVERIFY(page);
        QVERIFY(!page->sections.empty() && page->sections.front().level == 1 && page->title != name);
        int letters = 0;
        for (const ManualSection &section : page->sections) {
            QVERIFY2(section.text.size() > section.title.size() + 1 || section.level == 1, qPrintable(section.title));
            letters += static_cast<int>(section.text.size());
        }
        QVERIFY(letters > 500);
        QVERIFY(name == QStringLiteral("index")
                || pages.front().markdown.contains(QStringLiteral("](%1.md)").arg(name)));
    }

    void everyLinkLeadsSomewhere_data()
    {
        addColumn<QString>("folder");
        newRow("English") << "manual";
        newRow("Chinese") << "manual/zh_CN"; // English pages if a translation is missing
    }

    void everyLinkLeadsSomewhere()
    {
        if (!QT_CONFIG(textmarkdownreader))
            QSKIP("This Qt has no Markdown reader.");
        QFETCH(QString, folder);
        const std::vector<ManualPage> pages = manualPages(folder);
        QFile formulas(QStringLiteral(":/help/formulas.html"));
        QVERIFY(formulas.open(QIODevice::ReadOnly));
        const QByteArray formulasPage = formulas.readAll();
        QStringList broken;
        int links = 0;
        for (const ManualPage &page : pages) {
            QTextDocument text;
            setManualText(text, page.markdown);
            eachFragment(text, [&](const QTextCharFormat &format) {
                if (format.isImageFormat()
                    && !QFile::exists(QStringLiteral(":/images/") + format.toImageFormat().name().section(u'/', -1)))
                    broken << page.name + QStringLiteral(": ") + format.toImageFormat().name();
                const QString href = format.anchorHref();
                if (href.isEmpty())
                    return;
                ++links;
                const QUrl url(href);
                const bool isGood = url.scheme() == QStringLiteral("formulas")
                                        ? formulasPage.contains('"' + url.path().toUtf8() + '"')
                                    : url.isRelative() ? isThere(pages, href.startsWith(u'#') ? page.name + href : href)
                                                       : url.scheme().startsWith(QStringLiteral("http"));
                if (!isGood)
                    broken << page.name + QStringLiteral(": ") + href;
            });
        }
        QVERIFY(links > 40);
        QCOMPARE(broken, QStringList());
    }

    void aTranslatedPageHasTheSameHeadings()
    {
        const std::vector<ManualPage> english = manualPages(QStringLiteral("manual")),
                                      chinese = manualPages(QStringLiteral("manual/zh_CN"));
        QCOMPARE(chinese.size(), english.size());
        for (std::size_t i = 0; i < english.size(); ++i) {
            QCOMPARE(chinese[i].name, english[i].name);
            QVERIFY2(chinese[i].sections.size() == english[i].sections.size(), qPrintable(english[i].name));
            for (std::size_t k = 0; k < english[i].sections.size(); ++k) {
                QCOMPARE(chinese[i].sections[k].level, english[i].sections[k].level);
                QCOMPARE(chinese[i].sections[k].englishSlug, english[i].sections[k].slug);
            }
        }
    }

    void everyPanelHasItsPlace()
    {
        const std::vector<ManualPage> pages = manualPages(QStringLiteral("manual"));
        for (int panel = 0; panel <= static_cast<int>(lessons::Panel::Lesson); ++panel) {
            const QString place = manualPlaceOf(static_cast<lessons::Panel>(panel));
            QVERIFY2(isThere(pages, place), qPrintable(place));
        }
    }

    void aLinkOpensItsHeading()
    {
        ManualWindow window;
        window.resize(900, 500);
        window.show();
        QCOMPARE(window.currentPage().name, QStringLiteral("index"));
        window.openPlace(QStringLiteral("picking.md#snap-to-the-mesh"));
        QCOMPARE(window.currentPage().name, QStringLiteral("picking"));
        QCOMPARE(firstLine(window), QStringLiteral("Snap to the mesh"));
        QCOMPARE(window.contents().currentItem()->text(0), QStringLiteral("Snap to the mesh"));
        window.openPlace(QStringLiteral("#earlier-picks"));
        QCOMPARE(window.currentPage().name, QStringLiteral("picking"));
        QCOMPARE(firstLine(window), QStringLiteral("Earlier picks"));
        // The test clicks a link like a user.
        window.openPlace(QStringLiteral("index.md"));
        emit window.page().anchorClicked(QUrl(QStringLiteral("doctor.md#read-the-verdict")));
        QCOMPARE(window.currentPage().name, QStringLiteral("doctor"));
        QCOMPARE(firstLine(window), QStringLiteral("Read the verdict"));
    }

    void backReturnsToWhereThePageWas()
    {
        ManualWindow window;
        window.resize(900, 500);
        window.show();
        QVERIFY(QTest::qWaitForWindowActive(&window, kPatienceMilliseconds));
        QVERIFY(!tool(window, QStringLiteral("Go Back"))->isEnabled());
        window.openPlace(QStringLiteral("picking.md#view-size"));
        window.page().verticalScrollBar()->setValue(432);
        window.openPlace(QStringLiteral("doctor.md#limits"));
        QTest::keyClick(&window, Qt::Key_Left, Qt::AltModifier);
        QCOMPARE(window.currentPage().name, QStringLiteral("picking"));
        QCOMPARE(window.page().verticalScrollBar()->value(), 432);
        QTest::keyClick(&window, Qt::Key_Left, Qt::AltModifier);
        QCOMPARE(window.currentPage().name, QStringLiteral("index"));
        QVERIFY(!tool(window, QStringLiteral("Go Back"))->isEnabled());
        for (const char *name : {"picking", "doctor"}) {
            QTest::keyClick(&window, Qt::Key_Right, Qt::AltModifier);
            QCOMPARE(window.currentPage().name, QString::fromLatin1(name));
        }
        QVERIFY(!tool(window, QStringLiteral("Go Forward"))->isEnabled());
    }

    void aLinkToAFormulaOpensTheFormulas()
    {
        QStringList opened;
        const HelpOpener opener([&](const QString &anchor) { opened << anchor; }, [](const QString &) {}, nullptr);
        ManualWindow window;
        emit window.page().anchorClicked(QUrl(QStringLiteral("formulas:ortho")));
        QCOMPARE(opened, QStringList{QStringLiteral("ortho")});
        QCOMPARE(window.currentPage().name, QStringLiteral("index"));
    }

    void theSearchListsPagesAndHeadings()
    {
        ManualWindow window;
        const QStringList all = listed(window);
        window.searchField().setText(QStringLiteral("letterBOX"));
        const QStringList hits = listed(window);
        QVERIFY(!hits.isEmpty() && hits.size() < all.size() / 2);
        QVERIFY(hits.contains(QStringLiteral("Read a pick")) && hits.contains(QStringLiteral("/View size")));
        QVERIFY(!hits.contains(QStringLiteral("/Snap to the mesh")));
        window.searchField().setText(QStringLiteral("no such words anywhere"));
        QCOMPARE(listed(window), QStringList(QStringLiteral("No page has these words.")));
        const QString page = window.page().toPlainText();
        QTest::keyClick(&window.searchField(), Qt::Key_Return); // opens nothing
        QCOMPARE(window.page().toPlainText(), page);
        window.searchField().clear();
        QCOMPARE(listed(window), all);
        // The page for builders is not the window's.
        QVERIFY(!all.contains(QStringLiteral("Building and changing the program")));
    }

    void enterOpensTheHitAndMarksIt()
    {
        ManualWindow window;
        window.resize(900, 500);
        window.show();
        QVERIFY(QTest::qWaitForWindowActive(&window, kPatienceMilliseconds));
        QTest::keyClick(&window, Qt::Key_F, Qt::ControlModifier | Qt::ShiftModifier);
        QVERIFY(window.searchField().hasFocus());
        QTest::keyClicks(&window.searchField(), QStringLiteral("gluUnProject(x, y, d"));
        QTest::keyClick(&window.searchField(), Qt::Key_Return);
        QCOMPARE(window.currentPage().name, QStringLiteral("doctor"));
        QVERIFY(window.findBar().isVisible());
        QCOMPARE(window.findBar().hits().size(), std::size_t(1));
        QCOMPARE(window.page().extraSelections().front().cursor.selectedText(), QStringLiteral("gluUnProject(x, y, d"));
        QVERIFY(window.page().viewport()->rect().contains(window.page().cursorRect()));
    }

    void wordsApartAreFoundToo()
    {
        ManualWindow window;
        window.show();
        window.searchField().setText(QStringLiteral("coordinate vertex visible"));
        QVERIFY(listed(window).contains(QStringLiteral("/Snap to the mesh")));
        ManualSection section;
        section.text = QStringLiteral("A visible vertex, at x − 1");
        QCOMPARE(wordsIn(section, QStringLiteral("visible vertex")), QStringLiteral("visible vertex"));
        QCOMPARE(wordsIn(section, QStringLiteral("vertex Visible")), QStringLiteral("Visible"));
        QCOMPARE(wordsIn(section, QStringLiteral("x - 1")), QStringLiteral("x - 1"));
        QCOMPARE(wordsIn(section, QStringLiteral("visible edge")), QString());
    }

    void theWindowFollowsColours()
    {
        if (!QT_CONFIG(textmarkdownreader))
            QSKIP("This Qt has no Markdown reader.");
        const Appearance before = currentAppearance();
        setAppearance(Appearance::Light);
        ManualWindow window;
        window.resize(900, 500);
        window.show();
        window.openPlace(QStringLiteral("picking.md#snap-to-the-mesh"));
        const auto colours = [&] {
            QSet<QRgb> found;
            eachFragment(*window.page().document(), [&](const QTextCharFormat &format) {
                if (format.hasProperty(QTextFormat::ForegroundBrush))
                    found << format.foreground().color().rgb();
            });
            return found;
        };
        const QSet<QRgb> light = colours();
        QVERIFY(light.size() >= 2); // headings and links
        const int place = window.page().verticalScrollBar()->value();
        setAppearance(Appearance::Dark);
        QTRY_VERIFY_WITH_TIMEOUT(window.page().palette().color(QPalette::Base).lightnessF() < 0.5F,
                                 kPatienceMilliseconds);
        QVERIFY(!colours().intersects(light));
        QCOMPARE(window.page().verticalScrollBar()->value(), place);
        setAppearance(before);
    }

    void tablesHaveBordersAndBoldHeads()
    {
        ManualWindow window;
        for (const ManualPage &page : window.pages()) {
            window.openPlace(page.name);
            for (QTextFrame *frame : window.page().document()->rootFrame()->childFrames()) {
                const auto *table = qobject_cast<QTextTable *>(frame);
                QVERIFY(table && table->format().border() >= 1.0 && table->format().cellPadding() > 2.0);
                for (int column = 0; column < table->columns(); ++column) {
                    const QTextTableCell head = table->cellAt(0, column);
                    QVERIFY(head.format().background().color() != window.page().palette().color(QPalette::Base));
                    if (!head.firstCursorPosition().block().text().isEmpty())
                        QVERIFY(head.firstCursorPosition().block().begin().fragment().charFormat().fontWeight()
                                >= QFont::Bold);
                    QCOMPARE(head.firstCursorPosition().blockFormat().topMargin(), 0.0);
                    QCOMPARE(head.firstCursorPosition().block(), head.lastCursorPosition().block());
                }
            }
        }
    }

    void theZoomTakesEverythingWithIt()
    {
        ManualWindow window;
        window.resize(900, 500);
        window.show();
        window.openPlace(
            QStringLiteral("command-line.md")); // a page without images, because the zoom doesn't scale them
        eachFragment(*window.page().document(), [](const QTextCharFormat &format) {
            QVERIFY(!format.hasProperty(QTextFormat::FontPointSize) && !format.hasProperty(QTextFormat::FontPixelSize));
        });
        const double before = window.page().document()->size().height();
        window.setZoomPercent(200);
        const double after = window.page().document()->size().height();
        QVERIFY2(after > 1.8 * before, qPrintable(QStringLiteral("%1 of %2").arg(after).arg(before)));
    }

    void imagesFitTheColumn()
    {
        if (!QT_CONFIG(textmarkdownreader))
            QSKIP("This Qt has no Markdown reader.");
        ManualWindow window;
        window.resize(1100, 600);
        window.show();
        window.openPlace(QStringLiteral("doctor.md"));
        for (const int width : {1100, 500, 800}) {
            window.resize(width, 600);
            QCoreApplication::processEvents();
            int images = 0;
            eachFragment(*window.page().document(), [&](const QTextCharFormat &format) {
                if (!format.isImageFormat())
                    return;
                ++images;
                const QTextImageFormat image = format.toImageFormat();
                const double column =
                    window.page().viewport()->width() - 2.0 * window.page().document()->documentMargin();
                QVERIFY(image.width() > 0.9 * column && image.width() <= column);
                const auto shown = window.page()
                                       .document()
                                       ->resource(QTextDocument::ImageResource, QUrl(image.name()))
                                       .value<QImage>();
                QVERIFY(!shown.isNull());
                QCOMPARE(shown.deviceIndependentSize().toSize().width(), static_cast<int>(image.width()));
            });
            QCOMPARE(images, 1);
        }
    }

    void aNarrowWindowShowsThePageAlone()
    {
        ManualWindow window;
        window.resize(1000, 600);
        window.show();
        QVERIFY(QTest::qWaitForWindowActive(&window, kPatienceMilliseconds));
        QVERIFY(window.contents().isVisible());
        window.resize(420, 600);
        QVERIFY(!window.contents().isVisible());
        tool(window, QStringLiteral("Search"))->trigger();
        QVERIFY(window.contents().isVisible() && window.searchField().hasFocus());
        window.resize(1000, 500);
        QVERIFY(window.contents().isVisible());
    }
};

} // namespace unprojector::gui

UNPROJECTOR_TEST(unprojector::gui::TestManual)
#include "test_manual.moc"
