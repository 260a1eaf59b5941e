#include "core/unproject/closed_form.h"

#include "core/geometry/finite.h"

#include <cmath>

namespace unprojector::unproject {
using namespace geometry;

namespace {

using PreciseEye = PrecisePoint<EyeSpace>;
using PreciseWindow = PrecisePoint<WindowSpace>;

/// Checks the common preconditions: a valid projection and viewport, and a finite position. Returns
/// the depth in [0, 1].
Result<DepthShares> checkedDepth(const Projection &projection, const Viewport &viewport, const DepthRange &range,
                                 const PreciseWindow &window)
{
    if (const Check valid = check(projection); !valid)
        return valid.error();
    if (const Check valid = check(viewport); !valid)
        return valid.error();
    if (const auto value = firstNotFinite({window.x.value, window.y.value}))
        return Error{ErrorCode::NotFinite, *value};
    return depthShares(range, window.z.value);
}

/// n / z = 1 - d + d n / f: the ratio of the near plane's window to the view volume's section at z.
DoubleDouble nearOverDistance(double n, double f, const DepthShares &d)
{
    return d.fromFar + d.fromNear * (DoubleDouble(n) / f); // divided by f, so that n f cannot overflow
}

DoubleDouble boxDistance(double n, double f, const DepthShares &d)
{
    return n * d.fromFar + f * d.fromNear;
}

/// (position - start) (high - low) / size + low: formulas (11), (12) and, except for the factor z /
/// n, (9), (10).
DoubleDouble betweenEdges(const DoubleDouble &low, const DoubleDouble &high, const DoubleDouble &position, double start,
                          double size)
{
    return (position - start) / size * (high - low) + low;
}

/// Checks for overflow, which parameters at the ends of the range of doubles can cause.
Result<PreciseEye> finite(const PreciseEye &point)
{
    if (!isFinite(point.rounded()))
        return Error{ErrorCode::PointAtInfinity};
    return point;
}

/// The eye point of a frustum, a perspective or a pinhole.
Result<PreciseEye> preciseFrustum(const Projection &projection, const Viewport &viewport, const DepthRange &range,
                                  const PreciseWindow &window)
{
    const Result<DepthShares> d = checkedDepth(projection, viewport, range, window);
    if (!d)
        return d.error();
    const auto &[l, r, b, t, skew] = preciseEdges(projection);
    const auto &[vx, vy, width, height] = viewport;
    const ProjectionWindow w = projectionWindow(projection);
    const double n = w.nearDistance, f = w.farDistance;

    const DoubleDouble nOverZ = nearOverDistance(n, f, *d);
    const DoubleDouble x = betweenEdges(l, r, window.x, vx, width) / nOverZ;  // (9)
    const DoubleDouble y = betweenEdges(b, t, window.y, vy, height) / nOverZ; // (10)
    return finite({skew.value == 0.0 ? x : x - skew * y, y, -(n / nOverZ)});
}

Result<PreciseEye> preciseOrtho(const Ortho &ortho, const Viewport &viewport, const DepthRange &range,
                                const PreciseWindow &window)
{
    const Result<DepthShares> d = checkedDepth(ortho, viewport, range, window);
    if (!d)
        return d.error();
    const auto &[l, r, b, t, n, f] = ortho;
    const auto &[vx, vy, width, height] = viewport;

    const DoubleDouble x = betweenEdges(l, r, window.x, vx, width);  // (11)
    const DoubleDouble y = betweenEdges(b, t, window.y, vy, height); // (12)
    return finite({x, y, -boxDistance(n, f, *d)});
}

Result<PreciseEye> preciseOblique(const Oblique &oblique, const Viewport &viewport, const DepthRange &range,
                                  const PreciseWindow &window)
{
    if (const Check valid = check(Projection(oblique)); !valid)
        return valid.error();
    const Result<PreciseEye> inBox = preciseOrtho(oblique.box, viewport, range, window);
    if (!inBox)
        return inBox;
    const DoubleDouble z = -inBox->z;
    return finite({inBox->x + preciseCotangent(oblique.theta) * z, inBox->y + preciseCotangent(oblique.phi) * z, -z});
}

} // namespace

Result<PreciseEye> preciseEyePoint(const Projection &projection, const Viewport &viewport, const DepthRange &range,
                                   const PreciseWindow &window)
{
    struct Visitor {
        const Viewport &viewport;
        const DepthRange &range;
        const PreciseWindow &window;
        Result<PreciseEye> operator()(const Frustum &p) const { return preciseFrustum(p, viewport, range, window); }
        Result<PreciseEye> operator()(const Ortho &p) const { return preciseOrtho(p, viewport, range, window); }
        Result<PreciseEye> operator()(const Oblique &p) const { return preciseOblique(p, viewport, range, window); }
        Result<PreciseEye> operator()(const Pinhole &p) const { return preciseFrustum(p, viewport, range, window); }
        Result<PreciseEye> operator()(const Perspective &p) const { return preciseFrustum(p, viewport, range, window); }
    };
    return std::visit(Visitor{viewport, range, window}, projection);
}

} // namespace unprojector::unproject
