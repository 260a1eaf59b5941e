#include "gui/lessons/manual_window.h"

#include "gui/lessons/find_bar.h"
#include "gui/lessons/manual_layout.h"

#include <QAbstractTextDocumentLayout>
#include <QAction>
#include <QDesktopServices>
#include <QFontInfo>
#include <QGuiApplication>
#include <QKeyEvent>
#include <QLineEdit>
#include <QScrollBar>
#include <QTextBlock>
#include <QTextBrowser>
#include <QTreeWidget>
#include <QUrl>
#include <QVBoxLayout>

#include <algorithm>
#include <utility>

namespace unprojector::gui {
namespace {

constexpr double kLeastPointSize = 10.5;
constexpr int kSideLetters = 30;
constexpr int kLeastSideLetters = 14;
/// A narrower window shows only the page until the user starts a search.
constexpr int kLeastLettersForSide = 75;
/// The roles of a contents item: index of its page, index of its section.
constexpr int kPageRole = Qt::UserRole, kSectionRole = Qt::UserRole + 1;
/// The contents omit sections with smaller headings; the search finds them.
constexpr int kDeepestLevel = 2;

QFont textFont()
{
    QFont font = QGuiApplication::font();
    font.setPointSizeF(std::max(QFontInfo(font).pointSizeF(), kLeastPointSize));
    return font;
}

QTreeWidgetItem *makeItem(const QString &text, int page, int section)
{
    auto *item = new QTreeWidgetItem({text});
    item->setToolTip(0, text);
    item->setData(0, kPageRole, page);
    item->setData(0, kSectionRole, section);
    return item;
}

} // namespace

ManualWindow::ManualWindow(QWidget *parent)
    //: The folder of the manual's pages in this language, in resources: manual/zh_CN.
    : ReadingWindow(tr("Manual"), textFont(), parent), m_pages(manualPages(tr("manual")))
{
    makeSide();
    addSide(m_side);
    page().setOpenLinks(false);
    connect(&page(), &QTextBrowser::anchorClicked, this, &ManualWindow::follow);
    m_back = addTool(tr("Go Back"), tr("Back to the place before"), {Qt::ALT | Qt::Key_Left}, [this] { goBack(); });
    m_forward = addTool(tr("Go Forward"), tr("Forward to the place that was left last"), {Qt::ALT | Qt::Key_Right},
                        [this] { goForward(); });
    addTool(tr("Contents"), tr("Back to the contents"), {Qt::ALT | Qt::Key_Up}, [this] { openPlace({}); });
    addReadingTools();
    addTool(tr("Search"), tr("Search all pages"), {Qt::CTRL | Qt::SHIFT | Qt::Key_F}, [this] {
        m_side->show();
        m_search->setFocus(Qt::ShortcutFocusReason);
        m_search->selectAll();
    });
    fillContents();
    showPlace({});
}

void ManualWindow::makeSide()
{
    m_search = new QLineEdit;
    m_search->setPlaceholderText(tr("Search all pages"));
    m_search->setAccessibleName(tr("Search all pages"));
    m_search->setToolTip(
        tr("Words; the list shows the pages and headings that have all of them. Enter opens the first one"));
    m_search->setClearButtonEnabled(true);
    m_contents = new QTreeWidget;
    m_contents->setHeaderHidden(true);
    m_contents->setFrameShape(QFrame::NoFrame);
    m_contents->setAccessibleName(tr("Contents"));
    m_contents->setTextElideMode(Qt::ElideRight);
    m_contents->setIndentation(m_contents->fontMetrics().horizontalAdvance(u'n') * 2);
    m_side = new QWidget;
    auto *layout = new QVBoxLayout(m_side);
    layout->setContentsMargins(6, 6, 0, 0);
    layout->addWidget(m_search);
    layout->addWidget(m_contents);
    const int letter = fontMetrics().horizontalAdvance(u'n');
    m_side->setMinimumWidth(kLeastSideLetters * letter);
    m_side->resize(kSideLetters * letter, height());
    connect(m_search, &QLineEdit::textChanged, this, &ManualWindow::fillContents);
    connect(m_search, &QLineEdit::returnPressed, this, [this] {
        if (const QTreeWidgetItem *first =
                m_contents->currentItem() ? m_contents->currentItem() : m_contents->topLevelItem(0))
            openHit(*first);
    });
    const auto openItem = [this](const QTreeWidgetItem *item) { openHit(*item); };
    connect(m_contents, &QTreeWidget::itemClicked, this, openItem);
    connect(m_contents, &QTreeWidget::itemActivated, this, openItem);
}

void ManualWindow::openPlace(const QString &address)
{
    const ManualPlace place = manualPlace(address);
    Place found{m_present.page, 0, -1};
    if (!place.page.isEmpty() || place.slug.isEmpty()) {
        const auto page =
            std::find_if(m_pages.begin(), m_pages.end(), [&](const ManualPage &one) { return one.name == place.page; });
        found.page = page == m_pages.end() ? 0 : static_cast<int>(page - m_pages.begin());
    }
    if (!m_pages.empty())
        found.section = m_pages[static_cast<std::size_t>(found.page)].indexOf(place.slug);
    visit(found);
}

void ManualWindow::follow(const QUrl &link)
{
    if (link.isRelative())
        openPlace(link.toString());
    else
        QDesktopServices::openUrl(link); // a web page or a formula of the help
}

void ManualWindow::visit(const Place &place)
{
    m_present.scroll = page().verticalScrollBar()->value();
    m_before.push_back(m_present);
    m_after.clear();
    showPlace(place);
}

void ManualWindow::walk(int by)
{
    std::vector<Place> &from = by < 0 ? m_before : m_after;
    std::vector<Place> &to = by < 0 ? m_after : m_before;
    if (from.empty())
        return;
    m_present.scroll = page().verticalScrollBar()->value();
    to.push_back(m_present);
    const Place place = from.back();
    from.pop_back();
    showPlace(place);
}

void ManualWindow::showPlace(const Place &place)
{
    const bool isOtherPage = place.page != m_present.page || page().document()->isEmpty();
    m_present = place;
    m_back->setEnabled(!m_before.empty());
    m_forward->setEnabled(!m_after.empty());
    if (m_pages.empty())
        return;
    if (isOtherPage) {
        if (findBar().isVisible())
            findBar().closeField();
        showText();
    }
    markPlace();
    QScrollBar *bar = page().verticalScrollBar();
    if (place.scroll >= 0 || place.section == 0) {
        bar->setValue(std::max(place.scroll, 0));
        return;
    }
    const QTextBlock block = page().document()->findBlock(positionOf(place.section));
    bar->setValue(static_cast<int>(page().document()->documentLayout()->blockBoundingRect(block).top())
                  - page().fontMetrics().lineSpacing() / 2);
}

int ManualWindow::positionOf(int section) const
{
    int headings = 0;
    const QTextDocument &text = *const_cast<ManualWindow *>(this)->page().document();
    for (QTextBlock block = text.begin(); block.isValid(); block = block.next()) {
        if (block.blockFormat().headingLevel() > 0 && headings++ == section)
            return block.position();
    }
    return 0;
}

void ManualWindow::setText(const PageColors &colors)
{
    if (m_pages.empty())
        return;
    QTextDocument &text = *page().document();
    setManualText(text, currentPage().markdown);
    layOutManual(text, {colors.text, page().palette().color(QPalette::Base), colors.heading, colors.link});
    columnChanged();
}

void ManualWindow::columnChanged()
{
    const QTextDocument &text = *page().document();
    fitManualImages(*page().document(), page().viewport()->width() - 2.0 * text.documentMargin(), devicePixelRatioF());
}

void ManualWindow::keyPressEvent(QKeyEvent *event)
{
    if (event->key() == Qt::Key_Escape && m_search->hasFocus() && !m_search->text().isEmpty()) {
        m_search->clear();
    } else if (event->key() == Qt::Key_Down && m_search->hasFocus()) {
        m_contents->setFocus(Qt::TabFocusReason);
        if (!m_contents->currentItem())
            m_contents->setCurrentItem(m_contents->topLevelItem(0));
    } else {
        ReadingWindow::keyPressEvent(event);
    }
}

void ManualWindow::resizeEvent(QResizeEvent *event)
{
    ReadingWindow::resizeEvent(event);
    if (event->size().width() != event->oldSize().width())
        m_side->setVisible(width() >= kLeastLettersForSide * fontMetrics().horizontalAdvance(u'n'));
}

void ManualWindow::fillContents()
{
    const QString words = m_search->text().simplified();
    const bool isSearch = !words.isEmpty();
    m_contents->clear();
    for (int i = 0; i < static_cast<int>(m_pages.size()); ++i) {
        const ManualPage &page = m_pages[static_cast<std::size_t>(i)];
        QTreeWidgetItem *item = makeItem(page.title, i, 0);
        bool hasHit = !isSearch;
        for (int k = 0; k < static_cast<int>(page.sections.size()); ++k) {
            const ManualSection &section = page.sections[static_cast<std::size_t>(k)];
            const bool isHit = isSearch ? !wordsIn(section, words).isEmpty() : section.level <= kDeepestLevel;
            hasHit |= isHit;
            if (isHit && k > 0)
                item->addChild(makeItem(section.title, i, k));
        }
        if (!hasHit) {
            delete item;
            continue;
        }
        m_contents->addTopLevelItem(item);
        item->setExpanded(isSearch);
    }
    if (isSearch && m_contents->topLevelItemCount() == 0) {
        auto *none = new QTreeWidgetItem(m_contents, {tr("No page has these words.")});
        none->setFlags(Qt::NoItemFlags);
    }
    if (isSearch)
        m_contents->setCurrentItem(nullptr);
    else
        markPlace();
}

void ManualWindow::markPlace()
{
    if (!m_search->text().simplified().isEmpty())
        return;
    for (int i = 0; i < m_contents->topLevelItemCount(); ++i) {
        QTreeWidgetItem *item = m_contents->topLevelItem(i);
        const bool isPresent = item->data(0, kPageRole).toInt() == m_present.page;
        item->setExpanded(isPresent);
        if (!isPresent)
            continue;
        QTreeWidgetItem *current = item;
        for (int k = 0; k < item->childCount(); ++k) {
            if (item->child(k)->data(0, kSectionRole).toInt() == m_present.section)
                current = item->child(k);
        }
        m_contents->setCurrentItem(current);
        m_contents->scrollToItem(item);
    }
}

void ManualWindow::openHit(const QTreeWidgetItem &item)
{
    if (!(item.flags() & Qt::ItemIsEnabled)) // it says that no page has the words
        return;
    const int page = item.data(0, kPageRole).toInt();
    int section = item.data(0, kSectionRole).toInt();
    const QString words = m_search->text().simplified();
    const std::vector<ManualSection> &sections = m_pages[static_cast<std::size_t>(page)].sections;
    QString marked;
    // A page opens at its first section with a hit.
    for (std::size_t k = static_cast<std::size_t>(section); !words.isEmpty() && k < sections.size(); ++k) {
        marked = wordsIn(sections[k], words);
        if (!marked.isEmpty()) {
            section = static_cast<int>(k);
            break;
        }
    }
    const Place place{page, section, -1};
    if (page != m_present.page || section != m_present.section)
        visit(place);
    else
        showPlace(place); // a second click scrolls back to it and adds nothing to the history
    if (!marked.isEmpty())
        findBar().find(marked, positionOf(section));
}

} // namespace unprojector::gui
