#pragma once

namespace unprojector::gui {

class Feature;
class Window;

/// The list of objects.
/// @return owned by the window
Feature *makeObjectsFeature(Window &window);

} // namespace unprojector::gui
