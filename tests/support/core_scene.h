#pragma once

#include "core/unproject/unprojector.h"
#include "tests/support/random_scene.h"

/// Converts the oracle's plain structs to core's. Only this file includes both.
namespace oracle {

inline unprojector::geometry::LookAt coreView(const View &view)
{
    return {unprojector::geometry::WorldPoint(view.eye[0], view.eye[1], view.eye[2]),
            unprojector::geometry::WorldPoint(view.center[0], view.center[1], view.center[2]),
            {view.up[0], view.up[1], view.up[2]}};
}

inline unprojector::geometry::Angle coreAngle(double angle, const Projection &p)
{
    return p.areDegrees ? unprojector::geometry::Angle::fromDegrees(angle) : unprojector::geometry::Angle(angle);
}

inline unprojector::geometry::Projection coreProjection(const Projection &p)
{
    const unprojector::geometry::Ortho box{p.left, p.right, p.bottom, p.top, p.nearDistance, p.farDistance};
    switch (p.kind) {
    case RandomKind::Frustum:
        return unprojector::geometry::Frustum{p.left, p.right, p.bottom, p.top, p.nearDistance, p.farDistance};
    case RandomKind::Perspective:
        return unprojector::geometry::Perspective{coreAngle(p.verticalFovRadians, p),
                                                  unprojector::geometry::DoubleDouble(p.aspect) / p.aspectHeight,
                                                  p.nearDistance, p.farDistance};
    case RandomKind::Oblique:
        return unprojector::geometry::Oblique{box, coreAngle(p.thetaRadians, p), coreAngle(p.phiRadians, p)};
    case RandomKind::Ortho: break;
    }
    return box;
}

inline unprojector::geometry::Viewport coreViewport(const Target &t)
{
    return {t.x, t.y, t.width, t.height};
}

inline unprojector::geometry::DepthRange coreDepthRange(const Target &t)
{
    return {t.depthAtNear, t.depthAtFar};
}

template <class Numbers> // a point, a vector or GLM's
Vector3 extended(const Numbers &v)
{
    return {Extended(v.x), Extended(v.y), Extended(v.z)};
}

inline unprojector::geometry::Setup corePicture(const Scene &s)
{
    unprojector::geometry::Setup g;
    g.surface = {static_cast<int>(s.target.width), static_cast<int>(s.target.height), 1.0};
    g.viewport = coreViewport(s.target);
    g.depthRange = coreDepthRange(s.target);
    g.lens = coreProjection(s.projection);
    g.pose = coreView(s.view);
    return g;
}

} // namespace oracle
