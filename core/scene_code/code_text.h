#pragma once

#include "core/scene_code/code_scene.h"

#include <glm/mat4x4.hpp>

#include <initializer_list>
#include <span>
#include <string>

namespace unprojector::scene_code {

/// The number syntax of a language.
enum class NumberStyle {
    Double,    ///< C++: 1.0
    Float,     ///< C++: 1.0f
    JavaScript ///< 1
};

/// The fewest digits that read back to the same double.
std::string literal(double value, NumberStyle style);
/// A comment about the numbers in the code that are written as floats but exceed their range:
/// "4e+300", and what becomes of them.
/// @return a sentence of a comment; empty if there are none
std::string beyondFloat(const std::string &code);
/// "1.0, 2.0, 3.0"
std::string list(std::initializer_list<double> values, NumberStyle style);
std::string list(const glm::dvec3 &v, NumberStyle style);
/// left, right, bottom, top, near, far, as glFrustum and glOrtho take them
std::string list(const geometry::ProjectionWindow &window, NumberStyle style);
/// Sixteen numbers in four lines: columns as OpenGL stores them, or rows as they are read.
enum class MatrixOrder { ByColumns, ByRows };
std::string list(const glm::dmat4 &matrix, MatrixOrder order, NumberStyle style, const std::string &indent);

/// "800 x 600 device pixels"
std::string windowText(const geometry::Surface &surface);

/// The comments that every dialect has on top: the window, what is not in the code.
/// @param mark  begins a comment
std::string headerComment(const scene_file::SceneFile &scene, const std::string &what, const std::string &mark = "//");

} // namespace unprojector::scene_code
