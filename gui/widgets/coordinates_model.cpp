#include "gui/widgets/coordinates_model.h"

#include "gui/text/number_text.h"

namespace unprojector::gui {

QString CoordinatesModel::copied(const QModelIndex &index) const
{
    const QVariant value = data(index, kValueRole);
    return value.isValid() ? shortestText(value.toDouble()) : QString();
}

QString CoordinatesModel::text() const
{
    QString text;
    for (int column = 0; column < columnCount(); ++column)
        text += u'\t' + headerData(column, Qt::Horizontal).toString();
    for (int row = 0; row < rowCount(); ++row) {
        text += u'\n' + headerData(row, Qt::Vertical).toString();
        for (int column = 0; column < columnCount(); ++column)
            text += u'\t' + copied(index(row, column));
    }
    return text + u'\n';
}

} // namespace unprojector::gui
