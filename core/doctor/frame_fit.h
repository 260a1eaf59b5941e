#pragma once

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

#include <optional>
#include <span>
#include <string>

namespace unprojector::doctor {

/// The map y = scale * rotation * x + translation from the right points to a program's.
struct FrameFit {
    glm::dmat3 rotation{1.0}; ///< orthogonal; a reflection too: det(rotation) = -1
    glm::dvec3 translation{0.0};
    double scale = 1.0;    ///< > 0
    double residual = 0.0; ///< greatest distance of a mapped point from its target
    /// False for points in one plane: the rotation and the reflection that differ by the mirror in
    /// this plane fit alike. Then the result is the rotation.
    bool isHandednessKnown = false;

    glm::dvec3 mapped(const glm::dvec3 &point) const { return scale * (rotation * point) + translation; }
    bool isMirrored() const;
};

/// The arrangement of points that a fit depends on.
enum class Extent { Point, Line, Plane, Space };

/// Tells whether points lie on a line or in a plane, within 1 % of their length.
Extent extentOf(std::span<const glm::dvec3> points);

/// The least-squares frame, with the better handedness.
/// @param hasScale  false: the scale stays 1
/// @return empty for fewer than three points, and if those of either side are on a line
/// Source: Horn 1987; Umeyama 1991, "Least-squares estimation of transformation parameters between
/// two point patterns" (the scale).
std::optional<FrameFit> fittedFrame(std::span<const glm::dvec3> from, std::span<const glm::dvec3> to, bool hasScale);

/// An axis permutation with signs: its rows are unit vectors along axes.
struct AxisPermutation {
    glm::dmat3 matrix{1.0};
    std::string axes; ///< "x,-z,y": the result's x is the point's x, its y is -z, its z is y
};

/// All 48, the identity first.
std::span<const AxisPermutation> axisPermutations();

} // namespace unprojector::doctor
