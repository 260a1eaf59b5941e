#pragma once

#include <vector>

namespace unprojector::gui {

class Feature;
class Window;

/// All features of the window, in the order in which they add to menus and tool bar. A new one is
/// added here.
/// @return owned by the window
std::vector<Feature *> makeFeatures(Window &window);

} // namespace unprojector::gui
