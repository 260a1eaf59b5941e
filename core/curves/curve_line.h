#pragma once

#include "core/curves/surface_path.h"
#include "core/landmarks/measure.h"

#include <cstddef>
#include <span>
#include <vector>

namespace unprojector::curves {

/// How a curve goes.
struct CurveLine {
    std::vector<geometry::WorldPoint> path;
    /// Along the surface. Its error follows from how far each point can be off, to first order: a path as short as it can be grows by
    /// the way that its end moves along it; at a point between, by what both pieces grow together.
    landmarks::Measure length;
};

/// Why a curve does not go.
struct CurveError {
    enum class Code {
        TooFew,       ///< of two points
        Missing,      ///< point: has no place
        NotOnSurface, ///< point: is held by nothing, or by what the surface does not have
        NotConnected, ///< point: where the piece ends that the surface has no way for
        NoSection,    ///< point: the same of a plane
        Stopped,
    };
    Code code = Code::TooFew;
    std::size_t point = 0; ///< place among those given
};

/// The line through landmarks that lie on one object, in their order.
/// @param goesOn  may be empty
geometry::Result<CurveLine, CurveError> lineThrough(const SurfaceMesh &mesh,
                                                    std::span<const landmarks::Landmark *const> points,
                                                    landmarks::CurveKind kind, const glm::dmat4 &worldFromObject,
                                                    const GoesOn &goesOn);

/// Places in equal steps along a path, both its ends included: the steps are measured along it.
/// @param count  at least 2
/// @pre the path has at least one place
std::vector<geometry::WorldPoint> resampled(std::span<const geometry::WorldPoint> path, std::size_t count);

} // namespace unprojector::curves
