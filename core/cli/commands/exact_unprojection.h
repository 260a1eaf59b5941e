#pragma once

#include "core/unproject/unprojector.h"

#include <boost/multiprecision/cpp_bin_float.hpp>

#include <array>
#include <optional>

namespace unprojector::cli {

/// 50 digits: beside its own rounding that of a double is enormous.
using Extended = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<50>, boost::multiprecision::et_off>;

/// The world point under a position of the window, for judging both methods: the forward matrices of gluLookAt, glFrustum,
/// gluPerspective, glOrtho, glViewport and glDepthRange in extended precision, from the same parameters in double, and their
/// product inverted in extended precision.
class ExactUnprojection {
public:
    /// Nothing where the product has no inverse.
    /// @pre the geometry's parts are valid
    static std::optional<ExactUnprojection> of(const geometry::Setup &setup);

    /// Nothing for a point at infinity.
    std::optional<std::array<Extended, 3>> world(const geometry::WindowPoint &window) const;

private:
    using Matrix = std::array<std::array<Extended, 4>, 4>; ///< m[row][column]

    static Matrix product(const Matrix &a, const Matrix &b);
    static Matrix extended(const glm::dmat4 &m);
    static Matrix eyeFromWorld(const geometry::LookAt &camera);
    static Matrix clipFromEye(const geometry::Projection &projection);
    static Matrix windowFromNdc(const geometry::Setup &setup);
    static std::optional<Matrix> inverse(Matrix m);

    explicit ExactUnprojection(const Matrix &worldFromWindow) : m_worldFromWindow(worldFromWindow) {}

    Matrix m_worldFromWindow;
};

} // namespace unprojector::cli
