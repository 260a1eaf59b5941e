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
    QString name; ///< its variable name in code: "world"
    std::vector<double> numbers;
};

/// Adds a menu entry for the number, if there is one, and entries for the point as text, C, GLM,
/// NumPy, LaTeX and CSV.
/// @param number  under the pointer; empty: none
/// @param whole   the point that it belongs to; empty: none
void addCopyActions(QMenu &menu, const Copyable &number, const Copyable &whole);

/// Shows such a menu at this position and deletes it when it closes.
void showCopyMenu(QWidget &parent, const QPoint &globalPosition, const Copyable &number, const Copyable &whole);

/// The text of the selected cells, a row a line, tab-separated, without empty cells.
/// @param textOf  a cell with all its digits
QString selectedCells(const QItemSelectionModel &selection, const std::function<QString(const QModelIndex &)> &textOf);

/// Puts a text on the clipboard.
void copyToClipboard(const QString &text);

} // namespace unprojector::gui
