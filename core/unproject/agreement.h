#pragma once

#include "core/unproject/pick.h"

#include <optional>
#include <string>

namespace unprojector::unproject {

/// How far the two methods in double are apart at a pick, in world space: at the surface, on the background at the far end of the
/// ray.
struct Agreement {
    double difference = 0.0; ///< the largest of a coordinate, world units
    double ulps = 0.0;       ///< the same in units in the last place of the point's largest coordinate
    /// By what factors rounding of the inverted matrix is magnified: by the perspective, z (f − n) / (f n), and where the
    /// eye's coordinates and the way from it cancel. At least 1; 1 by the perspective of a box.
    double byPerspective = 1.0;
    double byCancelling = 1.0;
    /// Whether the methods differ by no more than the pick's uncertainty in each coordinate. Nothing on the background.
    std::optional<bool> isWithinUncertainty;

    /// A few ulps: the matrix rounds at every step, the formula once.
    bool isToTheLastPlaces() const { return ulps <= 4.0; }
};

/// @pre the pick's setup is by parameters
/// @return nothing where a method has no answer
std::optional<Agreement> agreementOf(const Pick &pick);

/// Says in one line whether the methods agree, by how much they differ and what magnifies the difference; where a method has no
/// answer, which one, and its error.
std::string verdictText(const Pick &pick);
/// Explains the difference with the numbers that decide it; empty where a method has no answer.
std::string differenceCauseText(const Pick &pick);

} // namespace unprojector::unproject
