#include "core/geometry/matrix_projection.h"

#include "core/geometry/condition_number.h"
#include "core/geometry/finite.h"

#include <glm/matrix.hpp>

#include <charconv>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace unprojector::geometry {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

Error entryError(const glm::dmat4 &m, int column, int row)
{
    return {ErrorCode::MatrixNotAProjection, m[column][row], double(column * 4 + row)};
}

/// True if the whole depth range lies in front of the eye; a far plane at infinity counts as in
/// front.
bool isInFront(const ProjectionCoefficients &c, NdcDepth depth)
{
    if (!c.perspective)
        return true;
    return c.zOffset < 0.0 ? c.zScale <= -c.w : c.zScale >= (depth == NdcDepth::ZeroToOne ? 0.0 : c.w);
}

/// The coefficients of a matrix with the zeros of its form; `w` may have either sign.
ProjectionCoefficients coefficientsWithSign(const glm::dmat4 &m)
{
    ProjectionCoefficients c;
    c.perspective = m[2][3] != 0.0;
    if (c.perspective) {
        c.w = std::abs(m[2][3]);
        c.side = m[2][3] < 0.0 ? -1.0 : 1.0;
        c.xOffset = -c.side * m[2][0];
        c.yOffset = -c.side * m[2][1];
        c.zScale = -c.side * m[2][2];
        c.xSkew = m[1][0];
    } else {
        c.w = m[3][3];
        c.xOffset = -m[3][0];
        c.yOffset = -m[3][1];
        c.xShear = m[2][0];
        c.yShear = m[2][1];
        c.zScale = m[2][2];
    }
    c.xScale = m[0][0];
    c.yScale = m[1][1];
    c.zOffset = m[3][2];
    // A far plane behind infinity is one at infinity after rounding, by at most as much as single
    // precision does.
    constexpr double kBehindInfinity = 0x1p-21;
    if (c.perspective && c.zOffset < 0.0 && c.zScale > -c.w && c.zScale <= -c.w * (1.0 - kBehindInfinity))
        c.zScale = -c.w;
    return c;
}

/// Returns whether all signs are turned: then w is negative in front of the eye.
bool isNegated(const ProjectionCoefficients &c)
{
    return c.perspective ? !isInFront(c, NdcDepth::MinusOneToOne) && !isInFront(c, NdcDepth::ZeroToOne) : c.w < 0.0;
}

Result<ProjectionCoefficients> coefficientsOf(const glm::dmat4 &m)
{
    if (const Check finite = checkFinite(m); !finite)
        return finite.error();
    if (std::isinf(conditionNumber(m)))
        return Error{ErrorCode::SingularMatrix};
    // The entries (column, row) that are 0 in every matrix of these forms, and further ones of each form.
    std::vector<std::pair<int, int>> zeros{{0, 1}, {0, 2}, {1, 2}, {0, 3}, {1, 3}};
    if (m[2][3] != 0.0)
        zeros.insert(zeros.end(), {{3, 0}, {3, 1}, {3, 3}});
    else
        zeros.push_back({1, 0});
    for (const auto &[column, row] : zeros) {
        if (m[column][row] != 0.0)
            return entryError(m, column, row);
    }
    const ProjectionCoefficients c = coefficientsWithSign(m);
    return isNegated(c) ? coefficientsWithSign(glm::dmat4(0.0) - m) : c;
}

/// The same matrix with w = 1.
ProjectionCoefficients scaledToOne(ProjectionCoefficients c)
{
    for (double *number :
         {&c.xScale, &c.yScale, &c.xOffset, &c.yOffset, &c.xSkew, &c.xShear, &c.yShear, &c.zScale, &c.zOffset})
        *number /= c.w;
    c.w = 1.0;
    return c;
}

double roundedTo(double value, int digits)
{
    char text[40];
    const auto written = std::to_chars(text, text + sizeof text, value, std::chars_format::scientific, digits - 1);
    double rounded = value;
    std::from_chars(text, written.ptr, rounded);
    return rounded;
}

