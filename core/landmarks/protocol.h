#pragma once

#include "core/geometry/result.h"
#include "core/landmarks/landmark.h"
#include "core/landmarks/measure.h"

#include <array>
#include <cstddef>
#include <functional>
#include <limits>
#include <optional>
#include <span>
#include <string>

namespace unprojector::landmarks {

/// The names of the kinds in files, in the order of MeasureKind.
inline constexpr std::array kMeasureKinds{"distance", "angle", "height", "length", "surface"};

/// The fewest and the most landmarks of a kind.
struct MeasureSize {
    std::size_t fewest = 2, most = std::numeric_limits<std::size_t>::max();
};
MeasureSize sizeOf(MeasureKind kind);

/// The length along the surface through these landmarks, or the reason why there is none: a clause.
/// It gets as many landmarks as sizeOf says, all of them placed.
using SurfaceLength = std::function<geometry::Result<Measure, std::string>(std::span<const Landmark *const>)>;

/// The value of a kept measure for one specimen.
struct ProtocolValue {
    std::optional<Measure> measure; ///< a length in the unit of the coordinates, or an angle in degrees
    std::string reason;             ///< why there is no value, a clause; empty if there is one
};

/// Measures the landmarks of a set with the names of the measure. A name counts in every spelling
/// of the same nameKey, if no landmark has it exactly. Hidden landmarks are measured too.
/// @param surface  for measures along the surface; empty: they have no value
ProtocolValue valueOf(const KeptMeasure &measure, const LandmarkSet &set, const SurfaceLength &surface);

} // namespace unprojector::landmarks
