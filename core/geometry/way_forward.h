#pragma once

#include "core/geometry/matrix_rows.h"
#include "core/geometry/numbers.h"
#include "core/geometry/result.h"
#include "core/geometry/setup.h"
#include "core/geometry/spaces.h"

#include <glm/mat4x4.hpp>

#include <array>

namespace unprojector::geometry {

using DoubleDouble4 = MatrixRow<DoubleDouble>;

DoubleDouble3 precise(const glm::dvec3 &v);

/// A point in each space on its way to the window, before rounding.
struct PreciseStages {
    DoubleDouble3 eye;
    DoubleDouble4 clip;
    DoubleDouble3 ndc, window; ///< not finite where clip[3] is 0: in the plane of the eye
};

/// Projects from world space to the window with 32 digits. Far from the world's origin the digits
/// of the point and of the eye cancel, and the remaining ones determine the pixel. Nothing is
/// rounded before a stage is returned. Prepared once for a setup. A point beyond the range of
/// doubles is not finite.
class WayForward {
public:
    /// @return the errors of clipFromWorld and check(viewport)
    static Result<WayForward> of(const Setup &setup);

    PreciseStages fromWorld(const DoubleDouble3 &world) const;
    PreciseStages fromEye(const DoubleDouble3 &eye) const;

private:
    friend class WayBack;
    WayForward() = default;
    PreciseStages fromHomogeneousEye(const DoubleDouble4 &eye) const;

    glm::dvec3 m_origin{0.0}; ///< origin of the world, for m_eyeFromWorld: a camera's eye
    MatrixRows<DoubleDouble> m_eyeFromWorld{}, m_clipFromEye{};
    Viewport m_viewport;
    DepthRange m_depthRange;
    NdcDepth m_ndcDepth = NdcDepth::MinusOneToOne;
};

} // namespace unprojector::geometry
