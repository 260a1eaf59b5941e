#include "core/unproject/batch/click_batch.h"

#include "core/geometry/condition_number.h"
#include "core/geometry/view_matrix.h"

#include <glm/matrix.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace unprojector::unproject {
using namespace geometry;

namespace {

using batch::Twofold;

Twofold twofold(const DoubleDouble &number)
{
    const Halves halves(number.value);
    return {number.value, number.rest, halves.high, halves.low};
}

void assign(Twofold (&target)[3], const DoubleDouble3 &v)
{
    for (std::size_t k = 0; k < 3; ++k)
        target[k] = twofold(v[k]);
}

DoubleDouble3 scaled(const DoubleDouble3 &v, const DoubleDouble &factor)
{
    return {v[0] * factor, v[1] * factor, v[2] * factor};
}

DoubleDouble3 sum(const DoubleDouble3 &a, const DoubleDouble3 &b)
{
    return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}

double size(const DoubleDouble3 &v)
{
    return std::max({std::abs(v[0].value), std::abs(v[1].value), std::abs(v[2].value)});
}

PreciseAxes axesOf(const LookAt &camera)
{
    const PreciseEyeFrame frame = preciseEyeFrame(camera).value(); // the batch has checked it
    return {{frame.eye.x, frame.eye.y, frame.eye.z},
            frame.side,
            frame.upward,
            {-frame.forward[0], -frame.forward[1], -frame.forward[2]}};
}

PreciseAxes axesOf(const glm::dmat4 &eyeFromWorld)
{
    return preciseAxes(eyeFromWorld).value();
}

/// A lens in pixels: the linear coefficients of formulas (9) to (12).
struct PixelLens {
    bool isPerspective = true;
    DoubleDouble axisX, axisY;      ///< window position of the view axis
    DoubleDouble acrossX, upY;      ///< eye units per pixel, at the distance 1 for a perspective
    DoubleDouble aheadX, aheadY;    ///< sideways shift per unit along the axis
    DoubleDouble skew;              ///< shift to the left per unit up
    double side = -1.0;             ///< z_eye = side z
    double depthAtNear, depthAtFar; ///< in the order of the terms below
    DoubleDouble nearTerm, farTerm;
};

PixelLens pixelLens(const Projection &projection, const Setup &g)
{
    const ProjectionWindow w = projectionWindow(projection);
    const auto &[left, right, bottom, top, skew] = preciseEdges(projection);
    const DoubleDouble n = w.nearDistance, f = w.farDistance;
    const DoubleDouble thickness = DoubleDouble(g.depthRange.atFar) - g.depthRange.atNear;
    PixelLens lens;
    lens.isPerspective = isPerspective(projection);
    const DoubleDouble scale = lens.isPerspective ? n : DoubleDouble(1.0);
    lens.axisX = g.viewport.x - left * g.viewport.width / (right - left);
    lens.axisY = g.viewport.y - bottom * g.viewport.height / (top - bottom);
    lens.acrossX = (right - left) / (g.viewport.width * scale);
    lens.upY = (top - bottom) / (g.viewport.height * scale);
    lens.skew = skew;
    if (const auto *oblique = std::get_if<Oblique>(&projection)) {
        lens.aheadX = preciseCotangent(oblique->theta);
        lens.aheadY = preciseCotangent(oblique->phi);
    }
    lens.depthAtNear = g.depthRange.atNear;
    lens.depthAtFar = g.depthRange.atFar;
    lens.nearTerm = lens.isPerspective ? n * thickness : n / thickness;
    lens.farTerm = lens.isPerspective ? n / f : f / thickness;
    return lens;
}

/// The lens from the matrix's own entries, see BatchUnprojection.
PixelLens pixelLens(const MatrixProjection &projection, const Setup &g)
{
    const RecognisedProjection form = recognised(projection).value(); // the batch has checked it
    const ProjectionCoefficients &c = form.coefficients;
    const DoubleDouble thickness = DoubleDouble(g.depthRange.atFar) - g.depthRange.atNear;
    const double ndcAtNear = form.ndcDepth == NdcDepth::ZeroToOne ? 0.0 : -c.w;
    PixelLens lens;
    lens.isPerspective = c.perspective;
    lens.side = c.side;
    lens.axisX = g.viewport.x + (DoubleDouble(c.w) - c.xOffset) * g.viewport.width / (2.0 * DoubleDouble(c.w));
    lens.axisY = g.viewport.y + (DoubleDouble(c.w) - c.yOffset) * g.viewport.height / (2.0 * DoubleDouble(c.w));
    lens.acrossX = 2.0 * DoubleDouble(c.w) / (DoubleDouble(g.viewport.width) * c.xScale);
    lens.upY = 2.0 * DoubleDouble(c.w) / (DoubleDouble(g.viewport.height) * c.yScale);
    lens.skew = c.xSkew / DoubleDouble(c.xScale);
    lens.depthAtNear = g.depthRange.atNear;
    lens.depthAtFar = g.depthRange.atFar;
    if (!c.perspective) {
        lens.aheadX = -c.side * c.xShear / DoubleDouble(c.xScale);
        lens.aheadY = -c.side * c.yShear / DoubleDouble(c.yScale);
        lens.nearTerm = c.side * (DoubleDouble(ndcAtNear) - c.zOffset) / c.zScale / thickness;
        lens.farTerm = c.side * (DoubleDouble(c.w) - c.zOffset) / c.zScale / thickness;
        return lens;
    }
    const DoubleDouble atNear = DoubleDouble(ndcAtNear) + c.zScale, atFar = DoubleDouble(c.w) + c.zScale;
    const bool isTurnedRound = std::abs(atFar.value) > std::abs(atNear.value); // far may be at infinity, and atNear 0
    if (isTurnedRound)
        std::swap(lens.depthAtNear, lens.depthAtFar);
    lens.nearTerm = c.zOffset * (isTurnedRound ? -thickness : thickness) / (isTurnedRound ? atFar : atNear);
    lens.farTerm = isTurnedRound ? atNear / atFar : atFar / atNear;
    return lens;
}

/// The eye's position and axes in an object's space.
PreciseAxes placed(const PreciseAxes &axes, const ObjectFromWorld &object)
{
    const auto &origin = object.worldFromObject().columns[3];
    const DoubleDouble3 fromOrigin{axes.origin[0] - origin[0], axes.origin[1] - origin[1], axes.origin[2] - origin[2]};
    const PreciseMatrix &m = object.matrix();
    return {m.turned(fromOrigin), m.turned(axes.x), m.turned(axes.y), m.turned(axes.z)};
}

/// The sizes of the terms that a target space is computed from.
struct TermSizes {
    double origin; ///< of the terms that sum up to the eye's position
    double axes;   ///< of those that sum up to its axes
};

TermSizes termSizes(const PreciseAxes &inWorld, const std::optional<ObjectFromWorld> &object)
{
    const double largest = std::max({size(inWorld.x), size(inWorld.y), size(inWorld.z)});
    if (!object)
        return {size(inWorld.origin), largest};
    double entries = 0.0;
    for (std::size_t c = 0; c < 3; ++c) {
        const auto &column = object->matrix().columns[c];
        entries += size({column[0], column[1], column[2]});
    }
    const auto &origin = object->worldFromObject().columns[3];
    return {entries * (size(inWorld.origin) + size({origin[0], origin[1], origin[2]})), entries * largest};
}

batch::PreciseConstants constantsOf(const PixelLens &lens, const PreciseAxes &axes, const TermSizes &sizes,
                                    const Setup &g)
{
    const DoubleDouble3 across = scaled(axes.x, lens.acrossX);
    const DoubleDouble3 up = scaled(sum(axes.y, scaled(axes.x, -lens.skew)), lens.upY);
    const DoubleDouble3 ahead =
        sum(scaled(axes.z, lens.side), sum(scaled(axes.x, lens.aheadX), scaled(axes.y, lens.aheadY)));
    batch::PreciseConstants c{};
    c.axisX = twofold(lens.axisX);
    c.axisY = twofold(flippedY(g.surface, lens.axisY));
    c.depthAtNear = lens.depthAtNear;
    c.depthAtFar = lens.depthAtFar;
    c.nearTerm = twofold(lens.nearTerm);
    c.farTerm = twofold(lens.farTerm);
    assign(c.origin, axes.origin);
    assign(c.ahead, ahead);
    assign(c.across, across);
    assign(c.up, up);

    // A click counts from the viewport's edge, which sets the size of its sums.
    const auto fromEdge = [](const DoubleDouble &axis, double edge, double extent) {
        return std::max(std::abs(axis.value - edge), std::abs(axis.value - edge - extent)) + std::abs(edge);
    };
    constexpr double kTiny = 0x1p-900; // below this, products of rests underflow
    const double aheadSize = sizes.axes * (1.0 + std::abs(lens.aheadX.value) + std::abs(lens.aheadY.value));
    c.acrossSize = sizes.axes * std::abs(lens.acrossX.value);
    c.upSize = sizes.axes * std::abs(lens.upY.value) * (1.0 + std::abs(lens.skew.value));
    c.originSize = sizes.origin + kTiny;
    c.reach = aheadSize + c.acrossSize * fromEdge(lens.axisX, g.viewport.x, g.viewport.width)
              + c.upSize * (fromEdge(lens.axisY, g.viewport.y, g.viewport.height) + g.surface.heightPixels);
    if (!lens.isPerspective) {
        const double thickness = std::abs(g.depthRange.atFar - g.depthRange.atNear);
        c.reach += 2.0 * aheadSize * (std::abs(lens.nearTerm.value) + std::abs(lens.farTerm.value)) * thickness;
    }
    return c;
}

/// The click's answer at a window position; NaN if it has none.
glm::dvec3 clicked(const Unprojector &unprojector, BatchSpace::Kind space, Method method,
                   const Unprojector::PreciseWindow &window, const std::optional<ObjectFromWorld> &object = {})
{
    const auto coordinates = [](const auto &point) {
        return point ? point->coordinates() : glm::dvec3(std::numeric_limits<double>::quiet_NaN());
    };
    if (object)
        return coordinates(unprojector.objectAt(method, window, *object));
    return space == BatchSpace::Kind::Eye ? coordinates(unprojector.eyeAt(method, window))
                                          : coordinates(unprojector.worldAt(method, window));
}

void put(const glm::dvec3 &point, const BatchOutput<double> &output, std::size_t i)
{
    output.x[i] = point.x;
    output.y[i] = point.y;
    output.z[i] = point.z;
}

Unprojector::PreciseWindow windowOf(const Unprojector &unprojector, const BatchInput<double> &input, std::size_t i)
{
    return preciseWindowFromDevice(unprojector.setup().surface, DevicePoint(input.px[i], input.py[i]), input.depth[i]);
}

} // namespace

