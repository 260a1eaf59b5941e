#pragma once

namespace unprojector::lessons {

/// What of a step is lettered in the view and in View from Outside; see highlights.h.
enum class Highlight {
    Axes,    ///< "axes": those of the model, the world and the eye, in both views
    Volume,  ///< "volume": the sides of the view volume, in View from Outside
    Cube,    ///< "cube": −1 and 1 at the normalised cube that View from Outside morphs the volume into
    Viewport ///< "viewport": where the viewport lies in the view
};

} // namespace unprojector::lessons
