#include "gui/panels/certain_digits_delegate.h"

#include "gui/panels/comparison_model.h"

#include <QApplication>
#include <QPainter>

namespace unprojector::gui {

void CertainDigitsDelegate::paint(QPainter *painter, const QStyleOptionViewItem &option, const QModelIndex &index) const
{
    const QVariant length = index.data(ComparisonModel::kCertainLengthRole);
    if (!length.isValid()) {
        QStyledItemDelegate::paint(painter, option, index);
        return;
    }
    QStyleOptionViewItem item = option;
    initStyleOption(&item, index);
    const QString text = item.text;
    item.text.clear();
    const QStyle *style = item.widget ? item.widget->style() : QApplication::style();
    style->drawControl(QStyle::CE_ItemViewItem, &item, painter, item.widget);

    const QString certain = text.left(length.toInt());
    const QString rest = text.mid(length.toInt());
    const bool isSelected = item.state.testFlag(QStyle::State_Selected);
    const QColor ink = item.palette.color(isSelected ? QPalette::HighlightedText : QPalette::Text);
    QColor grey = ink;
    grey.setAlphaF(0.45f);
    const int margin = style->pixelMetric(QStyle::PM_FocusFrameHMargin, &item, item.widget) + 1;
    QRect area = item.rect.adjusted(margin, 0, -margin, 0);
    painter->save();
    painter->setFont(item.font);
    painter->setPen(grey);
    painter->drawText(area, Qt::AlignRight | Qt::AlignVCenter, rest);
    area.setRight(area.right() - item.fontMetrics.horizontalAdvance(rest));
    painter->setPen(ink);
    painter->drawText(area, Qt::AlignRight | Qt::AlignVCenter, certain);
    painter->restore();
}

} // namespace unprojector::gui