Result<ClickBatch> ClickBatch::byFormula(const Unprojector &unprojector, BatchSpace::Kind space,
                                         const std::optional<ObjectFromWorld> &object)
{
    const Setup &setup = unprojector.setup();
    if (const Result<BatchUnprojection> plain = BatchUnprojection::byFormula(setup, {space, {}}); !plain)
        return plain.error();
    PreciseAxes axes{{}, {1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}};
    if (space != BatchSpace::Kind::Eye)
        axes = std::visit([](const auto &view) { return axesOf(view); }, setup.pose);
    const PixelLens lens = std::visit([&](const auto &projection) { return pixelLens(projection, setup); }, setup.lens);
    const TermSizes sizes = termSizes(axes, object);
    if (object)
        axes = placed(axes, *object);
    const batch::PreciseConstants constants = constantsOf(lens, axes, sizes, setup);
    return ClickBatch([=, isPerspective = lens.isPerspective](const BatchInput<double> &input,
                                                              const BatchOutput<double> &output, std::size_t count,
                                                              InstructionSet set) {
        const batch::ClickKernels &loops = batch::kernelsOf(set).clicks;
        const batch::PreciseKernel loop = isPerspective ? loops.perspective : loops.box;
        std::array<double, 1024> doubt;
        for (std::size_t begin = 0; begin < count; begin += doubt.size()) {
            const std::size_t part = std::min(doubt.size(), count - begin);
            loop(constants, input.px + begin, input.py + begin, input.depth + begin, output.x + begin, output.y + begin,
                 output.z + begin, doubt.data(), part);
            for (std::size_t k = 0; k < part; ++k) {
                const std::size_t i = begin + k;
                if (doubt[k] != 0.0)
                    put(clicked(unprojector, space, Method::Formula, windowOf(unprojector, input, i), object), output,
                        i);
            }
        }
    });
}

