#pragma once

#include "core/geometry/result.h"
#include "core/landmarks/landmark.h"
#include "core/landmarks/protocol.h"

#include <cstddef>
#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace unprojector::curves {

/// The values of a protocol for each set of landmarks. Reasons are in English: they are cells of
/// tables.
/// @param modelOf  the model file of a set, for measures along its surface; or why there is none, a
///                 clause. Sets in a row with one file share its surface
/// @param goesOn   is called with the index of the set during long computations; returns false to
///                 cancel. May be empty
/// @return nothing if it was cancelled
std::optional<std::vector<std::vector<landmarks::ProtocolValue>>>
measuredSets(std::span<const landmarks::LandmarkSet> sets, std::span<const landmarks::KeptMeasure> measures,
             const std::function<geometry::Result<std::filesystem::path, std::string>(std::size_t)> &modelOf,
             const std::function<bool(std::size_t)> &goesOn = {});

} // namespace unprojector::curves
