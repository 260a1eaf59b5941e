#pragma once

namespace unprojector::gui {

class Feature;
class Window;

/// The feature for landmarks: placing, naming, moving and measuring them, files, and series of
/// scans.
/// @return owned by the window
Feature *makeLandmarksFeature(Window &window);

} // namespace unprojector::gui
