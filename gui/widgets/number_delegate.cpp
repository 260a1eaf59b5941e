#include "gui/widgets/number_delegate.h"

#include "gui/text/fitted_text.h"

#include <QApplication>

namespace unprojector::gui {

void NumberDelegate::paint(QPainter *painter, const QStyleOptionViewItem &option, const QModelIndex &index) const
{
    QStyleOptionViewItem item = option;
    initStyleOption(&item, index);
    const QStyle *style = item.widget ? item.widget->style() : QApplication::style();
    if (const QStringList texts = index.data(kTextsRole).toStringList(); !texts.isEmpty()) {
        const int margin = style->pixelMetric(QStyle::PM_FocusFrameHMargin, &item, item.widget) + 1;
        item.text = fittedText(texts, item.rect.width() - 2 * margin,
                               [&item](const QString &text) { return item.fontMetrics.horizontalAdvance(text); });
    }
    style->drawControl(QStyle::CE_ItemViewItem, &item, painter, item.widget);
}

} // namespace unprojector::gui
