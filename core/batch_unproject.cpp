#include "core/batch_unproject.h"

#include "core/exact_rounding.h"

#include <glm/matrix.hpp>

#include <cmath>
#include <initializer_list>
#include <type_traits>

namespace unprojector {
namespace {

/// A number as the sum of a double and of what that double leaves out.
struct Sum {
    double value, rest;
};

Sum sum(double a, double b)
{
    return {a + b, lostBySum(a, b)};
}

Sum product(double a, double b)
{
    return {a * b, lostByProduct(a, b)};
}

Sum quotient(const Sum &a, const Sum &b)
{
    const double q = a.value / b.value;
    const double remainder = std::fma(-q, b.value, a.value) + (a.rest - q * b.rest);
    return {q, remainder / b.value};
}

/// How one direction of the picture is spread out in eye space: between its edges over so many pixels.
struct Edges {
    double low, high, size;
};

/// Where the axis meets the picture, in pixels from the edge `low`: -low size / (high - low).
Sum axisFromLow(const Edges &e)
{
    return quotient(product(-e.low, e.size), sum(e.high, -e.low));
}

/// Eye units a pixel, at the distance 1 for a perspective: (high - low) / (size n).
Sum unitsPerPixel(const Edges &e, double n)
{
    return quotient(sum(e.high, -e.low), product(e.size, n));
}

glm::dvec3 scaled(const glm::dvec3 &v, const Sum &factor)
{
    return {std::fma(v.x, factor.value, v.x * factor.rest), std::fma(v.y, factor.value, v.y * factor.rest),
            std::fma(v.z, factor.value, v.z * factor.rest)};
}

void assign(double (&target)[3], const glm::dvec3 &v)
{
    for (int k = 0; k < 3; ++k)
        target[k] = v[k];
}

bool isFinite(std::initializer_list<double> values)
{
    for (const double value : values) {
        if (!std::isfinite(value))
            return false;
    }
    return true;
}

bool isFinite(const double (&v)[3])
{
    return isFinite({v[0], v[1], v[2]});
}

bool isFinite(const glm::dmat4 &m)
{
    for (int column = 0; column < 4; ++column) {
        if (!isFinite({m[column].x, m[column].y, m[column].z, m[column].w}))
            return false;
    }
    return true;
}

/// The axes of the eye and its place, in the space asked for.
Result<EyeFrame> frameIn(const BatchSpace &space, const LookAt &camera)
{
    if (space.kind == BatchSpace::Kind::Eye)
        return EyeFrame{WorldPoint(0, 0, 0), {1, 0, 0}, {0, 1, 0}, {0, 0, -1}};
    Result<EyeFrame> frame = eyeFrame(camera);
    if (!frame || space.kind == BatchSpace::Kind::World)
        return frame;
    const glm::dmat4 objectFromWorld = glm::inverse(space.worldFromObject);
    if (!isFinite(objectFromWorld))
        return Error{ErrorCode::SingularMatrix};
    const auto placed = [&](const glm::dvec3 &v, double w) { return glm::dvec3(objectFromWorld * glm::dvec4(v, w)); };
    return EyeFrame{WorldPoint(placed(frame->eye.coordinates(), 1.0)), placed(frame->side, 0.0),
                    placed(frame->upward, 0.0), placed(frame->forward, 0.0)};
}

batch::ClosedFormConstants closedFormConstants(const ViewGeometry &g, const EyeFrame &frame)
{
    const ProjectionWindow w = projectionWindow(g.projection);
    const DepthRange &range = g.depthRange;
    const double thickness = range.atFar - range.atNear;
    const bool perspective = isPerspective(g.projection);
    const Edges horizontal{w.left, w.right, g.viewport.width}, vertical{w.bottom, w.top, g.viewport.height};

    batch::ClosedFormConstants c{};
    c.depthAtNear = range.atNear;
    c.depthAtFar = range.atFar;
    c.nearTerm = perspective ? w.nearDistance * thickness : w.nearDistance / thickness;
    c.farTerm = perspective ? w.nearDistance / w.farDistance : w.farDistance / thickness;

    const Sum fromLeft = axisFromLow(horizontal), fromBottom = axisFromLow(vertical);
    const Sum axisX = sum(g.viewport.x, fromLeft.value);
    const Sum bottomEdge = sum(g.surface.heightPixels, -g.viewport.y); // from the top: y down
    const Sum axisY = sum(bottomEdge.value, -fromBottom.value);
    c.axisX = axisX.value;
    c.axisXRest = axisX.rest + fromLeft.rest;
    c.axisY = axisY.value;
    c.axisYRest = axisY.rest + (bottomEdge.rest - fromBottom.rest);

    const double n = perspective ? w.nearDistance : 1.0;
    assign(c.origin, frame.eye.coordinates());
    assign(c.across, scaled(frame.side, unitsPerPixel(horizontal, n)));
    assign(c.down, scaled(-frame.upward, unitsPerPixel(vertical, n)));
    glm::dvec3 ahead = frame.forward;
    if (const auto *oblique = std::get_if<Oblique>(&g.projection)) {
        for (int k = 0; k < 3; ++k) {
            ahead[k] += sumOfProducts(cotangent(oblique->thetaRadians), frame.side[k],
                                      cotangent(oblique->phiRadians), frame.upward[k]);
        }
    }
    assign(c.ahead, ahead);
    return c;
}

const batch::Kernels &kernels(InstructionSet set)
{
#ifdef UNPROJECTOR_WIDE_KERNELS
    switch (set) {
    case InstructionSet::Avx512: return batch::kAvx512Kernels;
    case InstructionSet::Avx2: return batch::kAvx2Kernels;
    case InstructionSet::Baseline: break;
    }
#else
    static_cast<void>(set);
#endif
    return batch::kBaselineKernels;
}

} // namespace

Result<BatchUnprojection> BatchUnprojection::byFormula(const ViewGeometry &geometry, const BatchSpace &space)
{
    if (const Check valid = check(geometry); !valid)
        return valid.error();
    const Result<EyeFrame> frame = frameIn(space, geometry.camera);
    if (!frame)
        return frame.error();
    const batch::ClosedFormConstants c = closedFormConstants(geometry, *frame);
    if (!isFinite({c.axisX, c.axisY, c.axisXRest, c.axisYRest, c.nearTerm, c.farTerm}) || !isFinite(c.origin)
        || !isFinite(c.ahead) || !isFinite(c.across) || !isFinite(c.down))
        return Error{ErrorCode::NotFinite};
    if (isPerspective(geometry.projection))
        return BatchUnprojection(Constants(Perspective{c}));
    return BatchUnprojection(Constants(Box{c}));
}

Result<BatchUnprojection> BatchUnprojection::byMatrix(const ViewGeometry &geometry, const BatchSpace &space)
{
    if (const Check valid = check(geometry); !valid)
        return valid.error();
    const Result<glm::dmat4> matrix =
        space.kind == BatchSpace::Kind::Eye ? clipFromEye(geometry.projection) : clipFromWorld(geometry);
    if (!matrix)
        return matrix.error();
    glm::dmat4 clipFromSpace = *matrix;
    if (space.kind == BatchSpace::Kind::Object)
        clipFromSpace = clipFromSpace * space.worldFromObject;

    // NDC of a device position: the viewport's inverse, exact where the window's numbers are whole.
    const Viewport &v = geometry.viewport;
    const double centreX = v.x + v.width / 2.0;
    const double centreY = geometry.surface.heightPixels - (v.y + v.height / 2.0);
    const double thickness = geometry.depthRange.atFar - geometry.depthRange.atNear;
    const glm::dvec3 scale(2.0 / v.width, -2.0 / v.height, 2.0 / thickness);
    const double offsetZ = -(geometry.depthRange.atFar + geometry.depthRange.atNear) / thickness;
    glm::dmat4 ndcFromDevice(1.0);
    for (int k = 0; k < 3; ++k)
        ndcFromDevice[k][k] = scale[k];
    ndcFromDevice[3] = {-centreX * scale.x, -centreY * scale.y, offsetZ, 1.0};

    const glm::dmat4 inverse = glm::inverse(clipFromSpace) * ndcFromDevice;
    if (!isFinite(inverse))
        return Error{ErrorCode::SingularMatrix};
    batch::MatrixConstants constants{};
    for (int row = 0; row < 4; ++row) {
        for (int column = 0; column < 4; ++column)
            constants.rows[row][column] = inverse[column][row];
    }
    return BatchUnprojection(Constants(constants));
}

template <class Scalar>
void BatchUnprojection::operator()(const BatchInput<Scalar> &input, const BatchOutput<Scalar> &output,
                                   std::size_t count, InstructionSet set) const
{
    const auto run = [&](const batch::KernelsOf<Scalar> &k) {
        const auto call = [&](auto kernel, const auto &constants) {
            kernel(constants, input.px, input.py, input.depth, output.x, output.y, output.z, count);
        };
        if (const auto *perspective = std::get_if<Perspective>(&m_constants))
            call(k.perspective, *perspective);
        else if (const auto *box = std::get_if<Box>(&m_constants))
            call(k.box, *box);
        else
            call(k.matrix, *std::get_if<batch::MatrixConstants>(&m_constants));
    };
    if constexpr (std::is_same_v<Scalar, double>)
        run(kernels(set).ofDoubles);
    else
        run(kernels(set).ofFloats);
}

template void BatchUnprojection::operator()<double>(const BatchInput<double> &, const BatchOutput<double> &,
                                                    std::size_t, InstructionSet) const;
template void BatchUnprojection::operator()<float>(const BatchInput<float> &, const BatchOutput<float> &, std::size_t,
                                                   InstructionSet) const;

} // namespace unprojector
