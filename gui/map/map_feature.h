#pragma once

namespace unprojector::gui {

class Feature;
class Window;

/// The map of differences over the view.
/// @return owned by the window
Feature *makeMapFeature(Window &window);

} // namespace unprojector::gui
