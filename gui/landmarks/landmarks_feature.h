#pragma once

namespace unprojector::gui {

class Feature;
class Window;

/// Landmarks: placed, named, moved, measured, in files and over a series of scans.
/// @return owned by the window
Feature *makeLandmarksFeature(Window &window);

} // namespace unprojector::gui
