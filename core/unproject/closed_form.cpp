#include "core/unproject/closed_form.h"

#include "core/geometry/finite.h"

#include <cmath>

namespace unprojector::unproject {
using namespace geometry;

namespace {

using PreciseEye = PrecisePoint<EyeSpace>;
using PreciseWindow = PrecisePoint<WindowSpace>;

/// (position - start) (high - low) / size + low: formulas (11), (12) and, except for the factor z /
/// n, (9), (10).
DoubleDouble betweenEdges(const DoubleDouble &low, const DoubleDouble &high, const DoubleDouble &position, double start,
                          double size)
{
    return (position - start) / size * (high - low) + low;
}

} // namespace

Result<PreciseEye> preciseEyePoint(const Projection &projection, const Viewport &viewport, const DepthRange &range,
                                   const PreciseWindow &window)
{
    for (const Check &valid : {check(projection), check(viewport)}) {
        if (!valid)
            return valid.error();
    }
    if (const auto value = firstNotFinite({window.x.value, window.y.value}))
        return Error{ErrorCode::NotFinite, *value};
    const Result<DepthShares> d = depthShares(range, window.z.value);
    if (!d)
        return d.error();

    const auto &[l, r, b, t, skew] = preciseEdges(projection);
    const auto &[vx, vy, width, height] = viewport;
    const ProjectionWindow w = projectionWindow(projection);
    const DoubleDouble n = w.nearDistance, f = w.farDistance;
    const DoubleDouble x = betweenEdges(l, r, window.x, vx, width), y = betweenEdges(b, t, window.y, vy, height);
    PreciseEye eye;
    if (isPerspective(projection)) {
        // The ratio of the near plane's window to the view volume's section at z. Divided by f, so that n f
        // cannot overflow.
        const DoubleDouble nOverZ = d->fromFar + d->fromNear * (n / f);
        eye = {x / nOverZ, y / nOverZ, -(n / nOverZ)}; // (9), (10)
        if (skew.value != 0.0)
            eye.x = eye.x - skew * eye.y;
    } else {
        const DoubleDouble z = n * d->fromFar + f * d->fromNear;
        eye = {x, y, -z}; // (11), (12)
        if (const auto *oblique = std::get_if<Oblique>(&projection))
            eye = {x + preciseCotangent(oblique->theta) * z, y + preciseCotangent(oblique->phi) * z, -z};
    }
    if (!isFinite(eye.rounded())) // parameters at the ends of the range of doubles
        return Error{ErrorCode::PointAtInfinity};
    return eye;
}

} // namespace unprojector::unproject
