#include "gui/click/coordinates_table.h"

#include "gui/widgets/certain_digits_delegate.h"
#include "gui/widgets/coordinates_model.h"
#include "gui/widgets/copy_menu.h"
#include "gui/widgets/digits_font.h"
#include "gui/widgets/quiet_selection.h"

#include <QApplication>
#include <QContextMenuEvent>
#include <QHeaderView>
#include <QKeyEvent>
#include <QScrollBar>
#include <QStyle>

#include <algorithm>
#include <cmath>

namespace unprojector::gui {
namespace {

constexpr int kPadding = 8; // of a cell, both sides

} // namespace

CoordinatesTable::CoordinatesTable(CoordinatesModel *model, QWidget *parent) : QTableView(parent), m_model(model)
{
    setModel(model);
    setItemDelegate(new CertainDigitsDelegate(this));
    useQuietSelection(*this);
    setHorizontalScrollMode(ScrollPerPixel);
    setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    setTabKeyNavigation(false);
    setWordWrap(false);
    setTextElideMode(Qt::ElideNone);
    horizontalHeader()->setSectionResizeMode(QHeaderView::Fixed);
    horizontalHeader()->setMinimumSectionSize(1);
    horizontalHeader()->setHighlightSections(false);
    verticalHeader()->setSectionResizeMode(QHeaderView::Fixed);
    const auto refit = [this] {
        measure();
        fit();
    };
    connect(model, &QAbstractItemModel::modelReset, this, refit);
    connect(model, &QAbstractItemModel::dataChanged, this, refit);
    connect(model, &QAbstractItemModel::headerDataChanged, this, refit);
    useFonts();
}

void CoordinatesTable::useFonts()
{
    const QFont text = QApplication::font(this);
    setFont(digitsFont(text));
    const QFont heads = headsFont(text);
    horizontalHeader()->setFont(heads);
    verticalHeader()->setFont(heads);
    const int height = std::max({fontMetrics().height(), QFontMetrics(heads).height(), lineHeight(heads, tr("Near"))});
    verticalHeader()->setDefaultSectionSize(height + 4);
    m_widths.assign(static_cast<std::size_t>(m_model->columnCount()), 0);
    measure();
    fit();
}

void CoordinatesTable::setColumnShown(int column, bool isShown)
{
    setColumnHidden(column, !isShown);
    fit();
    // Scrolls to new columns; back to the first if they are hidden again.
    horizontalScrollBar()->setValue(isShown ? horizontalScrollBar()->maximum() : 0);
}

void CoordinatesTable::measure()
{
    const QFontMetricsF digits(font()), heads(horizontalHeader()->font());
    // Room for a number of usual length, so that few clicks need more.
    const double ordinary = digits.horizontalAdvance(QStringLiteral("-0.12345"));
    for (int column = 0; column < m_model->columnCount(); ++column) {
        double width =
            std::max(ordinary, heads.horizontalAdvance(m_model->headerData(column, Qt::Horizontal).toString()));
        for (int row = 0; row < m_model->rowCount(); ++row)
            width = std::max(width, digits.horizontalAdvance(m_model->index(row, column).data().toString()));
        int &kept = m_widths[static_cast<std::size_t>(column)];
        kept = std::max(kept, static_cast<int>(std::ceil(width)) + kPadding);
    }
    int widest = 0;
    for (int row = 0; row < m_model->rowCount(); ++row)
        widest = std::max(widest, QFontMetrics(verticalHeader()->font())
                                      .horizontalAdvance(m_model->headerData(row, Qt::Vertical).toString()));
    verticalHeader()->setFixedWidth(widest + 3 * kPadding / 2);
}

/// Distributes remaining room over the columns.
void CoordinatesTable::fit()
{
    int needed = 0, shown = 0;
    for (int column = 0; column < m_model->columnCount(); ++column) {
        if (isColumnHidden(column))
            continue;
        needed += m_widths[static_cast<std::size_t>(column)];
        ++shown;
    }
    const int available = width() - verticalHeader()->minimumWidth() - 2 * frameWidth();
    const int extra = shown > 0 ? std::max(0, available - needed) / shown : 0;
    for (int column = 0; column < m_model->columnCount(); ++column)
        setColumnWidth(column, m_widths[static_cast<std::size_t>(column)] + extra);
    const bool scrolls = needed > available;
    setHorizontalScrollBarPolicy(scrolls ? Qt::ScrollBarAlwaysOn : Qt::ScrollBarAlwaysOff);
    const int scrollBar = scrolls ? style()->pixelMetric(QStyle::PM_ScrollBarExtent) : 0;
    setFixedHeight(horizontalHeader()->sizeHint().height()
                   + m_model->rowCount() * verticalHeader()->defaultSectionSize() + 2 * frameWidth() + scrollBar);
    updateGeometry();
}

QSize CoordinatesTable::sizeHint() const
{
    int needed = 0;
    for (int column = 0; column < m_model->columnCount(); ++column)
        needed += isColumnHidden(column) ? 0 : m_widths[static_cast<std::size_t>(column)];
    return {verticalHeader()->minimumWidth() + 2 * frameWidth() + needed, minimumHeight()};
}

QSize CoordinatesTable::minimumSizeHint() const
{
    constexpr int kLeastDigits = 20; // the rest is scrolled to
    return {kLeastDigits * fontMetrics().horizontalAdvance(u'0'), minimumHeight()};
}

void CoordinatesTable::resizeEvent(QResizeEvent *event)
{
    QTableView::resizeEvent(event);
    fit();
}

void CoordinatesTable::changeEvent(QEvent *event)
{
    QTableView::changeEvent(event);
    if (event->type() == QEvent::ApplicationFontChange)
        useFonts();
}

void CoordinatesTable::keyPressEvent(QKeyEvent *event)
{
    if (event->matches(QKeySequence::Copy)) {
        if (const QString text = selectedText(); !text.isEmpty())
            copyToClipboard(text);
        return;
    }
    QTableView::keyPressEvent(event);
}

/// The menu of the cell under the pointer; by the key, of the current one.
void CoordinatesTable::contextMenuEvent(QContextMenuEvent *event)
{
    const bool isByKey = event->reason() == QContextMenuEvent::Keyboard;
    const QModelIndex index = isByKey ? currentIndex() : indexAt(viewport()->mapFromGlobal(event->globalPos()));
    if (!index.isValid())
        return;
    const QVariant value = index.data(CoordinatesModel::kValueRole);
    const QPoint place = isByKey ? viewport()->mapToGlobal(visualRect(index).center()) : event->globalPos();
    showCopyMenu(*this, place, {{}, value.isValid() ? std::vector{value.toDouble()} : std::vector<double>()},
                 {m_model->pointNameAt(index), m_model->pointAt(index)});
}

QString CoordinatesTable::selectedText() const
{
    return selectedCells(*selectionModel(), [this](const QModelIndex &index) {
        const QString copied = m_model->copied(index);
        return copied.isEmpty() ? index.data().toString() : copied;
    });
}

} // namespace unprojector::gui
