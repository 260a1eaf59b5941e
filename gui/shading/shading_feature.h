#pragma once

namespace unprojector::gui {

class Feature;
class Window;

/// The menu View > Shading: how the view shows the shape of surfaces, and cuts through them.
/// @return owned by the window
Feature *makeShadingFeature(Window &window);

} // namespace unprojector::gui
