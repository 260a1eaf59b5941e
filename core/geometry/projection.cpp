#include "core/geometry/projection.h"

#include "core/geometry/finite.h"
#include "core/geometry/numbers.h"

#include <algorithm>
#include <cmath>

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

Check checkBox(const ProjectionWindow &w, bool perspective)
{
    if (const Check window = checkWindow(w); !window)
        return window.error();
    return checkClipDistances(w.nearDistance, w.farDistance, perspective);
}

struct Checker {
    Check operator()(const Frustum &p) const { return checkBox(projectionWindow(p), true); }
    Check operator()(const Ortho &p) const { return checkBox(projectionWindow(p), false); }
    Check operator()(const Perspective &p) const
    {
        if (const auto value = firstNotFinite({p.verticalFov.radians.value, p.aspect.value}))
            return Error{ErrorCode::NotFinite, *value};
        if (const double fov = p.verticalFov.radians.value; !(fov > 0.0 && fov < kPi))
            return Error{ErrorCode::FieldOfViewOutOfRange, fov};
        if (!(p.aspect.value > 0.0))
            return Error{ErrorCode::AspectNotPositive, p.aspect.value};
        return checkClipDistances(p.nearDistance, p.farDistance, true);
    }
    Check operator()(const Pinhole &p) const
    {
        if (const auto value = firstNotFinite({p.fx, p.fy, p.cx, p.cy, p.skew, p.width, p.height}))
            return Error{ErrorCode::NotFinite, *value};
        if (p.fx == 0.0 || p.fy == 0.0)
            return Error{ErrorCode::FocalLengthIsZero, 0.0};
        if (!(p.width > 0.0 && p.height > 0.0))
            return Error{ErrorCode::EmptyImage, p.width, p.height};
        if (const Check distances = checkClipDistances(p.nearDistance, p.farDistance, true); !distances)
            return distances; // near = 0 would make the edges equal
        return checkWindow(projectionWindow(p));
    }
    Check operator()(const Oblique &p) const
    {
        for (const double angle : {p.theta.radians.value, p.phi.radians.value}) {
            if (!std::isfinite(angle))
                return Error{ErrorCode::NotFinite, angle};
            if (!(angle > 0.0 && angle < kPi))
                return Error{ErrorCode::ShearAngleOutOfRange, angle};
        }
        return checkBox(projectionWindow(p.box), false);
    }
};

glm::dmat4 orthoMatrix(const Ortho &p)
{
    const double l = p.left, r = p.right, b = p.bottom, t = p.top, n = p.nearDistance, f = p.farDistance;
    glm::dmat4 m(1.0);
    m[0][0] = 2.0 / (r - l);
    m[1][1] = 2.0 / (t - b);
    m[2][2] = -2.0 / (f - n);
    m[3] = {-(r + l) / (r - l), -(t + b) / (t - b), -(f + n) / (f - n), 1.0};
    return m;
}

glm::dmat4 frustumMatrix(const Frustum &p)
{
    const double l = p.left, r = p.right, b = p.bottom, t = p.top, n = p.nearDistance, f = p.farDistance;
    glm::dmat4 m(0.0);
    m[0][0] = 2.0 * n / (r - l);
    m[1][1] = 2.0 * n / (t - b);
    m[2] = {(r + l) / (r - l), (t + b) / (t - b), -(f + n) / (f - n), -1.0};
    m[3][2] = -2.0 * f * n / (f - n);
    if (p.skew != 0.0)
        m[1][0] = m[0][0] * p.skew;
    return m;
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
    return std::visit(Checker{}, projection);
}

Frustum frustumFromPerspective(const Perspective &p)
{
    const PreciseEdges e = preciseEdges(p);
    return {e.left.value, e.right.value, e.bottom.value, e.top.value, p.nearDistance, p.farDistance};
}

Frustum frustumFromPinhole(const Pinhole &p)
{
    const PreciseEdges e = preciseEdges(p);
    return {e.left.value, e.right.value, e.bottom.value, e.top.value, p.nearDistance, p.farDistance, e.skew.value};
}

PreciseEdges preciseEdges(const Projection &projection)
{
    if (const auto *p = std::get_if<Perspective>(&projection)) {
        const DoubleDouble top = p->nearDistance * preciseTangent(p->verticalFov.radians / 2.0),
                           right = top * p->aspect;
        return {-right, right, -top, top, 0.0};
    }
    if (const auto *p = std::get_if<Pinhole>(&projection)) {
        const DoubleDouble n = p->nearDistance, toCorner = cornerToCentre(*p);
        const DoubleDouble cx = p->cx + toCorner, cy = p->cy + toCorner;
        return {-(n * cx) / p->fx, n * (p->width - cx) / p->fx, -(n * (p->height - cy)) / p->fy, n * cy / p->fy,
                p->skew == 0.0 ? DoubleDouble() : -DoubleDouble(p->skew) / p->fx};
    }
    const ProjectionWindow w = projectionWindow(projection);
    return {w.left, w.right, w.bottom, w.top, w.skew};
}

