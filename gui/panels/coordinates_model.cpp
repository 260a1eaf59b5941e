#include "gui/panels/coordinates_model.h"

#include "gui/text/number_text.h"

namespace unprojector::gui {

QString CoordinatesModel::text() const
{
    QString text;
    for (int column = 0; column < columnCount(); ++column)
        text += u'\t' + headerData(column, Qt::Horizontal).toString();
    for (int row = 0; row < rowCount(); ++row) {
        text += u'\n' + headerData(row, Qt::Vertical).toString();
        for (int column = 0; column < columnCount(); ++column) {
            const QVariant v = data(index(row, column), kValueRole);
            text += u'\t' + (v.isValid() ? shortestText(v.toDouble()) : QString());
        }
    }
    return text + u'\n';
}

} // namespace unprojector::gui
