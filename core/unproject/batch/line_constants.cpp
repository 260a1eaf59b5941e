#include "core/unproject/batch/line_constants.h"

#include "core/geometry/finite.h"
#include "core/geometry/numbers.h"
#include "core/geometry/view_matrix.h"

#include <glm/matrix.hpp>

#include <cmath>
#include <initializer_list>
#include <utility>

namespace unprojector::unproject {
using namespace geometry;
namespace {

/// One direction of the view: its edges in eye space and its size in pixels.
struct Edges {
    double low, high, size;
};

/// The position of the axis in the view, in pixels from the edge `low`: -low size / (high - low).
DoubleDouble axisFromLow(const Edges &e)
{
    return DoubleDouble(-e.low) * e.size / (DoubleDouble(e.high) - e.low);
}

/// Eye units per pixel, at the distance 1 for a perspective: (high - low) / (size n).
DoubleDouble unitsPerPixel(const Edges &e, double n)
{
    return (DoubleDouble(e.high) - e.low) / (DoubleDouble(e.size) * n);
}

glm::dvec3 scaled(const glm::dvec3 &v, const DoubleDouble &factor)
{
    return {(v.x * factor).value, (v.y * factor).value, (v.z * factor).value};
}

void assign(double (&target)[3], const glm::dvec3 &v)
{
    for (int k = 0; k < 3; ++k)
        target[k] = v[k];
}

/// The eye's position and axes in the target space.
struct Axes {
    glm::dvec3 origin{0.0}, x{1.0, 0.0, 0.0}, y{0.0, 1.0, 0.0}, z{0.0, 0.0, 1.0};
};

Result<Axes> axesOf(const LookAt &camera)
{
    const Result<EyeFrame> frame = eyeFrame(camera);
    if (!frame)
        return frame.error();
    return Axes{frame->eye.coordinates(), frame->side.coordinates(), frame->upward.coordinates(),
                (-frame->forward).coordinates()};
}

Result<Axes> axesOf(const glm::dmat4 &eyeFromWorld)
{
    glm::dmat4 turn = eyeFromWorld;
    turn[3] = {0.0, 0.0, 0.0, 1.0};
    const Result<WorldPoint> origin = worldFromEye(eyeFromWorld, EyePoint(0, 0, 0)),
                             x = worldFromEye(turn, EyePoint(1, 0, 0)), y = worldFromEye(turn, EyePoint(0, 1, 0)),
                             z = worldFromEye(turn, EyePoint(0, 0, 1));
    for (const auto *point : {&origin, &x, &y, &z}) {
        if (!*point)
            return point->error();
    }
    return Axes{origin->coordinates(), x->coordinates(), y->coordinates(), z->coordinates()};
}

Result<Axes> axesIn(const BatchSpace &space, const Setup &setup)
{
    if (space.kind == BatchSpace::Kind::Eye)
        return Axes{};
    const Result<Axes> axes = std::visit([](const auto &view) { return axesOf(view); }, setup.pose);
    if (!axes || space.kind == BatchSpace::Kind::World)
        return axes;
    const glm::dmat4 objectFromWorld = glm::inverse(space.worldFromObject.rounded());
    if (!isFinite(objectFromWorld))
        return Error{ErrorCode::SingularMatrix};
    const auto placed = [&](const glm::dvec3 &v, double w) { return glm::dvec3(objectFromWorld * glm::dvec4(v, w)); };
    return Axes{placed(axes->origin, 1.0), placed(axes->x, 0.0), placed(axes->y, 0.0), placed(axes->z, 0.0)};
}

/// Sets the position of the view axis, counted from the top left corner.
/// @param fromLeft, fromBottom  of the viewport, pixels
void setAxis(batch::ClosedFormConstants &c, const Setup &g, const DoubleDouble &fromLeft,
             const DoubleDouble &fromBottom)
{
    const DoubleDouble axisX = g.viewport.x + fromLeft;
    const DoubleDouble axisY = flippedY(g.surface, g.viewport.y + fromBottom);
    c.axisX = axisX.value;
    c.axisXRest = axisX.rest;
    c.axisY = axisY.value;
    c.axisYRest = axisY.rest;
}

Result<LineConstants> constantsOf(const Projection &projection, const Setup &g, const Axes &axes)
{
    if (const Check valid = check(projection); !valid)
        return valid.error();
    const ProjectionWindow w = projectionWindow(projection);
    const double thickness = g.depthRange.atFar - g.depthRange.atNear;
    const Edges horizontal{w.left, w.right, g.viewport.width}, vertical{w.bottom, w.top, g.viewport.height};

    LineConstants result;
    result.perspective = isPerspective(projection);
    batch::ClosedFormConstants &c = result.numbers;
    c.depthAtNear = g.depthRange.atNear;
    c.depthAtFar = g.depthRange.atFar;
    c.nearTerm = result.perspective ? w.nearDistance * thickness : w.nearDistance / thickness;
    c.farTerm = result.perspective ? w.nearDistance / w.farDistance : w.farDistance / thickness;
    setAxis(c, g, axisFromLow(horizontal), axisFromLow(vertical));
    const double n = result.perspective ? w.nearDistance : 1.0;
    assign(c.across, scaled(axes.x, unitsPerPixel(horizontal, n)));
    assign(c.down, scaled(w.skew * axes.x - axes.y, unitsPerPixel(vertical, n)));
    glm::dvec3 ahead = -axes.z;
    if (const auto *oblique = std::get_if<Oblique>(&projection)) {
        for (int k = 0; k < 3; ++k) {
            ahead[k] += (cotangent(oblique->theta) * DoubleDouble(axes.x[k])
                         + cotangent(oblique->phi) * DoubleDouble(axes.y[k]))
                            .value;
        }
    }
    assign(c.ahead, ahead);
    return result;
}

/// The constants from the matrix's own entries:
///
///   z = zOffset / (w z_n + zScale), with w z_n + zScale = P share from near + Q share from far
///   P = w + zScale, Q = -w + zScale (or zScale if NDC depths go from 0 to 1)
///
Result<LineConstants> constantsOf(const MatrixProjection &projection, const Setup &g, const Axes &axes)
{
    const Result<RecognisedProjection> form = recognised(projection);
    if (!form)
        return form.error();
    const ProjectionCoefficients &p = form->coefficients;
    const double ndcAtNear = form->ndcDepth == NdcDepth::ZeroToOne ? 0.0 : -1.0;
    const double thickness = g.depthRange.atFar - g.depthRange.atNear;

    LineConstants result;
    result.perspective = p.perspective;
    batch::ClosedFormConstants &c = result.numbers;
    c.depthAtNear = g.depthRange.atNear;
    c.depthAtFar = g.depthRange.atFar;
    if (p.perspective) {
        const double atFar = p.w + p.zScale, atNear = ndcAtNear * p.w + p.zScale;
        c.nearTerm = p.zOffset / atNear * thickness;
        c.farTerm = atFar / atNear;
        if (std::abs(atFar) > std::abs(atNear)) { // reversed: far may be at infinity there, and atNear 0
            std::swap(c.depthAtNear, c.depthAtFar);
            c.nearTerm = -p.zOffset / atFar * thickness;
            c.farTerm = atNear / atFar;
        }
    } else {
        c.nearTerm = p.side * (ndcAtNear * p.w - p.zOffset) / p.zScale / thickness;
        c.farTerm = p.side * (p.w - p.zOffset) / p.zScale / thickness;
    }
    // w x_n = -xOffset on the axis, and x_n = 2 x_v / width - 1.
    const auto fromLow = [&](double offset, double size) { return (DoubleDouble(p.w) - offset) * (size / 2.0) / p.w; };
    setAxis(c, g, fromLow(p.xOffset, g.viewport.width), fromLow(p.yOffset, g.viewport.height));
    assign(c.across, scaled(axes.x, 2.0 * p.w / (DoubleDouble(g.viewport.width) * p.xScale)));
    assign(c.down,
           scaled(p.xSkew / p.xScale * axes.x - axes.y, 2.0 * p.w / (DoubleDouble(g.viewport.height) * p.yScale)));
    glm::dvec3 ahead = axes.z;
    if (!p.perspective)
        ahead -= p.xShear / p.xScale * axes.x + p.yShear / p.yScale * axes.y;
    assign(c.ahead, p.side * ahead);
    return result;
}

/// The first error of the preconditions of both methods.
Check checkTarget(const Setup &setup)
{
    for (const Check &valid : {check(setup.surface), check(setup.viewport), check(setup.depthRange)}) {
        if (!valid)
            return valid;
    }
    return std::monostate{};
}

} // namespace

Result<LineConstants> lineConstants(const Setup &setup, const BatchSpace &space)
{
    if (const Check valid = checkTarget(setup); !valid)
        return valid.error();
    const Result<Axes> axes = axesIn(space, setup);
    if (!axes)
        return axes.error();
    const auto constants = std::visit([&](const auto &p) { return constantsOf(p, setup, *axes); }, setup.lens);
    if (!constants)
        return constants.error();
    LineConstants result = *constants;
    batch::ClosedFormConstants &c = result.numbers;
    assign(c.origin, axes->origin);
    if (!isFinite({c.axisX, c.axisY, c.axisXRest, c.axisYRest, c.nearTerm, c.farTerm}) || !isFinite(c.origin)
        || !isFinite(c.ahead) || !isFinite(c.across) || !isFinite(c.down))
        return Error{ErrorCode::NotFinite};
    return result;
}

Result<glm::dmat4> spaceFromDevice(const Setup &setup, const BatchSpace &space)
{
    if (const Check valid = checkTarget(setup); !valid)
        return valid.error();
    const Result<glm::dmat4> projection = clipFromEye(setup);
    if (!projection)
        return projection.error();
    glm::dmat4 clipFromSpace = *projection;
    if (space.kind != BatchSpace::Kind::Eye) {
        const Result<glm::dmat4> view = eyeFromWorld(setup);
        if (!view)
            return view.error();
        clipFromSpace = clipFromSpace * *view;
    }
    if (space.kind == BatchSpace::Kind::Object)
        clipFromSpace = clipFromSpace * space.worldFromObject.rounded();

    // NDC of a device position: the viewport's inverse, exact if the window's numbers are whole.
    const Viewport &v = setup.viewport;
    const double centreX = v.x + v.width / 2.0;
    const double centreY = flippedY(setup.surface, v.y + v.height / 2.0);
    const double thickness = setup.depthRange.atFar - setup.depthRange.atNear;
    const bool zeroToOne = ndcDepthOf(setup) == NdcDepth::ZeroToOne;
    const glm::dvec3 scale(2.0 / v.width, -2.0 / v.height, (zeroToOne ? 1.0 : 2.0) / thickness);
    const double atNear = setup.depthRange.atNear, atFar = setup.depthRange.atFar;
    const double offsetZ = -(zeroToOne ? atNear : atFar + atNear) / thickness;
    glm::dmat4 ndcFromDevice(1.0);
    for (int k = 0; k < 3; ++k)
        ndcFromDevice[k][k] = scale[k];
    ndcFromDevice[3] = {-centreX * scale.x, -centreY * scale.y, offsetZ, 1.0};

    const glm::dmat4 inverse = glm::inverse(clipFromSpace) * ndcFromDevice;
    if (!isFinite(inverse))
        return Error{ErrorCode::SingularMatrix};
    return inverse;
}

} // namespace unprojector::unproject
