#pragma once

namespace unprojector::gui {

class Feature;
class Window;

/// The feature for clicks: the comparison of both methods, and the snap mode on meshes.
/// @return owned by the window
Feature *makeClickFeature(Window &window);

} // namespace unprojector::gui