Result<ClickBatch> ClickBatch::byMatrix(const Setup &setup, BatchSpace::Kind space)
{
    if (const Result<BatchUnprojection> plain = BatchUnprojection::byMatrix(setup, {space, {}}); !plain)
        return plain.error();
    glm::dmat4 clipFromSpace = clipFromEye(setup).value();
    if (space != BatchSpace::Kind::Eye)
        clipFromSpace = clipFromSpace * eyeFromWorld(setup).value();
    if (isSingular(clipFromSpace))
        return Error{ErrorCode::SingularMatrix};
    const bool zeroToOne = ndcDepthOf(setup) == NdcDepth::ZeroToOne;
    const Viewport &v = setup.viewport;
    batch::ClickMatrixConstants c{double(setup.surface.heightPixels),
                                  v.x,
                                  v.y,
                                  v.width,
                                  v.height,
                                  setup.depthRange.atNear,
                                  setup.depthRange.atFar - setup.depthRange.atNear,
                                  zeroToOne ? 1.0 : 2.0,
                                  zeroToOne ? 0.0 : 1.0,
                                  {}};
    const glm::dmat4 inverse = glm::inverse(clipFromSpace);
    for (int row = 0; row < 4; ++row) {
        for (int column = 0; column < 4; ++column)
            c.rows[row][column] = inverse[column][row];
    }
    return ClickBatch([c](const BatchInput<double> &input, const BatchOutput<double> &output, std::size_t count,
                          InstructionSet set) {
        batch::kernelsOf(set).clicks.matrix(c, input.px, input.py, input.depth, output.x, output.y, output.z, count);
    });
}

