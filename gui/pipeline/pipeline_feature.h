#pragma once

namespace unprojector::gui {

class Feature;
class Window;

/// The pipeline: every number and every matrix between an object and its pixel.
/// @return owned by the window
Feature *makePipelineFeature(Window &window);

} // namespace unprojector::gui