/// Replaces two numbers by the ones with the fewest digits that still fit. Returns whether any do.
template <class Fits>
bool shorten(double &a, double &b, const Fits &fits)
{
    constexpr int kMostDigits = 17;
    for (int sum = 2; sum <= 2 * kMostDigits; ++sum) {
        for (int digits = std::max(1, sum - kMostDigits); digits < sum && digits <= kMostDigits; ++digits) {
            const double shortA = roundedTo(a, digits);
            const double shortB = std::isinf(b) ? b : roundedTo(b, sum - digits);
            if (fits(shortA, shortB)) {
                a = shortA;
                b = shortB;
                return true;
            }
        }
    }
    return fits(a, b);
}

/// Compares with a number of a matrix in the precision in which the matrix was computed.
struct Same {
    bool single;
    bool operator()(double computed, double entry) const
    {
        return single ? static_cast<float>(computed) == static_cast<float>(entry) : computed == entry;
    }
};

Same sameAs(const glm::dmat4 &m)
{
    for (int i = 0; i < 16; ++i) {
        const double entry = m[i / 4][i % 4];
        if (std::abs(entry) <= double(std::numeric_limits<float>::max()) && double(float(entry)) != entry)
            return {false};
    }
    return {true};
}

/// Sets the near and far of a perspective; far may be infinite.
void readDistances(const ProjectionCoefficients &c, RecognisedProjection &result, double &n, double &f,
                   const Same &same)
{
    const bool zeroToOne = result.ndcDepth == NdcDepth::ZeroToOne;
    result.reversed = c.zOffset > 0.0;
    const double low = zeroToOne ? 0.0 : -1.0; // the NDC depth of the end that is not 1
    n = c.zOffset / (c.zScale + (result.reversed ? 1.0 : low));
    const double farDenominator = c.zScale + (result.reversed ? low : 1.0);
    result.infiniteFar = farDenominator == 0.0;
    f = result.infiniteFar ? kInfinity : c.zOffset / farDenominator;
    const double sign = result.reversed ? -1.0 : 1.0;
    const auto fits = [&](double a, double b) {
        double scale = -1.0, offset = zeroToOne ? -a : -2.0 * a;
        if (std::isinf(b)) {
            // Far at infinity: the scale is -1, reversed 1, reversed in [0, 1] it is 0.
            if (result.reversed)
                return same(zeroToOne ? a : 2.0 * a, c.zOffset);
            return same(scale, c.zScale) && same(offset, c.zOffset);
        }
        if (!(a > 0.0 && a < b))
            return false;
        if (!zeroToOne) {
            scale = -(b + a) / (b - a);
            offset = -2.0 * b * a / (b - a);
        } else if (result.reversed) {
            scale = -a / (b - a);
            offset = -(b * a) / (b - a);
        } else {
            scale = -b / (b - a);
            offset = -(b * a) / (b - a);
        }
        return same(sign * scale, c.zScale) && same(sign * offset, c.zOffset);
    };
    result.exact &= shorten(n, f, fits);
}

/// Sets left and right (or bottom and top) on the near plane of a perspective, or of a box.
void readEdges(double scale, double offset, double n, double &low, double &high, bool perspective, const Same &same,
               bool &exact)
{
    const double size = perspective ? n : 1.0;
    low = size * (offset - 1.0) / scale;
    high = size * (offset + 1.0) / scale;
    const auto fits = [&](double a, double b) {
        const double made = perspective ? 2.0 * n / (b - a) : 2.0 / (b - a);
        return a != b && same(made, scale) && same((b + a) / (b - a), offset);
    };
    exact &= shorten(low, high, fits);
}

