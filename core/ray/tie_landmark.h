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

/// How far a landmark of another program may lie from a mesh of that size before somebody is asked whether it is that mesh's:
/// a share of the diagonal of the bounds.
inline constexpr double kFarFromMesh = 0.01;

struct Tied {
    double distance = 0.0;  ///< that the landmark was moved by, world units
    std::size_t target = 0; ///< that it lies on now
};

/// Moves a landmark to the place of these objects that is closest to it, and holds it there: to the object that it names, if
/// that is among them, else to the closest of all. A hold that it has there already, and that is where it is, stays.
/// Closest is meant in the object's own space: only a placement that stretches it unevenly makes a difference.
/// @return nothing where it is missing or there is no object; then it is as it was
std::optional<Tied> tieToMesh(landmarks::Landmark &landmark, std::span<const TyingTarget> targets);

} // namespace unprojector::ray
