#include "core/geometry/way_forward.h"

#include <cstddef>

namespace unprojector::geometry {
namespace {

MatrixRows<DoubleDouble> rowsOf(const glm::dmat4 &m)
{
    MatrixRows<DoubleDouble> rows;
    for (std::size_t row = 0; row < 4; ++row) {
        for (std::size_t column = 0; column < 4; ++column)
            rows[row][column] = m[static_cast<int>(column)][static_cast<int>(row)];
    }
    return rows;
}

DoubleDouble3 divided(const DoubleDouble4 &v)
{
    return {v[0] / v[3], v[1] / v[3], v[2] / v[3]};
}

} // namespace

DoubleDouble3 precise(const glm::dvec3 &v)
{
    return {v.x, v.y, v.z};
}

Result<WayForward> WayForward::of(const Setup &setup)
{
    if (const Result<glm::dmat4> matrix = clipFromWorld(setup); !matrix)
        return matrix.error();
    if (const Check valid = check(setup.viewport); !valid)
        return valid.error();
    WayForward way;
    if (const auto *camera = std::get_if<LookAt>(&setup.pose)) {
        const PreciseEyeFrame frame = preciseEyeFrame(*camera).value(); // clipFromWorld has checked it
        way.m_origin = frame.eye.coordinates();
        for (std::size_t k = 0; k < 3; ++k) {
            way.m_eyeFromWorld[0][k] = frame.side[k];
            way.m_eyeFromWorld[1][k] = frame.upward[k];
            way.m_eyeFromWorld[2][k] = -frame.forward[k];
        }
        way.m_eyeFromWorld[3][3] = 1.0;
    } else {
        way.m_eyeFromWorld = rowsOf(std::get<glm::dmat4>(setup.pose));
    }
    const auto *matrix = std::get_if<MatrixProjection>(&setup.lens);
    way.m_clipFromEye =
        matrix != nullptr ? rowsOf(matrix->clipFromEye) : clipRows<TwoDoubles>(std::get<Projection>(setup.lens));
    way.m_viewport = setup.viewport;
    way.m_depthRange = setup.depthRange;
    way.m_ndcDepth = ndcDepthOf(setup);
    return way;
}

PreciseStages WayForward::fromHomogeneousEye(const DoubleDouble4 &eye) const
{
    PreciseStages stages{divided(eye), applied(m_clipFromEye, eye), {}, {}};
    stages.ndc = divided(stages.clip);
    const auto &[x, y, z] = stages.ndc;
    const DoubleDouble share = m_ndcDepth == NdcDepth::ZeroToOne ? z : (z + 1.0) / 2.0;
    stages.window = {m_viewport.x + (x + 1.0) * m_viewport.width / 2.0,
                     m_viewport.y + (y + 1.0) * m_viewport.height / 2.0,
                     m_depthRange.atNear + share * (DoubleDouble(m_depthRange.atFar) - m_depthRange.atNear)};
    return stages;
}

PreciseStages WayForward::fromEye(const DoubleDouble3 &eye) const
{
    return fromHomogeneousEye({eye[0], eye[1], eye[2], 1.0});
}

PreciseStages WayForward::fromWorld(const DoubleDouble3 &world) const
{
    return fromHomogeneousEye(
        applied(m_eyeFromWorld, {world[0] - m_origin.x, world[1] - m_origin.y, world[2] - m_origin.z, 1.0}));
}

} // namespace unprojector::geometry
