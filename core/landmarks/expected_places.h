#pragma once

#include "core/landmarks/procrustes.h"

#include <glm/vec3.hpp>

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace unprojector::landmarks {

/// The place of a landmark on this specimen, as the other specimens have it.
struct ExpectedPlace {
    glm::dvec3 place{0.0}; ///< in the space of this specimen
    /// The root of the mean square of the distances with which the same landmarks find it on the other
    /// specimens, in the units of this one; empty for a landmark of fewer than two others.
    std::optional<double> spread;
};

/// The reason why there are no expected places.
enum class NoExpectedPlaces {
    NoOthers, ///< no other specimen has landmarks that can be aligned
    TooFew,   ///< fewer than three placed landmarks that others have
    OnALine,  ///< those are on a line, within 1 % of its length
};

/// The expected place of each landmark; empty: it is placed already, or on no other specimen.
struct ExpectedPlaces {
    std::vector<std::optional<ExpectedPlace>> places;
    std::optional<NoExpectedPlaces> reason; ///< why there is none at all
};

inline constexpr std::size_t kFewestToExpect = 3; ///< placed landmarks that expected places need

/// Finds the expected places of the landmarks that a specimen lacks: the robust mean of the others,
/// mapped by the least-squares similarity from its landmarks to the placed ones.
///
/// The spread is found in the same way on each other specimen: the mean of the rest is mapped by the
/// same landmarks, and compared with the landmark there. So it also grows with the lever of few placed
/// landmarks. A specimen that lacks some of them uses those it has.
class PlaceExpectation {
public:
    PlaceExpectation() = default;
    /// Superimposes the other specimens: 100 of 30 landmarks take some hundredths of a second.
    explicit PlaceExpectation(std::span<const Configuration> others);

    /// @param placed  landmarks in the same order as on the others
    ExpectedPlaces placesFor(const Configuration &placed) const;

private:
    Superimposition m_others;
    std::vector<Configuration> m_rest; ///< for each other specimen: the mean of the rest
};

} // namespace unprojector::landmarks