ProjectionWindow projectionWindow(const Projection &projection)
{
    struct Visitor {
        ProjectionWindow operator()(const Frustum &p) const
        {
            return {p.left, p.right, p.bottom, p.top, p.nearDistance, p.farDistance, p.skew};
        }
        ProjectionWindow operator()(const Pinhole &p) const { return (*this)(frustumFromPinhole(p)); }
        ProjectionWindow operator()(const Ortho &p) const
        {
            return {p.left, p.right, p.bottom, p.top, p.nearDistance, p.farDistance};
        }
        ProjectionWindow operator()(const Perspective &p) const { return (*this)(frustumFromPerspective(p)); }
        ProjectionWindow operator()(const Oblique &p) const { return (*this)(p.box); }
    };
    return std::visit(Visitor{}, projection);
}

bool isPerspective(const Projection &projection)
{
    return !std::holds_alternative<Ortho>(projection) && !std::holds_alternative<Oblique>(projection);
}

Result<glm::dmat4> clipFromEye(const Projection &projection)
{
    if (const Check valid = check(projection); !valid)
        return valid.error();
    struct Visitor {
        glm::dmat4 operator()(const Frustum &p) const { return frustumMatrix(p); }
        glm::dmat4 operator()(const Pinhole &p) const { return pinholeMatrix(p); }
        glm::dmat4 operator()(const Ortho &p) const { return orthoMatrix(p); }
        glm::dmat4 operator()(const Perspective &p) const { return frustumMatrix(frustumFromPerspective(p)); }
        glm::dmat4 operator()(const Oblique &p) const
        {
            glm::dmat4 shear(1.0);
            shear[2][0] = cotangent(p.theta);
            shear[2][1] = cotangent(p.phi);
            return orthoMatrix(p.box) * shear;
        }
    };
    return std::visit(Visitor{}, projection);
}

Projection withAspect(const Projection &projection, const DoubleDouble &aspect)
{
    struct Visitor {
        const DoubleDouble &aspect;
        /// Scaling left and right keeps the view axis at the same share of the width.
        Projection operator()(Frustum p) const
        {
            const double scale = std::abs(p.top - p.bottom) * aspect.value / std::abs(p.right - p.left);
            p.left *= scale;
            p.right *= scale;
            return p;
        }
        Projection operator()(const Pinhole &p) const
        {
            constexpr double kRounding = 1e-12;
            const double own = std::abs(p.width / p.fx) / std::abs(p.height / p.fy);
            return std::abs(own - aspect.value) <= kRounding * aspect.value ? Projection(p)
                                                                            : (*this)(frustumFromPinhole(p));
        }
        Projection operator()(const Ortho &p) const { return widened(p); }
        Projection operator()(Perspective p) const
        {
            p.aspect = aspect;
            return p;
        }
        Projection operator()(Oblique p) const
        {
            p.box = widened(p.box);
            return p;
        }
        static Ortho widenedTo(Ortho p, double width)
        {
            const double center = p.left + (p.right - p.left) / 2.0;
            const double half = std::copysign(width / 2.0, p.right - p.left);
            p.left = center - half;
            p.right = center + half;
            return p;
        }
        Ortho widened(const Ortho &p) const { return widenedTo(p, std::abs(p.top - p.bottom) * aspect.value); }
    };
    return std::visit(Visitor{aspect}, projection);
}

ProjectionKind kindOf(const Projection &projection)
{
    struct Visitor {
        ProjectionKind operator()(const Frustum &) const { return ProjectionKind::Frustum; }
        ProjectionKind operator()(const Pinhole &) const { return ProjectionKind::Frustum; }
        ProjectionKind operator()(const Perspective &) const { return ProjectionKind::Perspective; }
        ProjectionKind operator()(const Ortho &) const { return ProjectionKind::Ortho; }
        ProjectionKind operator()(const Oblique &) const { return ProjectionKind::Oblique; }
    };
    return std::visit(Visitor{}, projection);
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
        const double dx = cotangent(oblique->theta) * distance;
        const double dy = cotangent(oblique->phi) * distance;
        box = {box.left + dx, box.right + dx, box.bottom + dy, box.top + dy, box.nearDistance, box.farDistance};
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
    struct Visitor {
        double n, f;
        Projection operator()(Frustum p) const
        {
            const double scale = n / p.nearDistance;
            return Frustum{p.left * scale, p.right * scale, p.bottom * scale, p.top * scale, n, f, p.skew};
        }
        Projection operator()(Pinhole p) const
        {
            p.nearDistance = n;
            p.farDistance = f;
            return p;
        }
        Projection operator()(Ortho p) const
        {
            p.nearDistance = n;
            p.farDistance = f;
            return p;
        }
        Projection operator()(Perspective p) const
        {
            p.nearDistance = n;
            p.farDistance = f;
            return p;
        }
        Projection operator()(Oblique p) const
        {
            p.box.nearDistance = n;
            p.box.farDistance = f;
            return p;
        }
    };
    return std::visit(Visitor{nearDistance, farDistance}, projection);
}

} // namespace unprojector::geometry
