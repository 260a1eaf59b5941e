#pragma once

class QWidget;

namespace unprojector::gui {

/// Puts a panel as another of its kind stands: what was chosen in switches and boxes, typed into fields, folded open, drawn to
/// a size. What a document says stands in both already. Where the panels have other parts, those are left as they are.
void takeOverState(QWidget &now, const QWidget &former);

} // namespace unprojector::gui
