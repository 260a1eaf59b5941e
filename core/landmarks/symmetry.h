#pragma once

#include "core/geometry/result.h"
#include "core/landmarks/landmark.h"
#include "core/landmarks/measure.h"

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace unprojector::landmarks {

/// Two landmarks, one on each side, by their places in the list.
struct Pair {
    std::size_t left = 0, right = 0;
    friend bool operator==(const Pair &, const Pair &) = default;
};

/// Pairs by name: two names that are the same but for "left" and "right", or "L" and "R", as a word of their own at the
/// beginning or the end, in whatever case ("L_eye", "eye right", "Orbitale-l"), or 左 and 右 there without a blank. A name that is there
/// twice pairs with none.
std::vector<Pair> pairsByName(std::span<const Landmark> landmarks);

/// Whether a name is of a left or a right landmark, as pairsByName has it: without a partner it says nothing of the middle.
bool isSided(const std::string &name);

/// The plane n . p = d that mirrors landmarks best into their partners: least in the sum of the squares of the distances from
/// each landmark's mirror image to its partner, or to itself where it has none and is not sided (Mardia, Bookstein, Moreton 2000: object
/// symmetry).
struct MirrorPlane {
    geometry::WorldVector normal; ///< length 1, to the right side
    double offset = 0.0;

    geometry::WorldPoint mirrored(const geometry::WorldPoint &point) const;
};

/// @return nothing without a pair of which both are there, or where no plane is better than another
std::optional<MirrorPlane> mirrorPlaneOf(std::span<const Landmark> landmarks, std::span<const Pair> pairs);

/// How far a landmark's mirror image lies from its partner, or from itself where it has none; nothing where either is missing, and of
/// a sided one without a partner.
/// One a landmark.
std::vector<std::optional<double>> asymmetriesOf(std::span<const Landmark> landmarks, std::span<const Pair> pairs,
                                                 const MirrorPlane &plane);

/// The plane that mirrors landmarks best and what follows from it, each with how far it can be off at most, to first order: the plane
/// moves with every landmark that it is made from, so every error has a share of each of them. Nothing where one of them is not known.
///
///   dn = sum over the other axes e of e (e . dM n) / (least eigenvalue - that of e)
struct Symmetry {
    MirrorPlane plane;
    std::vector<std::size_t> counted;                ///< the landmarks that the plane is made from, rising
    std::optional<double> offsetError;               ///< of the plane's offset
    std::vector<std::optional<Measure>> asymmetries; ///< as asymmetriesOf has them; one a landmark
};

/// @return nothing where mirrorPlaneOf has none
std::optional<Symmetry> symmetryOf(std::span<const Landmark> landmarks, std::span<const Pair> pairs);

} // namespace unprojector::landmarks
