#pragma once

namespace unprojector::gui {

/// The largest side of a view, device pixels: every graphics driver supports it.
inline constexpr int kMostViewPixels = 8192;

} // namespace unprojector::gui