Result<ClickBatch> ClickBatch::of(Method method, const Setup &setup, const BatchSpace &space)
{
    const Result<Unprojector> unprojector = Unprojector::of(setup);
    if (!unprojector)
        return unprojector.error();
    const bool isOfObject = space.kind == BatchSpace::Kind::Object;
    const BatchSpace::Kind kind = isOfObject ? BatchSpace::Kind::World : space.kind;
    std::optional<ObjectFromWorld> object;
    if (isOfObject) {
        const Result<ObjectFromWorld> prepared = ObjectFromWorld::of(space.worldFromObject);
        if (!prepared)
            return prepared.error();
        object = *prepared;
    }
    const auto batchBy = [&]() -> Result<ClickBatch> {
        switch (method) {
        case Method::Formula: return byFormula(*unprojector, kind, object);
        case Method::Matrix: return byMatrix(setup, kind);
        case Method::MatrixInFloat: break;
        }
        if (const Result<ClickBatch> inDouble = byMatrix(setup, kind); !inDouble)
            return inDouble.error();
        return ClickBatch([click = *unprojector, kind, method](const BatchInput<double> &input,
                                                               const BatchOutput<double> &output, std::size_t count,
                                                               InstructionSet) {
            for (std::size_t i = 0; i < count; ++i)
                put(clicked(click, kind, method, windowOf(click, input, i)), output, i);
        });
    };
    const Result<ClickBatch> batch = batchBy();
    if (!batch || method == Method::Formula)
        return batch;
    ClickBatch withObject = *batch;
    withObject.m_object = object;
    return withObject;
}

void ClickBatch::operator()(const BatchInput<double> &input, const BatchOutput<double> &output, std::size_t count,
                            InstructionSet set) const
{
    m_loop(input, output, count, set);
    for (std::size_t i = 0; m_object && i < count; ++i) {
        const Result<ObjectPoint> point = m_object->at(WorldPoint(output.x[i], output.y[i], output.z[i]));
        put(point ? point->coordinates() : glm::dvec3(std::numeric_limits<double>::quiet_NaN()), output, i);
    }
}

} // namespace unprojector::unproject
