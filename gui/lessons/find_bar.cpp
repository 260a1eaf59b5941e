#include "gui/lessons/find_bar.h"

#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QRegularExpression>
#include <QScrollBar>
#include <QTextDocument>
#include <QTextEdit>
#include <QToolButton>

#include <algorithm>

namespace unprojector::gui {
namespace {

constexpr int kFieldLetters = 28;
constexpr int kMostHits = 9999;

QToolButton *button(const QString &tip)
{
    auto *made = new QToolButton;
    made->setAutoRaise(true);
    made->setFocusPolicy(Qt::TabFocus);
    made->setToolTip(tip);
    made->setAccessibleName(tip);
    return made;
}

} // namespace

QRegularExpression findPattern(const QString &words)
{
    QString pattern = QRegularExpression::escape(words);
    pattern.replace(QStringLiteral("\\-"), QStringLiteral("[-−–]"));
    pattern.replace(QStringLiteral("\\'"), QStringLiteral("['’′]"));
    return QRegularExpression(pattern, QRegularExpression::CaseInsensitiveOption
                                           | QRegularExpression::UseUnicodePropertiesOption);
}

FindBar::FindBar(QTextEdit &page, QWidget *parent)
    : QWidget(parent), m_page(page), m_field(new QLineEdit), m_count(new QLabel),
      m_previous(button(tr("Previous match (Shift+F3)"))), m_next(button(tr("Next match (F3)")))
{
    m_field->setPlaceholderText(tr("Find in the page"));
    m_field->setAccessibleName(tr("Find in the page"));
    m_field->setToolTip(tr("Text to find; capitals do not matter"));
    m_field->setClearButtonEnabled(true);
    m_field->setFixedWidth(kFieldLetters * fontMetrics().horizontalAdvance(u'n'));
    m_previous->setArrowType(Qt::UpArrow);
    m_next->setArrowType(Qt::DownArrow);
    m_count->setAccessibleName(tr("Matches"));
    int widest = 0;
    for (const QString &text : {tr("%1 of %2").arg(kMostHits).arg(kMostHits), tr("Nothing found")})
        widest = std::max(widest, fontMetrics().horizontalAdvance(text));
    m_count->setMinimumWidth(widest);
    QToolButton *closing = button(tr("Close (Esc)"));
    closing->setText(QStringLiteral("×"));

    auto *layout = new QHBoxLayout(this);
    layout->setContentsMargins(8, 4, 4, 4);
    layout->addWidget(m_field);
    layout->addWidget(m_previous);
    layout->addWidget(m_next);
    layout->addWidget(m_count);
    layout->addStretch();
    layout->addWidget(closing);
    setFocusProxy(m_field);
    hide();

    connect(m_field, &QLineEdit::textChanged, this, [this] {
        if (isVisible()) // a hidden bar has no marks; the next opening searches
            search(m_start);
    });
    connect(m_previous, &QToolButton::clicked, this, &FindBar::findPrevious);
    connect(m_next, &QToolButton::clicked, this, &FindBar::findNext);
    connect(closing, &QToolButton::clicked, this, &FindBar::closeField);
}

void FindBar::openField()
{
    if (!isVisible()) {
        show();
        m_start = firstVisiblePosition();
        search(m_start);
    }
    m_field->setFocus(Qt::ShortcutFocusReason);
    m_field->selectAll();
}

void FindBar::find(const QString &words, int from)
{
    show();
    m_start = from;
    const QSignalBlocker blocker(m_field);
    m_field->setText(words);
    search(m_start);
}

void FindBar::closeField()
{
    if (m_present >= 0)
        m_page.setTextCursor(m_hits[static_cast<std::size_t>(m_present)]);
    m_hits.clear();
    m_present = -1;
    m_page.setExtraSelections({});
    hide();
    m_page.setFocus();
}

void FindBar::searchAgain()
{
    if (isVisible())
        search(m_start);
}

int FindBar::firstVisiblePosition() const
{
    return m_page.cursorForPosition({0, 0}).position();
}

/// Marks all hits and shows the first one from a position on, or the page's first.
/// @param from  a text position
void FindBar::search(int from)
{
    m_hits.clear();
    m_present = -1;
    if (!m_field->text().isEmpty()) {
        const QRegularExpression pattern = findPattern(m_field->text());
        const QTextDocument &text = *m_page.document();
        for (QTextCursor hit = text.find(pattern, 0); !hit.isNull() && hit.hasSelection();
             hit = text.find(pattern, hit))
            m_hits.push_back(hit);
    }
    if (!m_hits.empty()) {
        const auto hit = std::find_if(m_hits.begin(), m_hits.end(),
                                      [from](const QTextCursor &one) { return one.selectionStart() >= from; });
        m_present = hit == m_hits.end() ? 0 : static_cast<int>(hit - m_hits.begin());
    }
    showHit();
}

void FindBar::step(int by)
{
    if (!isVisible()) {
        openField();
        return;
    }
    if (m_hits.empty())
        return;
    const int count = static_cast<int>(m_hits.size());
    m_present = (m_present + by + count) % count;
    m_start = m_hits[static_cast<std::size_t>(m_present)].selectionStart();
    showHit();
}

void FindBar::showHit()
{
    m_previous->setEnabled(!m_hits.empty());
    m_next->setEnabled(!m_hits.empty());
    m_count->setText(m_field->text().isEmpty() ? QString()
                     : m_hits.empty()          ? tr("Nothing found")
                                               : tr("%1 of %2").arg(m_present + 1).arg(m_hits.size()));
    mark();
    if (m_present < 0)
        return;
    QTextCursor place = m_hits[static_cast<std::size_t>(m_present)];
    place.setPosition(place.selectionStart());
    m_page.setTextCursor(place);
    // Scrolls with some context before the hit if it was out of view.
    const QRect rect = m_page.cursorRect(place);
    const int height = m_page.viewport()->height();
    if (rect.top() < rect.height() || rect.bottom() > height - rect.height())
        m_page.verticalScrollBar()->setValue(m_page.verticalScrollBar()->value() + rect.top() - height / 3);
}

void FindBar::mark()
{
    const QPalette colors = m_page.palette();
    QColor quiet = colors.color(QPalette::Active, QPalette::Highlight);
    quiet.setAlphaF(0.3F);
    QList<QTextEdit::ExtraSelection> marks;
    for (std::size_t i = 0; i < m_hits.size(); ++i) {
        QTextEdit::ExtraSelection mark;
        mark.cursor = m_hits[i];
        mark.format.setBackground(quiet);
        if (static_cast<int>(i) == m_present) {
            mark.format.setBackground(colors.color(QPalette::Active, QPalette::Highlight));
            mark.format.setForeground(colors.color(QPalette::Active, QPalette::HighlightedText));
        }
        marks << mark;
    }
    m_page.setExtraSelections(marks);
}

void FindBar::keyPressEvent(QKeyEvent *event)
{
    switch (event->key()) {
    case Qt::Key_Return:
    case Qt::Key_Enter: step(event->modifiers() & Qt::ShiftModifier ? -1 : 1); break;
    case Qt::Key_Escape: closeField(); break;
    default: QWidget::keyPressEvent(event);
    }
}

} // namespace unprojector::gui
