#pragma once

#include <chrono>

namespace unprojector::gui {

/// The pause after the last key that ends typing: before it, the text may be half a number.
constexpr std::chrono::milliseconds kTypingPause(900);

} // namespace unprojector::gui
