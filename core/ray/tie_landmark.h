#pragma once

#include "core/landmarks/landmark.h"
#include "core/ray/closest_place.h"

#include <glm/mat4x4.hpp>

#include <memory>
#include <optional>
#include <span>
#include <string>

namespace unprojector::ray {

/// An object that landmarks can be tied to.
struct TyingTarget {
    std::string name; ///< UTF-8
    std::shared_ptr<const ClosestPlaces> places;
    glm::dmat4 worldFromObject{1.0};
};

/// The largest distance of an imported landmark from a mesh without asking the user whether it
/// belongs there: a share of the diagonal of the bounds.
inline constexpr double kFarFromMesh = 0.01;

struct Tied {
    double distance = 0.0;  ///< from the landmark's old position, world units
    std::size_t target = 0; ///< the target that it lies on now
};

/// Moves a landmark to the closest location on these objects, and anchors it there. It takes the
/// object that it names if that is among them, else the closest of all. An existing anchor at that
/// location stays. Distances are measured in the object's own space; this matters only if its
/// transform scales unevenly.
/// @return nothing if its position is missing or there is no object; then it stays unchanged
std::optional<Tied> tieToMesh(landmarks::Landmark &landmark, std::span<const TyingTarget> targets);

} // namespace unprojector::ray