RecognisedProjection readPerspective(const ProjectionCoefficients &c, NdcDepth depth, const Same &same)
{
    RecognisedProjection result;
    result.ndcDepth = depth;
    result.exact = true;
    result.looksAlongPlusZ = c.side > 0.0;
    Frustum p;
    readDistances(c, result, p.nearDistance, p.farDistance, same);
    readEdges(c.xScale, c.xOffset, p.nearDistance, p.left, p.right, true, same, result.exact);
    readEdges(c.yScale, c.yOffset, p.nearDistance, p.bottom, p.top, true, same, result.exact);
    if (c.xSkew != 0.0) {
        double none = 0.0;
        p.skew = c.xSkew / c.xScale;
        result.exact &= shorten(p.skew, none, [&](double skew, double) { return same(c.xScale * skew, c.xSkew); });
    }
    result.parameters = p;
    return result;
}

RecognisedProjection readBox(const ProjectionCoefficients &c, NdcDepth depth, const Same &same)
{
    RecognisedProjection result;
    result.ndcDepth = depth;
    result.exact = true;
    Ortho box;
    const bool zeroToOne = depth == NdcDepth::ZeroToOne;
    result.reversed = c.zScale > 0.0;
    const double sign = result.reversed ? -1.0 : 1.0;
    const double low = zeroToOne ? 0.0 : -1.0;
    box.nearDistance = (c.zOffset - (result.reversed ? 1.0 : low)) / c.zScale;
    box.farDistance = (c.zOffset - (result.reversed ? low : 1.0)) / c.zScale;
    const auto fits = [&](double n, double f) {
        if (!(n < f))
            return false;
        const double scale = sign * (zeroToOne ? -1.0 : -2.0) / (f - n);
        const double offset = !zeroToOne ? sign * -(f + n) / (f - n) : result.reversed ? f / (f - n) : -n / (f - n);
        return same(scale, c.zScale) && same(offset, c.zOffset);
    };
    result.exact &= shorten(box.nearDistance, box.farDistance, fits);
    readEdges(c.xScale, c.xOffset, 1.0, box.left, box.right, false, same, result.exact);
    readEdges(c.yScale, c.yOffset, 1.0, box.bottom, box.top, false, same, result.exact);
    if (c.xShear == 0.0 && c.yShear == 0.0) {
        result.parameters = box;
        return result;
    }
    // An angle is only as exact as its cotangent.
    const double cotTheta = c.xShear / c.xScale, cotPhi = c.yShear / c.yScale;
    constexpr double kQuarterTurn = 1.5707963267948966;
    const Oblique oblique{box, cotTheta == 0.0 ? kQuarterTurn : std::atan2(1.0, cotTheta),
                          cotPhi == 0.0 ? kQuarterTurn : std::atan2(1.0, cotPhi)};
    result.exact &=
        same(cotangent(oblique.theta) * c.xScale, c.xShear) && same(cotangent(oblique.phi) * c.yScale, c.yShear);
    result.parameters = oblique;
    return result;
}

/// (w x_n + offset) / scale with x_n = (2 (x_v - vx) - size) / size.
DoubleDouble centredAndScaled(const DoubleDouble &position, double origin, double size, double w, double offset,
                              double scale)
{
    const DoubleDouble centred = 2.0 * (position - origin) - size;
    return (w * centred / size + offset) / scale;
}

/// The depth convention that puts the depth range in front of the eye. Where none is given, it is
/// chosen as MatrixProjection::ndcDepth describes.
Result<NdcDepth> chosenDepth(const MatrixProjection &projection, const ProjectionCoefficients &c)
{
    if (projection.ndcDepth) {
        if (isInFront(c, *projection.ndcDepth))
            return *projection.ndcDepth;
    } else {
        for (const NdcDepth depth : {NdcDepth::MinusOneToOne, NdcDepth::ZeroToOne}) {
            if (isInFront(c, depth))
                return depth;
        }
    }
    return entryError(projection.clipFromEye, 2, 2);
}

} // namespace

