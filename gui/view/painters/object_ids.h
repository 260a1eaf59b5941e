#pragma once

namespace unprojector::gui {

/// The encoding of a pixel's object: an integer, or the four bytes of a colour if a driver has no
/// integer framebuffers.
enum class ObjectIds { Integers, Colors };

} // namespace unprojector::gui
