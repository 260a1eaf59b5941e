#pragma once

namespace unprojector::gui {

class Feature;
class Window;

/// The view from outside, in a corner of the view or in a panel.
/// @return owned by the window
Feature *makeOutsideFeature(Window &window);

} // namespace unprojector::gui
