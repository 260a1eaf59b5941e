#pragma once

#include "core/unproject/unprojector.h"

#include <boost/multiprecision/cpp_bin_float.hpp>

#include <array>
#include <optional>

namespace unprojector::cli {

/// A number of 50 digits, so its rounding error is negligible beside a double's.
using Extended = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<50>, boost::multiprecision::et_off>;

/// The world point under a window position, as the reference for judging both methods. It builds
/// the forward matrices of gluLookAt, glFrustum, gluPerspective, glOrtho, glViewport and
/// glDepthRange in extended precision from the same double parameters. It inverts their product in
/// extended precision.
class ExactUnprojection {
public:
    /// Returns empty where the product has no inverse.
    /// @pre the setup's parts are valid
    static std::optional<ExactUnprojection> of(const geometry::Setup &setup);

    /// The world point; empty for a point at infinity.
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
