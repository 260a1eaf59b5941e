#pragma once

#include <QStyledItemDelegate>

namespace unprojector::gui {

/// Draws numbers with as many digits as the cell has room for, and never a cut number: see
/// fittedText. Other texts are elided as usual.
class NumberDelegate : public QStyledItemDelegate {
public:
    /// QStringList: ever shorter texts of a cell with a number.
    static constexpr int kTextsRole = Qt::UserRole + 16;

    using QStyledItemDelegate::QStyledItemDelegate;

    void paint(QPainter *painter, const QStyleOptionViewItem &option, const QModelIndex &index) const override;
};

} // namespace unprojector::gui
