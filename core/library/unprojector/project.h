#pragma once

#include "unprojector/setup.h"
#include "unprojector/unproject.h"

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <cstddef>
#include <memory>

namespace unprojector {

/// A point in each space on its way to a pixel.
struct Stages {
    glm::dvec3 eye{0.0};
    glm::dvec4 clip{0.0};
    glm::dvec3 ndc{0.0};
    glm::dvec3 window{0.0}; ///< device pixels, origin bottom-left; and the window depth
    /// px, py, depth as Unprojection takes them: device pixels, origin top-left. A depth that lies
    /// outside the depth range by a rounding is the nearer end of the range.
    glm::dvec3 pixel{0.0};
};

/// Projects points to the window, prepared once for a setup. It computes with about 30 digits and
/// rounds each stage once. Any thread may call it.
class UNPROJECTOR_PUBLIC ForwardProjection {
public:
    /// @param space  of the points
    /// @return Value: see Setup::of
    static Result<ForwardProjection> of(const Setup &setup, Space space = Space::World);

    /// @return Value: the point has no window position, in the plane of the eye, or beyond the
    ///         range of doubles
    Result<Stages> at(const glm::dvec3 &point) const;

    /// Projects `count` points. From the first stage on that a point does not have, its numbers are
    /// NaN.
    /// @param points   x, y, z of each point, one point after the other
    /// @param threads  the maximum number of threads; 0: all cores
    void operator()(const double *points, Stages *stages, std::size_t count, unsigned threads = 1) const;

private:
    struct Data;
    explicit ForwardProjection(std::shared_ptr<const Data> data) : m_data(std::move(data)) {}

    std::shared_ptr<const Data> m_data;
};

} // namespace unprojector
