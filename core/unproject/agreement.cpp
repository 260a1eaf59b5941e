#include "core/unproject/agreement.h"

#include "core/base/number_text.h"
#include "core/base/translation.h"
#include "core/geometry/error_text.h"

#include <algorithm>
#include <cmath>

namespace unprojector::unproject {
using namespace geometry;
using base::significantText;
using base::tr;
namespace {

double largest(const Components<3> &v)
{
    return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
}

/// Two digits without a power of ten: "8900".
/// @param value  above 0
std::string twoDigits(double value)
{
    const double unit = std::pow(10.0, std::floor(std::log10(value)) - 1.0);
    return base::shortestText(std::round(value / unit) * unit, 0.5 * unit);
}

const Answers<WorldSpace> &worldOf(const Pick &pick)
{
    return pick.hit() ? pick.point.world : pick.rayFar.world;
}

} // namespace

std::optional<Agreement> agreementOf(const Pick &pick)
{
    const Answers<WorldSpace> &world = worldOf(pick);
    const Result<EyePoint> &eye = (pick.hit() ? pick.point.eye : pick.rayFar.eye)[Method::Formula];
    if (!world[Method::Formula] || !world[Method::Matrix] || !eye)
        return std::nullopt;
    const WorldPoint &point = *world[Method::Formula];
    const WorldVector difference = world.difference();
    Agreement result;
    result.difference = largest(difference);
    // Near the world's origin the eye and the vector from it cancel, which exposes the rounding of
    // both.
    const double before = std::max(largest(pick.setup.camera().eye), largest(*eye));
    const double unitBefore = ulpOfLargest(WorldPoint(before, 0.0, 0.0));
    result.ulps = result.difference / (largest(point) > 0.0 ? ulpOfLargest(point) : unitBefore);
    result.byCancelling = std::max(1.0, before / std::max(largest(point), unitBefore));
    if (isPerspective(pick.setup.projection())) {
        // z_ndc changes by n f / (f - n) / z^2 per unit of z, so a rounding of z_ndc is that much
        // larger in z.
        const ProjectionWindow window = projectionWindow(pick.setup.projection());
        const double n = window.nearDistance, f = window.farDistance;
        result.byPerspective = std::max(1.0, -eye->z * (f - n) / (f * n));
    }
    if (pick.hit()) {
        const WorldVector &uncertainty = pick.uncertainty.world;
        result.isWithinUncertainty = true;
        for (int axis = 0; axis < 3; ++axis)
            result.isWithinUncertainty = *result.isWithinUncertainty && std::abs(difference[axis]) <= uncertainty[axis];
    }
    return result;
}

std::string verdictText(const Pick &pick)
{
    const Answers<WorldSpace> &world = worldOf(pick);
    const std::optional<Agreement> agreement = agreementOf(pick);
    if (!agreement) {
        if (!world[Method::Matrix] && world[Method::Formula])
            return tr("Only the formula has an answer; the matrix: %1",
                      geometry::errorText(world[Method::Matrix].error()));
        const Result<EyePoint> &eye = (pick.hit() ? pick.point.eye : pick.rayFar.eye)[Method::Formula];
        return geometry::errorText(world[Method::Formula] ? eye.error() : world[Method::Formula].error());
    }
    if (agreement->ulps == 0.0)
        return tr("Formula and matrix agree to the last digit");
    if (agreement->isToTheLastPlaces())
        return tr("Formula and matrix agree to within %1 ulp", significantText(std::ceil(agreement->ulps), 1));
    constexpr double kMuch = 2.0; // a smaller factor is not worth mentioning
    const bool isByPerspective = agreement->byPerspective >= agreement->byCancelling;
    const std::string cause = std::max(agreement->byPerspective, agreement->byCancelling) < kMuch
                                  ? tr("rounding of the inverse")
                              : isByPerspective ? tr("rounding of the inverse, magnified by near : far")
                                                : tr("rounding of the inverse, magnified where coordinates cancel");
    const std::string ulps = twoDigits(agreement->ulps);
    if (!agreement->isWithinUncertainty)
        return tr("Formula and matrix differ by %1 ulp: %2", ulps, cause);
    return *agreement->isWithinUncertainty
               ? tr("Formula and matrix differ by %1 ulp: %2. The uncertainty is larger.", ulps, cause)
               : tr("Formula and matrix differ by %1 ulp: %2. The uncertainty is smaller.", ulps, cause);
}

std::string differenceCauseText(const Pick &pick)
{
    const std::optional<Agreement> agreement = agreementOf(pick);
    if (!agreement)
        return {};
    if (agreement->isToTheLastPlaces())
        return tr("The two agree to the last places: the matrix rounds at every step, the formula once at the end.");
    const std::string byCancelling = twoDigits(agreement->byCancelling);
    if (!isPerspective(pick.setup.projection()))
        return tr("Cause: rounding in the inverted matrix, magnified %1 times where the eye's coordinates cancel. The "
                  "formula inverts nothing.",
                  byCancelling);
    return tr(
        "Cause: rounding in the inverted matrix, magnified %1 times by the perspective (z (f − n) / (f n)) and %2 "
        "times where the eye's coordinates cancel. The formula inverts nothing.",
        twoDigits(agreement->byPerspective), byCancelling);
}

} // namespace unprojector::unproject
