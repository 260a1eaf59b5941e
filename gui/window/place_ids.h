#pragma once

#include <array>

namespace unprojector::gui {

// The work places by the names that `--place` takes and layouts are kept by.
inline constexpr char kClickPlace[] = "click";
inline constexpr char kPipelinePlace[] = "pipeline";
/// In the order of the tool bar; the first is where one starts.
inline constexpr std::array<const char *, 2> kPlaceIds{kClickPlace, kPipelinePlace};

} // namespace unprojector::gui
