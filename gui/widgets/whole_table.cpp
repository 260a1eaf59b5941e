#include "gui/widgets/whole_table.h"

#include <QEvent>
#include <QHeaderView>
#include <QResizeEvent>
#include <QScrollBar>

namespace unprojector::gui {

WholeTable::WholeTable(int rows, int columns, QWidget *parent) : QTableWidget(rows, columns, parent)
{
    setEditTriggers(NoEditTriggers);
    setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setHorizontalScrollMode(ScrollPerPixel);
    setTabKeyNavigation(false);
    for (int row = 0; row < rows; ++row) {
        for (int column = 0; column < columns; ++column)
            setItem(row, column, new QTableWidgetItem);
    }
}

void WholeTable::fit()
{
    if (!isVisible())
        return;
    resizeColumnsToContents();
    resizeRowsToContents();
    const bool scrolls = !horizontalHeader()->stretchLastSection()
                         && horizontalHeader()->length() > width() - verticalHeader()->width() - 2 * frameWidth();
    setFixedHeight(verticalHeader()->length() + horizontalHeader()->sizeHint().height()
                   + (scrolls ? horizontalScrollBar()->sizeHint().height() : 0) + 2 * frameWidth());
}

void WholeTable::changeEvent(QEvent *event)
{
    QTableWidget::changeEvent(event);
    if (event->type() == QEvent::FontChange || event->type() == QEvent::StyleChange)
        fit();
}

void WholeTable::showEvent(QShowEvent *event)
{
    QTableWidget::showEvent(event);
    fit();
}

void WholeTable::resizeEvent(QResizeEvent *event)
{
    QTableWidget::resizeEvent(event);
    if (event->size().width() != event->oldSize().width())
        fit();
}

} // namespace unprojector::gui
