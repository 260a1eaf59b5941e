#pragma once

#include "core/geometry/matrix_rows.h"
#include "core/geometry/precise_matrix.h"
#include "core/geometry/setup.h"

#include <array>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <optional>

namespace unprojector::unproject {

/// A number of 50 digits, so its rounding error is negligible beside a double's.
using Extended = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<50>, boost::multiprecision::et_off>;

/// The point under a window position, as the reference for judging both methods. It builds the
/// forward matrices of gluLookAt, glFrustum, gluPerspective, glOrtho, glViewport and glDepthRange in
/// extended precision from the same double parameters. It inverts their product in extended
/// precision.
class ExactUnprojection {
public:
    // To world space, to an object's space and to eye space. Each returns empty where the product
    // has no inverse. @pre the setup's parts are valid
    static std::optional<ExactUnprojection> of(const geometry::Setup &setup);
    static std::optional<ExactUnprojection> toObject(const geometry::Setup &setup,
                                                     const geometry::PreciseMatrix &worldFromObject);
    static std::optional<ExactUnprojection> toEye(const geometry::Setup &setup);

    /// The point; empty for a point at infinity.
    std::optional<std::array<Extended, 3>> at(const geometry::WindowPoint &window) const;
    /// The same for device pixels; the flip of y rounds nothing.
    /// @param position  origin top-left
    /// @param depth     in the setup's depth range
    std::optional<std::array<Extended, 3>> at(const geometry::DevicePoint &position, double depth) const;

private:
    using Matrix = geometry::MatrixRows<Extended>;

    static std::optional<ExactUnprojection> inverted(const geometry::Setup &setup, const Matrix &windowFromSpace);

    ExactUnprojection(const Matrix &spaceFromWindow, const geometry::Surface &surface)
        : m_spaceFromWindow(spaceFromWindow), m_surface(surface)
    {
    }
    std::optional<std::array<Extended, 3>> at(const Extended &x, const Extended &y, const Extended &depth) const;

    Matrix m_spaceFromWindow;
    geometry::Surface m_surface;
};

} // namespace unprojector::unproject
