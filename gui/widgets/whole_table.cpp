#include "gui/widgets/whole_table.h"

#include <QEvent>
#include <QHeaderView>
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
    setFixedHeight(verticalHeader()->length() + horizontalHeader()->sizeHint().height()
                   + horizontalScrollBar()->sizeHint().height() + 2 * frameWidth());
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

} // namespace unprojector::gui
