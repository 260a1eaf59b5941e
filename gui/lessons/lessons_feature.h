#pragma once

namespace unprojector::gui {

class Feature;
class Window;

/// Lessons, the page of formulas and the first steps.
/// @return owned by the window
Feature *makeLessonsFeature(Window &window);

} // namespace unprojector::gui
