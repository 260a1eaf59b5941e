#pragma once

class QWidget;

namespace unprojector::gui {

/// Makes the wheel scroll the surrounding area unless the widget has the focus, so that scrolling
/// changes no values.
void ignoreWheelWithoutFocus(QWidget *widget);

} // namespace unprojector::gui
