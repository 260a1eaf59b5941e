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

#include <algorithm>
#include <cmath>

namespace unprojector::gui {

CoordinatesTable::CoordinatesTable(CoordinatesModel *model, const QStringList &rowNames, QWidget *parent)
    : QTableView(parent), m_model(model), m_rowNames(rowNames)
{
    setModel(model);
    setItemDelegate(new CertainDigitsDelegate(this));
    useQuietSelection(*this);
    setHorizontalScrollMode(ScrollPerPixel);
    setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    setTabKeyNavigation(false);
    setWordWrap(false);
    setTextElideMode(Qt::ElideMiddle); // a number that does not fit shows that it does not
    horizontalHeader()->setSectionResizeMode(QHeaderView::Fixed);
    horizontalHeader()->setMinimumSectionSize(1);
    horizontalHeader()->setHighlightSections(false);
    verticalHeader()->setSectionResizeMode(QHeaderView::Fixed);
    useFonts();
}

void CoordinatesTable::useFonts()
{
    const QFont text = QApplication::font(this);
    setFont(digitsFont(text));
    const QFont heads = headsFont(text);
    horizontalHeader()->setFont(heads);
    verticalHeader()->setFont(heads);
    int longest = 0, highest = std::max(fontMetrics().height(), QFontMetrics(heads).height());
    for (const QString &name : m_rowNames) {
        longest = std::max(longest, QFontMetrics(heads).horizontalAdvance(name));
        highest = std::max(highest, lineHeight(heads, name));
    }
    verticalHeader()->setDefaultSectionSize(highest + 4);
    verticalHeader()->setFixedWidth(longest + 3 * kPadding / 2);
}

int CoordinatesTable::columnWidthFor(int column, int characters) const
{
    const int head =
        horizontalHeader()->fontMetrics().horizontalAdvance(m_model->headerData(column, Qt::Horizontal).toString());
    // Digits are not always a whole number of pixels wide.
    const int digits = int(std::ceil(characters * QFontMetricsF(font()).horizontalAdvance(QStringLiteral("0"))));
    return std::max(digits, head) + kPadding;
}

int CoordinatesTable::charactersIn(int column) const
{
    return int((columnWidth(column) - kPadding) / QFontMetricsF(font()).horizontalAdvance(QStringLiteral("0")));
}

void CoordinatesTable::fitColumns()
{
    const int available = width() - verticalHeader()->minimumWidth() - 2 * frameWidth();
    shareWidth(available);
    int shown = 0;
    for (int column = 0; column < m_model->columnCount(); ++column)
        shown += isColumnHidden(column) ? 0 : columnWidth(column);
    const int scrollBar = shown > available ? style()->pixelMetric(QStyle::PM_ScrollBarExtent) : 0;
    setFixedHeight(horizontalHeader()->sizeHint().height()
                   + m_model->rowCount() * verticalHeader()->defaultSectionSize() + 2 * frameWidth() + scrollBar);
}

QSize CoordinatesTable::sizeHint() const
{
    return {verticalHeader()->minimumWidth() + 2 * frameWidth() + leastWidth(), minimumHeight()};
}

QSize CoordinatesTable::minimumSizeHint() const
{
    constexpr int kLeast = 11; // "-0.12345678"
    return {verticalHeader()->minimumWidth() + 2 * frameWidth() + columnWidthFor(0, kLeast), minimumHeight()};
}

void CoordinatesTable::resizeEvent(QResizeEvent *event)
{
    QTableView::resizeEvent(event);
    fitColumns();
}

void CoordinatesTable::changeEvent(QEvent *event)
{
    QTableView::changeEvent(event);
    if (event->type() == QEvent::ApplicationFontChange) {
        useFonts();
        fitColumns();
    }
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

/// Of the cell under the pointer, or by the key of the current one.
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
    QModelIndexList selected = selectionModel()->selectedIndexes();
    std::sort(selected.begin(), selected.end());
    QString text;
    int row = -1;
    for (const QModelIndex &index : selected) {
        if (!text.isEmpty())
            text += index.row() == row ? u'\t' : u'\n';
        row = index.row();
        const QString copied = m_model->copied(index);
        text += copied.isEmpty() ? index.data().toString() : copied;
    }
    return text;
}

} // namespace unprojector::gui
