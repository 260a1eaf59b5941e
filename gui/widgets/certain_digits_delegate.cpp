#include "gui/widgets/certain_digits_delegate.h"

#include "gui/text/fitted_text.h"
#include "gui/widgets/contrast.h"
#include "gui/widgets/coordinates_model.h"

#include <QApplication>
#include <QPainter>
#include <QtMath>

#include <utility>

namespace unprojector::gui {

void CertainDigitsDelegate::paint(QPainter *painter, const QStyleOptionViewItem &option, const QModelIndex &index) const
{
    const QVariant length = index.data(CoordinatesModel::kCertainLengthRole);
    if (!length.isValid()) {
        QStyledItemDelegate::paint(painter, option, index);
        return;
    }
    QStyleOptionViewItem item = option;
    initStyleOption(&item, index);
    const QStyle *style = item.widget ? item.widget->style() : QApplication::style();
    const int margin = style->pixelMetric(QStyle::PM_FocusFrameHMargin, &item, item.widget) + 1;
    const QFontMetricsF metrics(item.font);
    const QString whole = std::exchange(item.text, QString());
    const QString text = fittedText(QStringList{whole} + shorterTexts(whole.toDouble()), item.rect.width() - 2 * margin,
                                    [&metrics](const QString &each) { return qCeil(metrics.horizontalAdvance(each)); });
    style->drawControl(QStyle::CE_ItemViewItem, &item, painter, item.widget);

    const bool isSelected = item.state.testFlag(QStyle::State_Selected);
    const QColor ink = item.palette.color(isSelected ? QPalette::HighlightedText : QPalette::Text);
    const QColor grey = quietInk(ink, item.palette.color(isSelected ? QPalette::Highlight : QPalette::Base));
    // A power of ten belongs to the certain digits before it.
    // The certain length counts in the notation of the whole text; a text in another one has no certain digits.
    const int certain = text.contains(u'e') == whole.contains(u'e') ? length.toInt() : 0;
    const qsizetype power = certain > 0 && text.contains(u'e') ? text.indexOf(u'e') : text.size();
    const qsizetype end = std::min<qsizetype>(certain, power);
    QRectF area = item.rect.adjusted(margin, 0, -margin, 0);
    painter->save();
    painter->setFont(item.font);
    for (const auto &[part, color] : {std::pair(text.mid(power), ink), std::pair(text.mid(end, power - end), grey),
                                      std::pair(text.left(end), ink)}) {
        painter->setPen(color);
        painter->drawText(area, Qt::AlignRight | Qt::AlignVCenter | Qt::TextDontClip, part);
        area.setRight(area.right() - metrics.horizontalAdvance(part));
    }
    painter->restore();
}

} // namespace unprojector::gui
