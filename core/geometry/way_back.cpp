#include "core/geometry/way_back.h"

#include "core/geometry/finite.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

namespace unprojector::geometry {
namespace {

/// The error of two sums of four products, each relative to the sum of its terms' magnitudes.
constexpr double kRounding = 0x1p-95;

glm::dvec4 magnitudes(const DoubleDouble4 &v)
{
    return {std::abs(v[0].value), std::abs(v[1].value), std::abs(v[2].value), std::abs(v[3].value)};
}

glm::dmat4 magnitudes(const MatrixRows<DoubleDouble> &rows)
{
    glm::dmat4 m;
    for (std::size_t row = 0; row < 4; ++row) {
        for (std::size_t column = 0; column < 4; ++column)
            m[static_cast<int>(column)][static_cast<int>(row)] = std::abs(rows[row][column].value);
    }
    return m;
}

} // namespace

Result<WayBack> WayBack::of(const Setup &setup)
{
    if (const Check valid = check(setup.depthRange); !valid)
        return valid.error();
    const Result<WayForward> forward = WayForward::of(setup);
    if (!forward)
        return forward.error();
    WayBack way(*forward);
    way.m_depthRange = setup.depthRange;
    const MatrixRows<DoubleDouble> clipFromWorld = product(way.m_way.m_clipFromEye, way.m_way.m_eyeFromWorld);
    way.m_worldFromClip = inverse(clipFromWorld, [](const DoubleDouble &number) { return std::abs(number.value); });
    way.m_magnitudes = magnitudes(way.m_worldFromClip);
    way.m_roundings = kRounding * (magnitudes(way.m_way.m_clipFromEye) * magnitudes(way.m_way.m_eyeFromWorld));
    MatrixRows<DoubleDouble> remainder = product(way.m_worldFromClip, clipFromWorld);
    for (std::size_t k = 0; k < 4; ++k)
        remainder[k][k] = remainder[k][k] - 1.0;
    way.m_remainder = magnitudes(remainder) + 2.0 * (way.m_magnitudes * way.m_roundings);
    if (!isFinite(way.m_remainder) || !isFinite(way.m_magnitudes))
        return Error{ErrorCode::SingularMatrix};
    return way;
}

/// With X the approximate inverse, r the residual and G = |1 - X M|, the error e of the solution
/// satisfies e <= |X| r + G e. If G d <= a d for d = |X| r, then e <= d / (1 - a).
WayBack::Solution WayBack::solved(const DoubleDouble4 &clip) const
{
    const auto residual = [&](const DoubleDouble4 &point) {
        DoubleDouble4 rest = applied(m_way.m_clipFromEye, applied(m_way.m_eyeFromWorld, point));
        for (std::size_t k = 0; k < 4; ++k)
            rest[k] = clip[k] - rest[k];
        return rest;
    };
    Solution solution{applied(m_worldFromClip, clip)};
    const DoubleDouble4 correction = applied(m_worldFromClip, residual(solution.point));
    for (std::size_t k = 0; k < 4; ++k)
        solution.point[k] = solution.point[k] + correction[k];
    const glm::dvec4 own = magnitudes(solution.point);
    const glm::dvec4 bound =
        m_magnitudes * (magnitudes(residual(solution.point)) + m_roundings * own + kRounding * magnitudes(clip));
    const glm::dvec4 carried = m_remainder * bound;
    double share = 0.0;
    for (int k = 0; k < 4; ++k) {
        if (carried[k] > 0.0)
            share = std::max(share, carried[k] / bound[k]);
    }
    solution.error = share < 0.5 ? bound / (1.0 - share) : glm::dvec4(std::numeric_limits<double>::infinity());
    return solution;
}

Result<WayBack::Solution> WayBack::solution(const WindowPoint &window) const
{
    if (const auto value = firstNotFinite(window))
        return Error{ErrorCode::NotFinite, *value};
    const auto &[vx, vy, width, height] = m_way.m_viewport;
    const DoubleDouble share =
        (DoubleDouble(window.z) - m_depthRange.atNear) / (DoubleDouble(m_depthRange.atFar) - m_depthRange.atNear);
    return solved({2.0 * (DoubleDouble(window.x) - vx) / width - 1.0,
                   2.0 * (DoubleDouble(window.y) - vy) / height - 1.0,
                   m_way.m_ndcDepth == NdcDepth::ZeroToOne ? share : 2.0 * share - 1.0, 1.0});
}

Result<WayBack::Bounded> WayBack::world(const Solution &solution) const
{
    if (solution.isAtInfinity())
        return Error{ErrorCode::PointAtInfinity};
    const DoubleDouble w = solution.point[3];
    const DoubleDouble3 point{solution.point[0] / w, solution.point[1] / w, solution.point[2] / w};
    const glm::dvec3 rounded(point[0].value, point[1].value, point[2].value);
    const DoubleDouble3 world{point[0] + m_way.m_origin.x, point[1] + m_way.m_origin.y, point[2] + m_way.m_origin.z};
    const Bounded result{{world[0].value, world[1].value, world[2].value},
                         WorldVector((glm::dvec3(solution.error) + glm::abs(rounded) * solution.error.w)
                                     / (std::abs(w.value) - solution.error.w))};
    if (!isFinite(result.point) || !isFinite(result.error))
        return Error{ErrorCode::PointAtInfinity};
    return result;
}

std::optional<WorldPoint> WayBack::eye() const
{
    // All lines of sight have the same direction in clip space, and this is the end that they share.
    const Result<Bounded> eye = world(solved({0.0, 0.0, 1.0, 0.0}));
    return eye ? std::optional(eye->point) : std::nullopt;
}

} // namespace unprojector::geometry
