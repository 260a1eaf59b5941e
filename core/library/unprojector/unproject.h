#pragma once

#include "unprojector/setup.h"

#include <glm/vec3.hpp>

#include <cstddef>
#include <memory>

namespace unprojector {

enum class Method {
    Formula, ///< the inverse formulas (9) to (12) of Weng et al. 2008, rounded once
    Matrix   ///< the inverted matrix, as in gluUnProject
};

enum class Space { World, Eye };

/// Unprojects arrays of pixels, prepared once for a setup. Any thread may call it.
class UNPROJECTOR_PUBLIC Unprojection {
public:
    /// @return Value: the matrix has no inverse; for the formulas, it is no known projection
    static Result<Unprojection> of(const Setup &setup, Method method = Method::Formula, Space space = Space::World);

    /// Unprojects `count` pixels on the calling thread.
    ///
    /// px, py are device pixels, origin top-left; the centre of pixel (i, j) is (i + 1/2, j + 1/2).
    /// depth is in the setup's depth range. A point without an answer is NaN: a depth outside the
    /// range, a number that is not finite.
    /// @param points  x, y, z of each point, one point after the other
    void operator()(const double *px, const double *py, const double *depth, double *points, std::size_t count) const;

private:
    struct Data;
    explicit Unprojection(std::shared_ptr<const Data> data) : m_data(std::move(data)) {}

    std::shared_ptr<const Data> m_data;
};

} // namespace unprojector
