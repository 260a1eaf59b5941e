#pragma once

class QWidget;

namespace unprojector::gui {

/// The wheel scrolls what a widget lies in, unless the widget has the focus: nothing is changed in passing.
void ignoreWheelWithoutFocus(QWidget *widget);

} // namespace unprojector::gui
