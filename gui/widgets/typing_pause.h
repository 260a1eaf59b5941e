#pragma once

#include <chrono>

namespace unprojector::gui {

/// What is typed may be half a number; that long after the last key it is taken for all that is meant to be there.
constexpr std::chrono::milliseconds kTypingPause(900);

} // namespace unprojector::gui
