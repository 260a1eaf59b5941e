#include "core/geometry/projection.h"

#include "core/geometry/finite.h"
#include "core/geometry/matrix_rows.h"
#include "core/geometry/numbers.h"
#include "core/geometry/parallel_projection.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <variant>

namespace unprojector::geometry {
namespace {

/// Both angles of an oblique projection converted from another kind.
constexpr double kFirstShearDegrees = 45.0;

Check checkWindow(const ProjectionWindow &w)
{
    if (const auto value = firstNotFinite({w.left, w.right, w.bottom, w.top, w.nearDistance, w.farDistance, w.skew}))
        return Error{ErrorCode::NotFinite, *value};
    if (w.left == w.right)
        return Error{ErrorCode::LeftEqualsRight, w.left};
    if (w.bottom == w.top)
        return Error{ErrorCode::BottomEqualsTop, w.bottom};
    return std::monostate{};
}

Check checkClipDistances(double nearDistance, double farDistance, bool perspective)
{
    if (const auto value = firstNotFinite({nearDistance, farDistance}))
        return Error{ErrorCode::NotFinite, *value};
    if (perspective && !(nearDistance > 0.0))
        return Error{ErrorCode::NearNotPositive, nearDistance, farDistance};
    if (!(nearDistance < farDistance))
        return Error{ErrorCode::NearNotBeforeFar, nearDistance, farDistance};
    return std::monostate{};
}

Frustum frustumOf(const Projection &projection)
{
    const auto [l, r, b, t, n, f, skew] = projectionWindow(projection);
    return {l, r, b, t, n, f, skew};
}

double cornerToCentre(const Pinhole &p)
{
    return p.areCentersWhole ? 0.5 : 0.0;
}

/// For pixels counted from the image's corner:
///
///   w x_n = 2 (fx X + skew Y + cx Z) / width - Z,  w y_n = Z - 2 (fy Y + cy Z) / height,  w = Z
glm::dmat4 pinholeMatrix(const Pinhole &p)
{
    const double n = p.nearDistance, f = p.farDistance, toCorner = cornerToCentre(p);
    glm::dmat4 m(0.0);
    m[0][0] = 2.0 * p.fx / p.width;
    m[1][0] = p.skew == 0.0 ? 0.0 : -2.0 * p.skew / p.width;
    m[2][0] = 1.0 - 2.0 * (p.cx + toCorner) / p.width;
    m[1][1] = 2.0 * p.fy / p.height;
    m[2][1] = 2.0 * (p.cy + toCorner) / p.height - 1.0;
    m[2][2] = -(f + n) / (f - n);
    m[3][2] = -2.0 * f * n / (f - n);
    m[2][3] = -1.0;
    return m;
}

} // namespace

DoubleDouble preciseCotangent(const Angle &angle)
{
    return angle.radians.value == kPi / 2.0 ? DoubleDouble(0.0) : 1.0 / preciseTangent(angle.radians);
}

double cotangent(const Angle &angle)
{
    return preciseCotangent(angle).value;
}

Check check(const Projection &projection)
{
    if (const auto *p = std::get_if<Perspective>(&projection)) {
        if (const auto value = firstNotFinite({p->verticalFov.radians.value, p->aspect.value}))
            return Error{ErrorCode::NotFinite, *value};
        if (const double fov = p->verticalFov.radians.value; !(fov > 0.0 && fov < kPi))
            return Error{ErrorCode::FieldOfViewOutOfRange, fov};
        if (!(p->aspect.value > 0.0))
            return Error{ErrorCode::AspectNotPositive, p->aspect.value};
        return checkClipDistances(p->nearDistance, p->farDistance, true);
    }
    if (const auto *p = std::get_if<Pinhole>(&projection)) {
        if (const auto value = firstNotFinite({p->fx, p->fy, p->cx, p->cy, p->skew, p->width, p->height}))
            return Error{ErrorCode::NotFinite, *value};
        if (p->fx == 0.0 || p->fy == 0.0)
            return Error{ErrorCode::FocalLengthIsZero, 0.0};
        if (!(p->width > 0.0 && p->height > 0.0))
            return Error{ErrorCode::EmptyImage, p->width, p->height};
        if (const Check distances = checkClipDistances(p->nearDistance, p->farDistance, true); !distances)
            return distances; // near = 0 would make the edges equal
    }
    if (const auto *p = std::get_if<Oblique>(&projection)) {
        for (const double angle : {p->theta.radians.value, p->phi.radians.value}) {
            if (!std::isfinite(angle))
                return Error{ErrorCode::NotFinite, angle};
            if (!(angle > 0.0 && angle < kPi))
                return Error{ErrorCode::ShearAngleOutOfRange, angle};
        }
    }
    const ProjectionWindow w = projectionWindow(projection);
    if (const Check window = checkWindow(w); !window)
        return window;
    return checkClipDistances(w.nearDistance, w.farDistance, isPerspective(projection));
}

Frustum frustumFromPerspective(const Perspective &p)
{
    return frustumOf(p);
}

Frustum frustumFromPinhole(const Pinhole &p)
{
    return frustumOf(p);
}

PreciseEdges preciseEdges(const Projection &projection)
{
    return edgesOf<TwoDoubles>(projection);
}

ProjectionWindow projectionWindow(const Projection &projection)
{
    if (const auto *p = std::get_if<Frustum>(&projection))
        return {p->left, p->right, p->bottom, p->top, p->nearDistance, p->farDistance, p->skew};
    const auto ofBox = [](const Ortho &p) -> ProjectionWindow {
        return {p.left, p.right, p.bottom, p.top, p.nearDistance, p.farDistance};
    };
    if (const auto *p = std::get_if<Ortho>(&projection))
        return ofBox(*p);
    if (const auto *p = std::get_if<Oblique>(&projection))
        return ofBox(p->box);
    const auto [l, r, b, t, skew] = preciseEdges(projection);
    const auto *pinhole = std::get_if<Pinhole>(&projection);
    const auto *perspective = std::get_if<Perspective>(&projection);
    return {l.value,
            r.value,
            b.value,
            t.value,
            pinhole ? pinhole->nearDistance : perspective->nearDistance,
            pinhole ? pinhole->farDistance : perspective->farDistance,
            skew.value};
}

bool isPerspective(const Projection &projection)
{
    return !std::holds_alternative<Ortho>(projection) && !std::holds_alternative<Oblique>(projection);
}

Ortho *boxOf(Projection &projection)
{
    if (auto *oblique = std::get_if<Oblique>(&projection))
        return &oblique->box;
    return std::get_if<Ortho>(&projection);
}

glm::dvec2 shearOf(const Projection &projection)
{
    const auto *oblique = std::get_if<Oblique>(&projection);
    return oblique ? glm::dvec2(cotangent(oblique->theta), cotangent(oblique->phi)) : glm::dvec2(0.0);
}

Result<glm::dmat4> clipFromEye(const Projection &projection)
{
    if (const Check valid = check(projection); !valid)
        return valid.error();
    if (const auto *pinhole = std::get_if<Pinhole>(&projection))
        return pinholeMatrix(*pinhole);
    const auto [l, r, b, t, n, f, skew] = projectionWindow(projection);
    if (isPerspective(projection)) {
        glm::dmat4 m(0.0);
        m[0][0] = 2.0 * n / (r - l);
        m[1][1] = 2.0 * n / (t - b);
        m[2] = {(r + l) / (r - l), (t + b) / (t - b), -(f + n) / (f - n), -1.0};
        m[3][2] = -2.0 * f * n / (f - n);
        if (skew != 0.0)
            m[1][0] = m[0][0] * skew;
        return m;
    }
    glm::dmat4 m(1.0);
    m[0][0] = 2.0 / (r - l);
    m[1][1] = 2.0 / (t - b);
    m[2][2] = -2.0 / (f - n);
    m[3] = {-(r + l) / (r - l), -(t + b) / (t - b), -(f + n) / (f - n), 1.0};
    if (!std::holds_alternative<Oblique>(projection))
        return m;
    glm::dmat4 sheared(1.0);
    const glm::dvec2 shear = shearOf(projection);
    sheared[2] = {shear, 1.0, 0.0};
    return m * sheared;
}

Projection withAspect(const Projection &projection, const DoubleDouble &aspect)
{
    Projection result = projection;
    if (auto *perspective = std::get_if<Perspective>(&result)) {
        perspective->aspect = aspect;
        return result;
    }
    if (const auto *p = std::get_if<Pinhole>(&projection)) {
        constexpr double kRounding = 1e-12;
        const double own = std::abs(p->width / p->fx) / std::abs(p->height / p->fy);
        if (std::abs(own - aspect.value) <= kRounding * aspect.value)
            return projection;
        result = frustumFromPinhole(*p);
    }
    if (auto *p = std::get_if<Frustum>(&result)) {
        // Scaling left and right keeps the view axis at the same share of the width.
        const double scale = std::abs(p->top - p->bottom) * aspect.value / std::abs(p->right - p->left);
        p->left *= scale;
        p->right *= scale;
        return result;
    }
    Ortho &box = *boxOf(result);
    const double center = box.left + (box.right - box.left) / 2.0;
    const double half = std::copysign(std::abs(box.top - box.bottom) * aspect.value / 2.0, box.right - box.left);
    box.left = center - half;
    box.right = center + half;
    return result;
}

ProjectionKind kindOf(const Projection &projection)
{
    using enum ProjectionKind;
    constexpr ProjectionKind kKinds[] = {Frustum, Ortho, Perspective, Oblique, Frustum}; // in the order of Projection
    static_assert(std::size(kKinds) == std::variant_size_v<Projection>);
    return kKinds[projection.index()];
}

Projection converted(const Projection &projection, ProjectionKind kind, double distance)
{
    if (kindOf(projection) == kind)
        return projection;

    // The window at `distance` is the reference, because both views must agree there.
    const ProjectionWindow w = projectionWindow(projection);
    const bool wasPerspective = isPerspective(projection);
    const double magnified = wasPerspective ? distance / w.nearDistance : 1.0;
    Ortho box{w.left * magnified, w.right * magnified, w.bottom * magnified,
              w.top * magnified,  w.nearDistance,      w.farDistance};
    if (const auto *oblique = std::get_if<Oblique>(&projection)) {
        const glm::dvec2 shift = shearOf(*oblique) * distance;
        box = {box.left + shift.x, box.right + shift.x, box.bottom + shift.y,
               box.top + shift.y,  box.nearDistance,    box.farDistance};
    }
    if (kind == ProjectionKind::Ortho)
        return box;
    if (kind == ProjectionKind::Oblique) {
        // A shear large enough to see; 45 degrees shifts a point by its depth.
        const Angle angle = Angle::fromDegrees(kFirstShearDegrees);
        const double shift = cotangent(angle) * distance;
        box = {box.left - shift, box.right - shift, box.bottom - shift,
               box.top - shift,  box.nearDistance,  box.farDistance};
        return Oblique{box, angle, angle};
    }

    Frustum frustum{w.left, w.right, w.bottom, w.top, w.nearDistance, w.farDistance, w.skew};
    if (!wasPerspective) {
        constexpr double kNearShare = 0.01; // share of the distance, where a box begins behind the eye
        const double n = box.nearDistance > 0.0 ? box.nearDistance : distance * kNearShare;
        const double k = n / distance;
        frustum = {box.left * k, box.right * k, box.bottom * k, box.top * k, n, std::max(box.farDistance, 2.0 * n)};
    }
    if (kind == ProjectionKind::Frustum)
        return frustum;
    const double height = std::abs(frustum.top - frustum.bottom);
    return Perspective{2.0 * std::atan(height / 2.0 / frustum.nearDistance),
                       std::abs(frustum.right - frustum.left) / height, frustum.nearDistance, frustum.farDistance};
}

Projection withClipDistances(const Projection &projection, double nearDistance, double farDistance)
{
    Projection result = projection;
    if (auto *frustum = std::get_if<Frustum>(&result)) {
        const double scale = nearDistance / frustum->nearDistance;
        for (double *edge : {&frustum->left, &frustum->right, &frustum->bottom, &frustum->top})
            *edge *= scale;
    }
    std::visit(
        [&](auto &p) {
            if constexpr (requires { p.box; }) {
                p.box.nearDistance = nearDistance;
                p.box.farDistance = farDistance;
            } else {
                p.nearDistance = nearDistance;
                p.farDistance = farDistance;
            }
        },
        result);
    return result;
}

} // namespace unprojector::geometry
