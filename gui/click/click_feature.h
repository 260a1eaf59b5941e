#pragma once

namespace unprojector::gui {

class Feature;
class Window;

/// Clicks: the comparison of both methods, and what a click takes of the meshes.
/// @return owned by the window
Feature *makeClickFeature(Window &window);

} // namespace unprojector::gui
