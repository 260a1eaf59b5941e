#pragma once

#include <QStyledItemDelegate>

namespace unprojector::gui {

/// Draws a coordinate with its certain digits in the text's colour and the digits after them in
/// grey (CoordinatesModel::kCertainLengthRole). All digits stay there to compare the two methods
/// by.
class CertainDigitsDelegate : public QStyledItemDelegate {
public:
    using QStyledItemDelegate::QStyledItemDelegate;

    void paint(QPainter *painter, const QStyleOptionViewItem &option, const QModelIndex &index) const override;
};

} // namespace unprojector::gui
