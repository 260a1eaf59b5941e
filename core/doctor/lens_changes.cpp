#include "core/doctor/lens_changes.h"

#include "core/base/translation.h"
#include "core/doctor/written_value.h"

#include <cmath>

namespace unprojector::doctor {
using base::marked;

namespace {

/// The tangent of half the vertical angle of a symmetric frustum.
double tangentOf(const Run &run)
{
    return 1.0 / run.clipFromEye[1][1];
}

/// Sets the depth entries of the projection matrix for other clip distances; both planes keep their
/// NDC depths.
void setClipDistances(Run &run, double nearDistance, double farDistance)
{
    glm::dmat4 &m = run.clipFromEye;
    const double z0 = run.given.side * nearDistance, z1 = run.given.side * farDistance;
    const double old0 = run.given.side * run.nearDistance, old1 = run.given.side * run.farDistance;
    run.nearDistance = nearDistance;
    run.farDistance = farDistance;
    if (!(nearDistance < farDistance)) {
        run.isLost = true;
        return;
    }
    if (run.given.isPerspective) {
        const double w = m[2][3];
        const double atNear = m[2][2] + m[3][2] / old0, atFar = m[2][2] + m[3][2] / old1; // w z_n
        m[3][2] = (atNear - atFar) / (1.0 / z0 - 1.0 / z1);
        m[2][2] = atNear - m[3][2] / z0;
        run.isLost = run.isLost || w == 0.0;
    } else {
        const double atNear = m[2][2] * old0 + m[3][2], atFar = m[2][2] * old1 + m[3][2];
        m[2][2] = (atNear - atFar) / (z0 - z1);
        m[3][2] = atNear - m[2][2] * z0;
    }
}

} // namespace

double verticalFov(const Run &run)
{
    return 2.0 * std::atan(tangentOf(run));
}

double aspectOf(const Run &run)
{
    return run.clipFromEye[1][1] / run.clipFromEye[0][0];
}

void widen(Run &run, double factor)
{
    run.clipFromEye[0][0] /= factor;
    run.clipFromEye[1][1] /= factor;
}

void setTangent(Run &run, double tangent)
{
    widen(run, tangent / tangentOf(run));
}

void setAspect(Run &run, double aspect)
{
    run.isLost = run.isLost || aspect == 0.0;
    run.clipFromEye[0][0] = run.clipFromEye[1][1] / aspect;
}

Variant withOtherPlanes(double nearDistance, double farDistance)
{
    return {.stage = Stage::Lens,
            .apply = [](Run &run) { setClipDistances(run, run.parameter, run.second); },
            .parameter = nearDistance,
            .second = farDistance,
            .name = {marked("near is %1, far is %2"),
                     {valueText(nearDistance), valueText(farDistance)},
                     marked("Your program's near plane is at %1, its far plane at %2.")},
            .values = {{"near", {nearDistance}}, {"far", {farDistance}}}};
}

Variant withOtherNear(const Given &given, double nearDistance)
{
    return {.stage = Stage::Lens,
            .apply = [](Run &run) { setClipDistances(run, run.parameter, run.farDistance); },
            .parameter = nearDistance,
            .name = {marked("near is %1, the scene has %2"),
                     {valueText(nearDistance), valueText(given.nearDistance)},
                     marked("Your program's near plane is at %1, the scene's at %2.")},
            .values = {{"near", {nearDistance}}}};
}

Variant withOtherNearOfFrustum(const Given &given, double nearDistance)
{
    Variant variant = withOtherNear(given, nearDistance);
    variant.apply = [](Run &run) {
        widen(run, run.nearDistance / run.parameter);
        setClipDistances(run, run.parameter, run.farDistance);
    };
    variant.name.words = marked("near is %1, the scene has %2; the window of glFrustum is as it was");
    variant.name.sentence =
        marked("Your program's near plane is at %1, the scene's at %2; the window of its glFrustum is the scene's.");
    return variant;
}

Variant withOtherFar(const Given &given, double farDistance)
{
    return {.stage = Stage::Lens,
            .apply = [](Run &run) { setClipDistances(run, run.nearDistance, run.parameter); },
            .parameter = farDistance,
            .name = {marked("far is %1, the scene has %2"),
                     {valueText(farDistance), valueText(given.farDistance)},
                     marked("Your program's far plane is at %1, the scene's at %2.")},
            .values = {{"far", {farDistance}}}};
}

} // namespace unprojector::doctor
