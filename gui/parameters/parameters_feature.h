#pragma once

namespace unprojector::gui {

class Feature;
class Window;

/// The parameters of camera, projection, viewport and objects, as fields.
/// @return owned by the window
Feature *makeParametersFeature(Window &window);

} // namespace unprojector::gui
