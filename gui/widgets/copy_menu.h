#pragma once

#include <QString>

#include <functional>
#include <vector>

class QItemSelectionModel;
class QMenu;
class QModelIndex;
class QPoint;
class QWidget;

namespace unprojector::gui {

/// A number or a point that a menu copies, with all its digits.
struct Copyable {
    QString name; ///< as a variable in code: "world"
    std::vector<double> numbers;
};

/// Fills a menu with one entry for the number, where there is one, and with the point as text, C, GLM, NumPy, LaTeX and CSV.
/// @param number  what lies under the pointer; empty: nothing there is a number
/// @param whole   the point that it belongs to; empty: none
void addCopyActions(QMenu &menu, const Copyable &number, const Copyable &whole);

/// Shows such a menu there. It is gone when it closes.
void showCopyMenu(QWidget &parent, const QPoint &globalPosition, const Copyable &number, const Copyable &whole);

/// The selected cells, a row a line, tab-separated; those without data are left out.
/// @param textOf  a cell with all its digits
QString selectedCells(const QItemSelectionModel &selection, const std::function<QString(const QModelIndex &)> &textOf);

/// Puts a text on the clipboard.
void copyToClipboard(const QString &text);

} // namespace unprojector::gui