Result<RecognisedProjection> recognised(const MatrixProjection &projection)
{
    const Result<ProjectionCoefficients> c = coefficientsOf(projection.clipFromEye);
    if (!c)
        return c.error();
    const Result<NdcDepth> depth = chosenDepth(projection, *c);
    if (!depth)
        return depth.error();
    const Same same = sameAs(projection.clipFromEye);
    const ProjectionCoefficients one = scaledToOne(*c);
    RecognisedProjection result = one.perspective ? readPerspective(one, *depth, same) : readBox(one, *depth, same);
    result.coefficients = *c;
    result.negated = isNegated(coefficientsWithSign(projection.clipFromEye));
    return result;
}

double wInFront(const MatrixProjection &projection)
{
    constexpr double kRounding = 1e-12;
    const glm::dmat4 inverse = glm::inverse(projection.clipFromEye);
    const double low = ndcDepthOf(projection) == NdcDepth::ZeroToOne ? 0.0 : -1.0;
    // 1 / w at the ends of the view's axis
    const double first = inverse[2][3] * low + inverse[3][3], second = inverse[2][3] + inverse[3][3];
    const double larger = std::abs(first) > std::abs(second) ? first : second;
    const double smaller = larger == first ? second : first;
    const bool haveOneSign = smaller / larger > -kRounding;
    return haveOneSign && larger < 0.0 ? -1.0 : 1.0;
}

NdcDepth ndcDepthOf(const MatrixProjection &projection)
{
    if (projection.ndcDepth)
        return *projection.ndcDepth;
    const Result<ProjectionCoefficients> c = coefficientsOf(projection.clipFromEye);
    if (!c)
        return NdcDepth::MinusOneToOne;
    const Result<NdcDepth> depth = chosenDepth(projection, *c);
    return depth ? *depth : NdcDepth::MinusOneToOne;
}

Result<PrecisePoint<EyeSpace>> preciseEyePoint(const MatrixProjection &projection, const Viewport &viewport,
                                               const DepthRange &range, const PrecisePoint<WindowSpace> &window)
{
    const Result<ProjectionCoefficients> coefficients = coefficientsOf(projection.clipFromEye);
    if (!coefficients)
        return coefficients.error();
    const ProjectionCoefficients &c = *coefficients;
    const Result<NdcDepth> depth = chosenDepth(projection, c);
    if (!depth)
        return depth.error();
    if (const Check valid = check(viewport); !valid)
        return valid.error();
    if (const auto value = firstNotFinite({window.x.value, window.y.value}))
        return Error{ErrorCode::NotFinite, *value};
    const Result<DepthShares> d = depthShares(range, window.z.value);
    if (!d)
        return d.error();

    const double k = *depth == NdcDepth::ZeroToOne ? 1.0 : 2.0;
    const DoubleDouble x = centredAndScaled(window.x, viewport.x, viewport.width, c.w, c.xOffset, c.xScale);
    const DoubleDouble y = centredAndScaled(window.y, viewport.y, viewport.height, c.w, c.yOffset, c.yScale);
    PrecisePoint<EyeSpace> eye;
    if (c.perspective) {
        const DoubleDouble denominator =
            c.zOffset < 0.0 ? (DoubleDouble(c.zScale) + c.w) - c.w * k * d->fromFar
                            : (DoubleDouble(c.zScale) + DoubleDouble(c.w) * (1.0 - k)) + c.w * k * d->fromNear;
        const DoubleDouble z = c.zOffset / denominator;
        eye = {x * z, y * z, c.side * z};
        if (c.xSkew != 0.0)
            eye.x = eye.x - c.xSkew * eye.y / c.xScale;
    } else {
        const DoubleDouble ndc = k == 2.0 ? d->fromNear - d->fromFar : d->fromNear;
        const DoubleDouble z = (c.w * ndc - c.zOffset) / c.zScale;
        eye = {x - c.xShear * z / c.xScale, y - c.yShear * z / c.yScale, z};
    }
    if (!isFinite(eye.rounded()))
        return Error{ErrorCode::PointAtInfinity};
    return eye;
}

} // namespace unprojector::geometry
