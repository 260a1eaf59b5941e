#pragma once

class QWidget;

namespace unprojector::gui {

/// Puts a panel as another of its kind stands: what was chosen in switches and boxes, typed into fields, folded open,
/// drawn to a size. What a document says stands in both already. Parts are the same that have the same name, or none
/// and the same place among those of their class. A part that only one of them has is left as it is, and named in a
/// warning where it could be set.
void takeOverState(QWidget &now, const QWidget &former);

} // namespace unprojector::gui
