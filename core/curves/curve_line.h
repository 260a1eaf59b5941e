#pragma once

#include "core/curves/surface_path.h"
#include "core/geometry/result.h"
#include "core/landmarks/measure.h"

#include <cstddef>
#include <span>
#include <vector>

namespace unprojector::curves {

/// A computed curve.
struct CurveLine {
    std::vector<geometry::WorldPoint> path;
    /// The length along the surface. Its uncertainty follows from each point's, to first order. A
    /// shortest path grows by the component of its end's motion along it. At a point between two
    /// pieces, the sum of both changes counts.
    landmarks::Measure length;
};

/// The reason why a curve cannot be computed.
struct CurveError {
    enum class Code {
        TooFew,       ///< fewer than two points
        Missing,      ///< point: is not placed
        NotOnSurface, ///< point: has no anchor, or one that the surface lacks
        NotConnected, ///< point: the end of the piece for which the surface has no path
        NoSection,    ///< point: the end of the piece for which there is no plane section
    };
    Code code = Code::TooFew;
    std::size_t point = 0; ///< index among the given points
};

/// The line through landmarks on one object, in their order.
/// @param progress  may be empty
/// Throws base::Stopped.
geometry::Result<CurveLine, CurveError> lineThrough(const SurfaceMesh &mesh,
                                                    std::span<const landmarks::Landmark *const> points,
                                                    landmarks::CurveKind kind, const glm::dmat4 &worldFromObject,
                                                    const base::Progress &progress);

/// Points in equal steps along a path, including both its ends.
/// @param count  at least 2
/// @pre the path has at least one point
std::vector<geometry::WorldPoint> resampled(std::span<const geometry::WorldPoint> path, std::size_t count);

} // namespace unprojector::curves
