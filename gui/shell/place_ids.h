#pragma once

#include <array>

namespace unprojector::gui {

// The work places by the names that `--place` takes and layouts are kept by.
inline constexpr char kClickPlace[] = "click";
inline constexpr char kPipelinePlace[] = "pipeline";
inline constexpr char kPointsPlace[] = "points";
inline constexpr char kDoctorPlace[] = "doctor";
/// The panel of lessons, as layouts keep it.
inline constexpr char kLessonPanel[] = "lesson";
/// Every number between an object and its pixel.
inline constexpr char kPipelinePanel[] = "pipeline";
/// The view from outside, where it has a dock.
inline constexpr char kObserverPanel[] = "observer";
/// In the order of the tool bar; the first is where one starts.
inline constexpr std::array<const char *, 4> kPlaceIds{kClickPlace, kPipelinePlace, kPointsPlace, kDoctorPlace};

} // namespace unprojector::gui
