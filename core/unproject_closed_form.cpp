#include "core/unproject_closed_form.h"

#include "core/exact_rounding.h"

#include <cmath>

namespace unprojector {
namespace {

/// What every projection needs first: a valid projection and viewport, a finite position, and the depth in [0, 1].
Result<DepthShares> checkedDepth(const Projection &projection, const Viewport &viewport, const DepthRange &range,
                                 const WindowPoint &window)
{
    if (const Check valid = check(projection); !valid)
        return valid.error();
    if (const Check valid = check(viewport); !valid)
        return valid.error();
    for (const double value : {window.x, window.y}) {
        if (!std::isfinite(value))
            return Error{ErrorCode::NotFinite, value};
    }
    return depthShares(range, window.z);
}

/// n / z = 1 - d + d n / f: the share that the near plane's window has of the view volume's section at z.
double nearOverDistance(double n, double f, const DepthShares &d)
{
    return std::fma(d.fromNear, n / f, d.fromFar); // divided by f, so that n f cannot overflow
}

/// (position / size) (high - low) + low, times z / n: formulas (9) to (12), regrouped into low (size - position)
/// + high position, over size. Their two terms cancel where the window straddles the view axis; these two products
/// are kept whole.
double betweenEdges(double low, double high, double position, double size, double nOverZ = 1.0)
{
    return sumOfProducts(low, size - position, high, position) / (size * nOverZ);
}

/// Parameters at the ends of the range of doubles can overflow on the way.
Result<EyePoint> finite(const EyePoint &point)
{
    if (!(std::isfinite(point.x) && std::isfinite(point.y) && std::isfinite(point.z)))
        return Error{ErrorCode::PointAtInfinity};
    return point;
}

} // namespace

double distanceFromDepthPerspective(double n, double f, const DepthShares &d)
{
    return n / nearOverDistance(n, f, d);
}

double distanceFromDepthPerspective(double n, double f, double d)
{
    return distanceFromDepthPerspective(n, f, DepthShares{d, 1.0 - d});
}

double distanceFromDepthOrtho(double n, double f, const DepthShares &d)
{
    return sumOfProducts(n, d.fromFar, f, d.fromNear);
}

double distanceFromDepthOrtho(double n, double f, double d)
{
    return distanceFromDepthOrtho(n, f, DepthShares{d, 1.0 - d});
}

Result<EyePoint> unprojectFrustum(const Frustum &frustum, const Viewport &viewport, const DepthRange &range,
                                  const WindowPoint &window)
{
    const Result<DepthShares> d = checkedDepth(frustum, viewport, range, window);
    if (!d)
        return d.error();
    const auto &[l, r, b, t, n, f] = frustum;
    const auto &[vx, vy, width, height] = viewport;

    const double z = distanceFromDepthPerspective(n, f, *d);
    const double nOverZ = nearOverDistance(n, f, *d);
    const double x = betweenEdges(l, r, window.x - vx, width, nOverZ);  // (9)
    const double y = betweenEdges(b, t, window.y - vy, height, nOverZ); // (10)
    return finite(EyePoint(x, y, -z));
}

Result<EyePoint> unprojectOrtho(const Ortho &ortho, const Viewport &viewport, const DepthRange &range,
                                const WindowPoint &window)
{
    const Result<DepthShares> d = checkedDepth(ortho, viewport, range, window);
    if (!d)
        return d.error();
    const auto &[l, r, b, t, n, f] = ortho;
    const auto &[vx, vy, width, height] = viewport;

    const double z = distanceFromDepthOrtho(n, f, *d);
    const double x = betweenEdges(l, r, window.x - vx, width);  // (11)
    const double y = betweenEdges(b, t, window.y - vy, height); // (12)
    return finite(EyePoint(x, y, -z));
}

Result<EyePoint> unprojectOblique(const Oblique &oblique, const Viewport &viewport, const DepthRange &range,
                                  const WindowPoint &window)
{
    if (const Check valid = check(Projection(oblique)); !valid)
        return valid.error();
    Result<EyePoint> inBox = unprojectOrtho(oblique.box, viewport, range, window);
    if (!inBox)
        return inBox;
    const double z = -inBox->z;
    return finite(EyePoint(std::fma(cotangent(oblique.thetaRadians), z, inBox->x),
                           std::fma(cotangent(oblique.phiRadians), z, inBox->y), -z));
}

Result<EyePoint> unprojectClosedForm(const Projection &projection, const Viewport &viewport, const DepthRange &range,
                                     const WindowPoint &window)
{
    struct Visitor {
        const Viewport &viewport;
        const DepthRange &range;
        const WindowPoint &window;
        Result<EyePoint> operator()(const Frustum &p) const { return unprojectFrustum(p, viewport, range, window); }
        Result<EyePoint> operator()(const Ortho &p) const { return unprojectOrtho(p, viewport, range, window); }
        Result<EyePoint> operator()(const Oblique &p) const { return unprojectOblique(p, viewport, range, window); }
        Result<EyePoint> operator()(const Perspective &p) const
        {
            if (const Check valid = check(Projection(p)); !valid)
                return valid.error();
            return unprojectFrustum(frustumFromPerspective(p), viewport, range, window);
        }
    };
    return std::visit(Visitor{viewport, range, window}, projection);
}

} // namespace unprojector
