#pragma once

namespace unprojector::gui {

/// How the object of a pixel is written: as an integer, or, where a driver has no framebuffers of integers, as the four
/// bytes of a colour.
enum class ObjectIds { Integers, Colors };

} // namespace unprojector::gui
