#include "core/doctor/frame_fit.h"

#include "core/geometry/rotation_fit.h"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace unprojector::doctor {
namespace {

glm::dvec3 centroidOf(std::span<const glm::dvec3> points)
{
    // Sums are relative to the first one, because far from the origin they would lose digits.
    glm::dvec3 sum(0.0);
    for (const glm::dvec3 &point : points)
        sum += point - points.front();
    return points.front() + sum / double(points.size());
}

double traceOf(const glm::dmat3 &m)
{
    return m[0][0] + m[1][1] + m[2][2];
}

/// The sum of x y^T about both centroids.
glm::dmat3 sumsOf(std::span<const glm::dvec3> from, std::span<const glm::dvec3> to)
{
    const glm::dvec3 fromCentre = centroidOf(from), toCentre = centroidOf(to);
    glm::dmat3 sums(0.0);
    for (std::size_t i = 0; i < from.size(); ++i)
        sums += glm::outerProduct(from[i] - fromCentre, to[i] - toCentre);
    return sums;
}

FrameFit frameWith(const glm::dmat3 &rotation, std::span<const glm::dvec3> from, std::span<const glm::dvec3> to,
                   bool hasScale)
{
    FrameFit fit;
    fit.rotation = rotation;
    // The sum of y . R x is the trace of R times the sum of x y^T.
    if (hasScale)
        fit.scale = traceOf(rotation * sumsOf(from, to)) / traceOf(sumsOf(from, from));
    fit.translation = centroidOf(to) - fit.scale * (rotation * centroidOf(from));
    for (std::size_t i = 0; i < from.size(); ++i)
        fit.residual = std::max(fit.residual, glm::distance(fit.mapped(from[i]), to[i]));
    return fit;
}

std::vector<AxisPermutation> allPermutations()
{
    std::vector<AxisPermutation> all;
    std::array<int, 3> order{0, 1, 2};
    do {
        for (int signs = 0; signs < 8; ++signs) {
            AxisPermutation one{glm::dmat3(0.0), {}};
            for (int row = 0; row < 3; ++row) {
                const bool isNegative = (signs >> row) % 2 == 1;
                const int axis = order[std::size_t(row)];
                one.matrix[axis][row] = isNegative ? -1.0 : 1.0;
                one.axes += std::string(row > 0 ? "," : "") + (isNegative ? "-" : "") + "xyz"[axis];
            }
            all.push_back(one);
        }
    } while (std::next_permutation(order.begin(), order.end()));
    return all;
}

} // namespace

bool FrameFit::isMirrored() const
{
    return glm::determinant(rotation) < 0.0;
}

Extent extentOf(std::span<const glm::dvec3> points)
{
    constexpr double kWidth = 0.01;
    if (points.empty())
        return Extent::Point;
    const glm::dmat3 m = sumsOf(points, points);
    const double length = traceOf(m); // the sum of the eigenvalues
    if (!(length > 0.0))
        return Extent::Point;
    // The sum of the products of two eigenvalues, and the product of all three.
    const double products = m[0][0] * m[1][1] - m[0][1] * m[1][0] + m[0][0] * m[2][2] - m[0][2] * m[2][0]
                            + m[1][1] * m[2][2] - m[1][2] * m[2][1];
    if (!(products > kWidth * kWidth * length * length))
        return Extent::Line;
    return glm::determinant(m) > kWidth * kWidth * length * products ? Extent::Space : Extent::Plane;
}

std::optional<FrameFit> fittedFrame(std::span<const glm::dvec3> from, std::span<const glm::dvec3> to, bool hasScale)
{
    if (from.size() < 3 || from.size() != to.size())
        return std::nullopt;
    const Extent extent = std::min(extentOf(from), extentOf(to));
    if (extent < Extent::Plane)
        return std::nullopt;
    const glm::dmat3 sums = sumsOf(from, to);
    // A reflection of x is a rotation of -x.
    const FrameFit turned = frameWith(geometry::rotationOfSums(sums), from, to, hasScale);
    const FrameFit mirrored = frameWith(-geometry::rotationOfSums(-sums), from, to, hasScale);
    FrameFit best = extent == Extent::Space && mirrored.residual < turned.residual ? mirrored : turned;
    best.isHandednessKnown = extent == Extent::Space;
    if (!(best.scale > 0.0) || !std::isfinite(best.residual))
        return std::nullopt;
    return best;
}

std::span<const AxisPermutation> axisPermutations()
{
    static const std::vector<AxisPermutation> all = allPermutations();
    return all;
}

} // namespace unprojector::doctor
