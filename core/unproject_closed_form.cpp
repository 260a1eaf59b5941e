#include "core/unproject_closed_form.h"

#include <cmath>

namespace unprojector {
namespace {

/// What every projection needs first: a valid projection and viewport, a finite position, and the depth in [0, 1].
Result<double> checkedUnitDepth(const Projection &projection, const Viewport &viewport, const DepthRange &range,
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
    return unitDepth(range, window.z);
}

} // namespace

double distanceFromDepthPerspective(double n, double f, double d)
{
    return n * f / (f * (1.0 - d) + n * d);
}

double distanceFromDepthOrtho(double n, double f, double d)
{
    return n * (1.0 - d) + f * d;
}

Result<EyePoint> unprojectFrustum(const Frustum &frustum, const Viewport &viewport, const DepthRange &range,
                                  const WindowPoint &window)
{
    const Result<double> d = checkedUnitDepth(frustum, viewport, range, window);
    if (!d)
        return d.error();
    const auto &[l, r, b, t, n, f] = frustum;
    const auto &[vx, vy, width, height] = viewport;

    const double z = distanceFromDepthPerspective(n, f, *d);
    const double x = (window.x - vx) * (r - l) * z / (width * n) + l * z / n;  // (9)
    const double y = (window.y - vy) * (t - b) * z / (height * n) + b * z / n; // (10)
    return EyePoint(x, y, -z);
}

Result<EyePoint> unprojectOrtho(const Ortho &ortho, const Viewport &viewport, const DepthRange &range,
                                const WindowPoint &window)
{
    const Result<double> d = checkedUnitDepth(ortho, viewport, range, window);
    if (!d)
        return d.error();
    const auto &[l, r, b, t, n, f] = ortho;
    const auto &[vx, vy, width, height] = viewport;

    const double z = distanceFromDepthOrtho(n, f, *d);
    const double x = (window.x - vx) * (r - l) / width + l;  // (11)
    const double y = (window.y - vy) * (t - b) / height + b; // (12)
    return EyePoint(x, y, -z);
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
    return EyePoint(inBox->x + cotangent(oblique.thetaRadians) * z, inBox->y + cotangent(oblique.phiRadians) * z, -z);
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
