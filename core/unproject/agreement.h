#pragma once

#include "core/unproject/pick.h"

#include <optional>
#include <string>

namespace unprojector::unproject {

/// The difference between the two methods in double at a pick, in world space: at the surface, or
/// on the background at the far end of the ray.
struct Agreement {
    double difference = 0.0; ///< the largest of any coordinate, world units
    double ulps = 0.0;       ///< the same in units in the last place of the point's largest coordinate
    /// The factors that magnify the rounding of the inverted matrix. byPerspective: z (f − n) / (f
    /// n). byCancelling: cancellation between the eye's coordinates and the vector from it. At
    /// least 1; byPerspective is 1 for a box.
    double byPerspective = 1.0;
    double byCancelling = 1.0;
    /// True if the methods differ by at most the pick's uncertainty in each coordinate. Nothing on
    /// the background.
    std::optional<bool> isWithinUncertainty;

    /// True if they differ by a few ulps: the matrix rounds at every step, the formula once.
    bool isToTheLastPlaces() const { return ulps <= 4.0; }
};

/// @pre the pick's setup is by parameters
/// @return nothing if a method has no answer
std::optional<Agreement> agreementOf(const Pick &pick);

/// Describes in one line whether the methods agree, their difference and what magnifies it. If a
/// method has no answer, names the method and its error.
std::string verdictText(const Pick &pick);
/// Explains the difference with the numbers that decide it; empty if a method has no answer.
std::string differenceCauseText(const Pick &pick);

} // namespace unprojector::unproject
