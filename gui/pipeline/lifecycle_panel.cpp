#include "gui/pipeline/lifecycle_panel.h"

#include "gui/text/fitted_text.h"
#include "gui/view/lifecycle_log.h"
#include "gui/widgets/copy_menu.h"
#include "gui/widgets/digits_font.h"
#include "gui/widgets/help_link.h"

#include <QAction>
#include <QBoxLayout>
#include <QEvent>
#include <QHeaderView>
#include <QLabel>
#include <QScrollBar>
#include <QStyledItemDelegate>
#include <QTimer>
#include <QToolButton>
#include <QTreeView>

#include <algorithm>
#include <utility>

namespace unprojector::gui {
namespace {

constexpr int kPadding = 8; ///< of a cell, both sides
constexpr int kMargin = 6;  ///< of the panel

/// Cuts a call before or behind a number.
class CallsDelegate : public QStyledItemDelegate {
public:
    using QStyledItemDelegate::QStyledItemDelegate;

protected:
    void initStyleOption(QStyleOptionViewItem *option, const QModelIndex &index) const override
    {
        QStyledItemDelegate::initStyleOption(option, index);
        if (const int width = option->rect.width() - kPadding; width > 0) // else the wanted size is asked for
            option->text = elidedSentence(option->text, width, [option](const QString &text) {
                return option->fontMetrics.horizontalAdvance(text);
            });
    }
};

} // namespace

LifecyclePanel::LifecyclePanel(LifecycleLog &log, QWidget *parent) : QWidget(parent), m_log(log)
{
    m_table = new QTreeView;
    m_table->setModel(&m_log);
    m_table->setAccessibleName(tr("Steps of the view's life"));
    m_table->setToolTip(tr("To open a row of several steps, click its arrow or press Right"));
    m_table->setSelectionMode(QAbstractItemView::ExtendedSelection);
    m_table->setUniformRowHeights(true); // a call has one line; the current row is shown in full below
    m_table->setAllColumnsShowFocus(true);
    m_table->setAlternatingRowColors(true);
    m_table->setTreePosition(LifecycleLog::Step);
    m_table->setItemDelegateForColumn(LifecycleLog::Step, new CallsDelegate(m_table));
    m_table->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    QHeaderView *header = m_table->header();
    header->setHighlightSections(false);
    header->setSectionsMovable(false);
    header->setStretchLastSection(false);
    header->setSectionResizeMode(QHeaderView::Fixed);
    // Short columns come before columns that may be long.
    header->moveSection(LifecycleLog::Took, LifecycleLog::Step);
    m_table->viewport()->installEventFilter(this);

    m_calls = new QLabel;
    m_calls->setWordWrap(true);
    m_calls->setTextFormat(Qt::PlainText);
    m_calls->setTextInteractionFlags(Qt::TextSelectableByMouse);
    m_calls->setAccessibleName(tr("The current step with all its calls"));
    m_calls->hide();

    // Styles make push buttons far wider than these short words; the calls need the room.
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
    auto *steps = new QVBoxLayout;
    steps->addWidget(m_table, 1);
    steps->addWidget(m_calls);
    m_layout->addLayout(steps, 1);
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
    connect(m_table->verticalScrollBar(), &QScrollBar::rangeChanged, this, &LifecyclePanel::follow);
    connect(&m_log, &QAbstractItemModel::rowsInserted, this, &LifecyclePanel::enableButtons);
    // A folded row changes with each of its steps.
    connect(&m_log, &QAbstractItemModel::dataChanged, this, &LifecyclePanel::showCalls);
    connect(&m_log, &QAbstractItemModel::modelReset, this, [this] {
        enableButtons();
        showCalls();
    });
    connect(m_table->selectionModel(), &QItemSelectionModel::currentChanged, this, &LifecyclePanel::showCalls);
    enableButtons();
    useFont();
}

void LifecyclePanel::useFont()
{
    m_table->header()->setFont(headsFont(font()));
    m_table->setFont(digitsFont(font()));
    fitColumns();
    placeButtons();
}

/// Number columns fit the longest expected number, so that they don't move; steps and calls share
/// the rest.
void LifecyclePanel::fitColumns()
{
    const QFontMetrics metrics(m_table->font());
    m_table->setIndentation(2 * metrics.horizontalAdvance(u'0'));
    const auto widthOf = [&](int column, const QString &widest) {
        const int head =
            m_table->header()->fontMetrics().horizontalAdvance(m_log.headerData(column, Qt::Horizontal).toString());
        return std::max(metrics.horizontalAdvance(widest), head) + kPadding;
    };
    const int time = widthOf(LifecycleLog::Time, QStringLiteral("888.888 s")),
              took = widthOf(LifecycleLog::Took, QStringLiteral("888.88 ms")),
              step =
                  widthOf(LifecycleLog::Step, QStringLiteral("OnLButtonDown(8888, 888)")) + 2 * m_table->indentation();
    m_wholeWidth =
        time + took + step + widthOf(LifecycleLog::StandsFor, QStringLiteral("glViewport(0, 0, 8888, 8888)"));
    const int rest = std::max(0, m_table->viewport()->width() - time - took), shownStep = std::min(step, rest / 2);
    m_table->setColumnWidth(LifecycleLog::Time, time);
    m_table->setColumnWidth(LifecycleLog::Took, took);
    m_table->setColumnWidth(LifecycleLog::Step, shownStep);
    m_table->setColumnWidth(LifecycleLog::StandsFor, rest - shownStep);
}

void LifecyclePanel::showCalls()
{
    const QModelIndex current = m_table->currentIndex();
    m_calls->setVisible(current.isValid());
    if (current.isValid())
        m_calls->setText(current.siblingAtColumn(LifecycleLog::Step).data().toString() + QStringLiteral(": ")
                         + current.siblingAtColumn(LifecycleLog::StandsFor).data().toString());
}

/// Puts the buttons beside the steps, or below them if that would leave too little room for the
/// calls.
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

LifecyclePanel::~LifecyclePanel()
{
    m_table->verticalScrollBar()->disconnect(this); // it moves while the table is destroyed
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

/// Deferred to the event loop: steps are reported during painting, when scrolling is not allowed.
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
    // The order is the table's: a folded row before its steps.
    const auto place = [](const QModelIndex &index) {
        return index.parent().isValid() ? std::pair(index.parent().row(), index.row()) : std::pair(index.row(), -1);
    };
    std::sort(selected.begin(), selected.end(),
              [&place](const QModelIndex &a, const QModelIndex &b) { return place(a) < place(b); });
    QString text;
    for (const QModelIndex &index : selected)
        text += m_log.text(index);
    copyToClipboard(selected.isEmpty() ? m_log.text(0, m_log.rowCount() - 1) : text);
}

} // namespace unprojector::gui
