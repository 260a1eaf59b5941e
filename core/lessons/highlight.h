#pragma once

namespace unprojector::lessons {

/// The parts of a step that are labelled in the view and in View from Outside; see highlights.h.
enum class Highlight {
    Axes,    ///< "axes": the model's, the world's and the eye's, in both views
    Volume,  ///< "volume": the sides of the view volume, in View from Outside
    Cube,    ///< "cube": −1 and 1 at the normalised cube that View from Outside morphs the volume into
    Viewport ///< "viewport": the viewport's position in the view
};

} // namespace unprojector::lessons
