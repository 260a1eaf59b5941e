#pragma once

class QTreeWidget;
class QTreeWidgetItem;

namespace unprojector::gui {

class SceneCurves;

/// Shows a button in a cell while its line is computed, with the progress: it cancels. Removes the
/// button when the line is done.
void showComputing(QTreeWidget &rows, QTreeWidgetItem &row, int column, SceneCurves &curves, bool isComputing);

} // namespace unprojector::gui
