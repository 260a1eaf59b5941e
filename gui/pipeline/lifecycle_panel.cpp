#include "gui/pipeline/lifecycle_panel.h"

#include "gui/view/lifecycle_log.h"
#include "gui/widgets/copy_menu.h"
#include "gui/widgets/digits_font.h"
#include "gui/widgets/help_link.h"

#include <QAction>
#include <QBoxLayout>
#include <QEvent>
#include <QHeaderView>
#include <QScrollBar>
#include <QTableView>
#include <QTimer>
#include <QToolButton>

#include <algorithm>

namespace unprojector::gui {
namespace {

constexpr int kPadding = 8; ///< of a cell, both sides
constexpr int kRowMargin = 4;
constexpr int kMargin = 6; ///< of the panel

} // namespace

LifecyclePanel::LifecyclePanel(LifecycleLog &log, QWidget *parent) : QWidget(parent), m_log(log)
{
    m_table = new QTableView;
    m_table->setModel(&m_log);
    m_table->setAccessibleName(tr("Steps of the view's life"));
    m_table->setSelectionBehavior(QAbstractItemView::SelectRows);
    m_table->setTabKeyNavigation(false);
    m_table->setWordWrap(true); // a call is shown whole
    m_table->setShowGrid(false);
    m_table->setAlternatingRowColors(true);
    m_table->verticalHeader()->hide();
    m_table->verticalHeader()->setSectionResizeMode(QHeaderView::Fixed);
    QHeaderView *header = m_table->horizontalHeader();
    header->setHighlightSections(false);
    header->setSectionResizeMode(QHeaderView::Fixed);
    m_table->setHorizontalScrollMode(QAbstractItemView::ScrollPerPixel);
    // What is short stands before what may be long.
    header->moveSection(LifecycleLog::Took, LifecycleLog::Step);
    m_table->viewport()->installEventFilter(this);

    // A style makes push buttons far wider than these short words; the calls need the room more.
    m_copy = new QToolButton;
    m_copy->setText(tr("&Copy"));
    m_copy->setToolTip(tr("Copy the selected steps, or all of them, as lines of text"));
    m_clear = new QToolButton;
    m_clear->setText(tr("C&lear"));
    m_clear->setToolTip(tr("Remove all steps from the log"));
    for (QToolButton *button : {m_copy, m_clear}) {
        button->setFocusPolicy(Qt::StrongFocus);
        button->setSizePolicy(QSizePolicy::Minimum, QSizePolicy::Fixed); // both as wide as the wider
    }
    m_buttons = new QBoxLayout(QBoxLayout::TopToBottom);
    m_buttons->addWidget(m_copy);
    m_buttons->addWidget(m_clear);
    m_buttons->addStretch();
    m_buttons->addWidget(new HelpLink(QStringLiteral("mfc")), 0, Qt::AlignRight);
    m_layout = new QBoxLayout(QBoxLayout::LeftToRight, this);
    m_layout->addWidget(m_table, 1);
    m_layout->addLayout(m_buttons);

    auto *copyKey = new QAction(tr("Copy"), m_table);
    copyKey->setShortcut(QKeySequence::Copy);
    copyKey->setShortcutContext(Qt::WidgetShortcut);
    m_table->addAction(copyKey);
    m_table->setContextMenuPolicy(Qt::ActionsContextMenu);
    connect(copyKey, &QAction::triggered, this, &LifecyclePanel::copy);
    connect(m_copy, &QToolButton::clicked, this, &LifecyclePanel::copy);
    connect(m_clear, &QToolButton::clicked, this, [this] {
        m_log.clear();
        m_follows = true;
    });
    connect(m_table->verticalScrollBar(), &QScrollBar::valueChanged, this,
            [this](int value) { m_follows = value == m_table->verticalScrollBar()->maximum(); });
    connect(&m_log, &QAbstractItemModel::rowsInserted, this, [this](const QModelIndex &, int first) {
        enableButtons();
        fitRow(first);
        follow();
    });
    // Pictures in a row are one step, whose text changes with each.
    connect(&m_log, &QAbstractItemModel::dataChanged, this, [this](const QModelIndex &first) { fitRow(first.row()); });
    connect(&m_log, &QAbstractItemModel::modelReset, this, &LifecyclePanel::enableButtons);
    enableButtons();
    useFont();
}

void LifecyclePanel::useFont()
{
    m_table->horizontalHeader()->setFont(headsFont(font()));
    fitColumns();
    placeButtons();
}

/// The type gets smaller where that shows all columns side by side: in some fonts, letters are wide beside the digits that the
/// panel's width is counted in.
void LifecyclePanel::fitColumns()
{
    constexpr int kLeastPercent = 70, kStep = 5;
    // With the scroll bar, there or not: whether it is depends on the type.
    const int room = m_table->width() - 2 * m_table->frameWidth() - m_table->verticalScrollBar()->sizeHint().width();
    m_wholeWidth = reserveColumns(1.0);
    int needed = m_wholeWidth;
    for (int percent = 100 - kStep; needed > room && percent >= kLeastPercent; percent -= kStep)
        needed = reserveColumns(percent / 100.0);
    fitCalls();
}

/// @return what all columns need, the calls as little as can be read
int LifecyclePanel::reserveColumns(double scale)
{
    QFont digits = digitsFont(font());
    digits.setPointSizeF(scale * digits.pointSizeF());
    if (m_table->font() != digits)
        m_table->setFont(digits);
    const QFontMetrics metrics(digits);
    m_table->verticalHeader()->setDefaultSectionSize(metrics.height() + kRowMargin);
    // The widths are those of the longest texts to expect, so that the columns stand still; the calls have the rest.
    const auto reserve = [&](int column, const QString &widest) {
        const int head = m_table->horizontalHeader()->fontMetrics().horizontalAdvance(
            m_log.headerData(column, Qt::Horizontal).toString());
        m_table->setColumnWidth(column, std::max(metrics.horizontalAdvance(widest), head) + kPadding);
        return m_table->columnWidth(column);
    };
    m_leastCallsWidth = metrics.horizontalAdvance(QStringLiteral("GL_DEPTH_COMPONENT,")) + kPadding;
    return reserve(LifecycleLog::Time, QStringLiteral("8888.888 s"))
           + reserve(LifecycleLog::Step, QStringLiteral("OnLButtonDown(8888.8,"))
           + reserve(LifecycleLog::Took, QStringLiteral("888.88 ms,")) // and the mean in a second line
           + m_leastCallsWidth;
}

/// Beside the steps; below them, which then have the whole width, where that would leave too little room for the calls.
void LifecyclePanel::placeButtons()
{
    const int least = 2 * kMargin + m_layout->spacing()
                      + std::max(m_copy->sizeHint().width(), m_clear->sizeHint().width()) + 2 * m_table->frameWidth()
                      + m_table->verticalScrollBar()->sizeHint().width() + m_wholeWidth;
    const bool isBeside = width() >= least;
    const int tableMargin = isBeside ? kMargin : 0, buttonMargin = isBeside ? 0 : kMargin;
    m_layout->setDirection(isBeside ? QBoxLayout::LeftToRight : QBoxLayout::TopToBottom);
    m_layout->setContentsMargins(tableMargin, kMargin, tableMargin, kMargin);
    m_buttons->setDirection(isBeside ? QBoxLayout::TopToBottom : QBoxLayout::LeftToRight);
    m_buttons->setContentsMargins(buttonMargin, 0, buttonMargin, 0);
}

void LifecyclePanel::resizeEvent(QResizeEvent *event)
{
    placeButtons();
    QWidget::resizeEvent(event);
}

void LifecyclePanel::changeEvent(QEvent *event)
{
    QWidget::changeEvent(event);
    if (m_table && (event->type() == QEvent::FontChange || event->type() == QEvent::ApplicationFontChange))
        useFont();
}

bool LifecyclePanel::eventFilter(QObject *watched, QEvent *event)
{
    if (event->type() == QEvent::Resize)
        fitColumns();
    return QWidget::eventFilter(watched, event);
}

/// The calls have the room that the other columns leave, and in a narrow panel enough to be read: then it scrolls.
void LifecyclePanel::fitCalls()
{
    int others = 0;
    for (const int column : {LifecycleLog::Time, LifecycleLog::Step, LifecycleLog::Took})
        others += m_table->columnWidth(column);
    m_table->setColumnWidth(LifecycleLog::StandsFor,
                            std::max(m_leastCallsWidth, m_table->viewport()->width() - others));
    for (int row = 0; row < m_log.rowCount(); ++row)
        fitRow(row);
}

/// As many lines as its longest text needs.
void LifecyclePanel::fitRow(int row)
{
    const QFontMetrics metrics(m_table->font());
    int height = 0;
    for (const int column : {LifecycleLog::Step, LifecycleLog::StandsFor, LifecycleLog::Took}) {
        const QRect room(0, 0, m_table->columnWidth(column) - kPadding, 1 << 16);
        height = std::max(
            height, metrics.boundingRect(room, Qt::TextWordWrap, m_log.index(row, column).data().toString()).height());
    }
    if (m_table->rowHeight(row) != height + kRowMargin)
        m_table->setRowHeight(row, height + kRowMargin);
}

QSize LifecyclePanel::sizeHint() const
{
    return {100 * fontMetrics().horizontalAdvance(u'0'), 12 * fontMetrics().lineSpacing()};
}

QSize LifecyclePanel::minimumSizeHint() const
{
    return {40 * fontMetrics().horizontalAdvance(u'0'), 6 * fontMetrics().lineSpacing()};
}

void LifecyclePanel::showEvent(QShowEvent *event)
{
    QWidget::showEvent(event);
    follow();
}

/// Later, when the event loop runs: steps are reported while the view paints, when nothing may be scrolled.
void LifecyclePanel::follow()
{
    if (!m_follows || m_willFollow || !isVisible())
        return;
    m_willFollow = true;
    QTimer::singleShot(0, this, [this] {
        m_willFollow = false;
        if (!m_follows)
            return;
        m_table->scrollToBottom();
        m_follows = true;
    });
}

void LifecyclePanel::enableButtons()
{
    const bool hasRows = m_log.rowCount() > 0;
    m_copy->setEnabled(hasRows);
    m_clear->setEnabled(hasRows);
}

void LifecyclePanel::copy() const
{
    QModelIndexList selected = m_table->selectionModel()->selectedRows();
    std::sort(selected.begin(), selected.end());
    QString text;
    for (const QModelIndex &index : selected)
        text += m_log.text(index.row(), index.row());
    copyToClipboard(selected.isEmpty() ? m_log.text(0, m_log.rowCount() - 1) : text);
}

} // namespace unprojector::gui
