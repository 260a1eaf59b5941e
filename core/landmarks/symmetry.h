#pragma once

#include "core/geometry/result.h"
#include "core/landmarks/landmark.h"
#include "core/landmarks/measure.h"

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace unprojector::landmarks {

/// Two landmarks, one on each side, by their indices in the list.
struct Pair {
    std::size_t left = 0, right = 0;
    friend bool operator==(const Pair &, const Pair &) = default;
};

/// Pairs by name: two names that differ only in "left" and "right", or "L" and "R", as a separate
/// word at the beginning or the end. They may be in any case ("L_eye", "eye right", "Orbitale-l").
/// 左 and 右 need no blank. A name that occurs twice has no pair.
std::vector<Pair> pairsByName(std::span<const Landmark> landmarks);

/// True if a name marks a left or a right landmark, as in pairsByName. Such a landmark without a
/// partner does not define the middle.
bool isSided(const std::string &name);

/// The plane n . p = d that mirrors landmarks best into their partners. It minimises the sum of the
/// squared distances from each landmark's mirror image to its partner. A landmark without a partner
/// that is not sided counts as its own partner (Mardia, Bookstein, Moreton 2000: object symmetry).
struct MirrorPlane {
    geometry::WorldVector normal; ///< length 1, to the right side
    double offset = 0.0;
    friend bool operator==(const MirrorPlane &, const MirrorPlane &) = default;

    geometry::WorldPoint mirrored(const geometry::WorldPoint &point) const;
    /// The distance of a point from the plane: half its distance from its own mirror image.
    double distanceTo(const geometry::WorldPoint &point) const;
};

/// The asymmetry of each landmark: the distance of its mirror image from its partner, or from itself
/// if it has none. That of a landmark of the middle is twice its distance from the plane. Empty if
/// either has no position, and for a sided landmark without a partner. One per landmark.
std::vector<std::optional<double>> asymmetriesOf(std::span<const Landmark> landmarks, std::span<const Pair> pairs,
                                                 const MirrorPlane &plane);

/// A rectangle of the plane around the feet of its landmarks, to be drawn. Its sides follow the
/// world's axes as closely as the plane allows.
/// @param counted  indices of the landmarks, not empty; each has a position
std::array<geometry::WorldPoint, 4> rectangleOf(const MirrorPlane &plane, std::span<const Landmark> landmarks,
                                                std::span<const std::size_t> counted);

/// The best mirror plane and its results, each with its largest error to first order. The plane
/// moves with every landmark that defines it, so every error has a share of each of them. Errors
/// are empty if one of them is unknown.
///
///   dn = sum over the other axes e of e (e . dM n) / (least eigenvalue - eigenvalue of e)
struct Symmetry {
    MirrorPlane plane;
    std::vector<std::size_t> counted;                ///< indices of the landmarks that define the plane, ascending
    std::optional<double> offsetError;               ///< error of the plane's offset
    std::vector<std::optional<Measure>> asymmetries; ///< see asymmetriesOf; one per landmark
    /// The distance from the plane of each landmark that defines it; one per landmark.
    std::vector<std::optional<Measure>> distances;
};

/// @return empty if no pair has both landmarks, or if no plane is better than another
std::optional<Symmetry> symmetryOf(std::span<const Landmark> landmarks, std::span<const Pair> pairs);

} // namespace unprojector::landmarks
