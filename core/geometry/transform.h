#pragma once

#include "core/geometry/precise_matrix.h"
#include "core/geometry/result.h"

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include <variant>
#include <vector>

namespace unprojector::geometry {

/// The step glTranslated(x, y, z).
struct Translate {
    glm::dvec3 offset{0.0};
    friend bool operator==(const Translate &, const Translate &) = default;
};

/// The step glRotated(angle, x, y, z): degrees, counter-clockwise when the axis points to the
/// viewer. The axis may have any length but 0.
struct Rotate {
    double degrees = 0.0;
    glm::dvec3 axis{0.0, 0.0, 1.0};
    friend bool operator==(const Rotate &, const Rotate &) = default;
};

/// The step glScaled(x, y, z). A factor of 0 is an error because it has no inverse.
struct Scale {
    glm::dvec3 factors{1.0};
    friend bool operator==(const Scale &, const Scale &) = default;
};

using TransformStep = std::variant<Translate, Rotate, Scale>;

/// @return NotFinite; RotationAxisIsZero; ScaleIsZero
Check check(const TransformStep &step);

/// The matrix that the OpenGL call of this step multiplies onto the current one. Quarter turns are
/// exact.
/// @pre the step is valid
glm::dmat4 matrixOf(const TransformStep &step);

/// The product of the steps in the order of the calls: the last one is applied to the object first,
/// as in OpenGL. It is computed with 32 digits: large translations that cancel leave no wrong
/// digits.
/// @pre every step is valid
PreciseMatrix preciseWorldFromObject(const std::vector<TransformStep> &steps);
glm::dmat4 worldFromObject(const std::vector<TransformStep> &steps);

} // namespace unprojector::geometry
