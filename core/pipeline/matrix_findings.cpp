#include "core/pipeline/matrix_findings.h"

#include "core/base/translation.h"
#include "core/geometry/condition_number.h"
#include "core/geometry/view_matrix.h"
#include "core/pipeline/decomposition.h"
#include "core/pipeline/matrix_format.h"
#include "core/pipeline/printed_digits.h"

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_access.hpp>
#include <glm/matrix.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <algorithm>
#include <cmath>
#include <type_traits>
#include <variant>

namespace unprojector::pipeline {
using namespace geometry;
using base::tr;
namespace {

using glm::dmat4;
using glm::dvec3;
using glm::dvec4;

/// The rounding residue of a zero in printed digits and single precision, relative to the largest
/// entry.
constexpr double kZero = 1e-6;

/// The matrix with exact zeros and ones where only rounding hides them.
dmat4 withoutRounding(const dmat4 &matrix)
{
    dmat4 m = matrix;
    const double largest = largestEntry(m);
    for (int i = 0; i < 16; ++i) {
        double &entry = m[i / 4][i % 4];
        // The third row may have small entries that are not rounding.
        if (i % 4 != 2 && std::abs(entry) <= kZero * kZero * largest)
            entry = 0.0;
    }
    return m;
}

/// Returns whether the last row is 0 0 0 w.
bool isAffine(const dmat4 &m)
{
    const dvec4 last = glm::row(m, 3);
    return last.w != 0.0 && glm::length(dvec3(last)) <= kZero * std::abs(last.w);
}

std::optional<RecognisedProjection> projectionIn(const dmat4 &m, const std::optional<NdcDepth> &depth)
{
    const auto result = recognised({withoutRounding(m), depth});
    if (!result)
        return std::nullopt;
    return *result;
}

/// The number of digits of a number, ignoring errors of single precision and printing.
int digitsOf(double value)
{
    constexpr double kPrinted = 1e-5;
    constexpr int kMost = 9;
    for (int digits = 1; digits < kMost; ++digits) {
        const double unit = std::pow(10.0, std::floor(std::log10(value)) - digits + 1);
        if (std::abs(std::round(value / unit) * unit - value) <= kPrinted * value)
            return digits;
    }
    return kMost;
}

double nearOf(const RecognisedProjection &r)
{
    return std::visit(
        [](const auto &p) {
            if constexpr (std::is_same_v<std::decay_t<decltype(p)>, Oblique>)
                return p.box.nearDistance;
            else
                return p.nearDistance;
        },
        r.parameters);
}

/// The near distance for [0, 1], if the matrix was made with it: either [-1, 1] is impossible, or
/// near has few digits for [0, 1] and many otherwise.
std::optional<double> nearByZeroToOne(const dmat4 &m, const RecognisedProjection &r)
{
    if (r.ndcDepth == NdcDepth::ZeroToOne)
        return nearOf(r);
    const auto other = projectionIn(m, NdcDepth::ZeroToOne);
    constexpr int kFew = 3, kMany = 5;
    if (!other || !r.coefficients.perspective || !(nearOf(*other) > 0.0) || !(nearOf(r) > 0.0))
        return std::nullopt;
    if (digitsOf(nearOf(*other)) <= kFew && digitsOf(nearOf(r)) >= kMany)
        return nearOf(*other);
    return std::nullopt;
}

void lookAtProjection(const dmat4 &m, const RecognisedProjection &r, const std::optional<NdcDepth> &depth,
                      std::vector<MatrixFinding> &found)
{
    if (!depth) {
        const bool isSureOf = r.ndcDepth == NdcDepth::ZeroToOne;
        if (const auto n = nearByZeroToOne(m, r))
            found.push_back({MatrixFault::DepthZeroToOne, MatrixRepair::DepthZeroToOne, *n,
                             isSureOf ? std::numeric_limits<double>::quiet_NaN() : nearOf(r)});
    }
    if (r.reversed)
        found.push_back({MatrixFault::DepthReversed, MatrixRepair::None, nearOf(r)});
    if (r.infiniteFar)
        found.push_back({MatrixFault::FarAtInfinity, MatrixRepair::None, nearOf(r)});
    if (r.coefficients.yScale < 0.0)
        found.push_back({MatrixFault::YDown, MatrixRepair::TurnY});
    if (r.coefficients.xScale < 0.0)
        found.push_back({MatrixFault::Mirrored, MatrixRepair::TurnX});
    if (r.looksAlongPlusZ)
        found.push_back({MatrixFault::LeftHanded, MatrixRepair::TurnEye});
}

/// Returns whether a projection has this form with a w of 1, as every untransposed one has.
bool isPlainProjection(const dmat4 &m)
{
    const auto r = projectionIn(m, std::nullopt);
    return r && !r->negated && std::abs(r->coefficients.w - 1.0) <= kZero;
}

std::vector<MatrixFinding> projectionFindings(const dmat4 &m, const std::optional<NdcDepth> &depth)
{
    std::vector<MatrixFinding> found;
    const bool isPlain = isPlainProjection(m);
    if (!isPlain && isPlainProjection(glm::transpose(m)))
        return {{MatrixFault::Transposed, MatrixRepair::OtherOrder}};
    if (!isPlain && isPlainProjection(glm::inverse(m)))
        return {{MatrixFault::Inverse, MatrixRepair::Invert}};
    if (!isPlain && isPlainProjection(glm::inverse(glm::transpose(m))))
        return {{MatrixFault::Transposed, MatrixRepair::OtherOrder}, {MatrixFault::Inverse, MatrixRepair::Invert}};
    if (const auto r = projectionIn(m, depth)) {
        if (r->negated)
            return {{MatrixFault::Negated, MatrixRepair::Negate}};
        lookAtProjection(m, *r, depth, found);
        return found;
    }
    if (axesOff(m) || axesOff(glm::transpose(m)))
        return {{MatrixFault::Exchanged, MatrixRepair::Exchange}};
    return {{MatrixFault::UnknownForm}};
}

/// The distance of the world's origin from the middle of the view, 1 at its edge; nothing if it is
/// behind the eye.
std::optional<double> originOffMiddle(const dmat4 &view, const std::optional<dmat4> &clipFromEye)
{
    const dvec4 eye = view[3] / view[3][3];
    if (!clipFromEye) {
        if (!(eye.z < 0.0))
            return std::nullopt;
        return std::max(std::abs(eye.x), std::abs(eye.y)) / -eye.z;
    }
    const dvec4 clip = *clipFromEye * eye;
    if (!(clip.w > 0.0) || std::abs(clip.z) > clip.w)
        return std::nullopt;
    return std::max(std::abs(clip.x), std::abs(clip.y)) / clip.w;
}

std::vector<MatrixFinding> viewFindings(const dmat4 &m, const std::optional<dmat4> &clipFromEye)
{
    if (!isAffine(m)) {
        if (isAffine(glm::transpose(m)))
            return {{MatrixFault::Transposed, MatrixRepair::OtherOrder}};
        if (isPlainProjection(m) || isPlainProjection(glm::transpose(m)))
            return {{MatrixFault::Exchanged, MatrixRepair::Exchange}};
        return {{MatrixFault::UnknownForm}};
    }
    std::vector<MatrixFinding> found;
    const glm::dmat3 axes = glm::dmat3(m) / m[3][3];
    const double determinant = glm::determinant(axes), scale = std::cbrt(std::abs(determinant));
    const glm::dmat3 squared = axes * glm::transpose(axes), same(1.0);
    constexpr double kRigid = 1e-4;
    if (largestDifference(squared / (scale * scale), same) > kRigid) {
        double longest = 0.0;
        for (int i = 0; i < 3; ++i)
            longest = std::max(longest, glm::length(glm::row(axes, i)));
        found.push_back({MatrixFault::Scaled, MatrixRepair::None, longest});
    } else if (std::abs(scale - 1.0) > kRigid) {
        found.push_back({MatrixFault::Scaled, MatrixRepair::WithoutScale, scale});
    }
    if (determinant < 0.0)
        found.push_back({MatrixFault::Mirrored, MatrixRepair::TurnX});
    if (m[3][3] < 0.0)
        found.push_back({MatrixFault::Negated, MatrixRepair::Negate});
    if (const auto printedOff = roundedOff(m)) {
        std::erase_if(found, [](const MatrixFinding &one) { return one.fault == MatrixFault::Scaled; });
        found.insert(found.begin(), {MatrixFault::Rounded, MatrixRepair::Orthonormal, *printedOff});
    } else if (found.empty() && m[3][3] > 0.0 && !geometry::axesOff(m)) { // too skew for the formulas
        found.push_back({MatrixFault::Rounded, MatrixRepair::Orthonormal, largestDifference(squared, same)});
    }
    const dmat4 inverse = glm::inverse(m);
    constexpr double kInTheMiddle = 0.5;
    const auto otherOff = originOffMiddle(inverse, clipFromEye);
    if (!originOffMiddle(m, clipFromEye) && otherOff && *otherOff <= kInTheMiddle)
        found.push_back({MatrixFault::Inverse, MatrixRepair::Invert});
    return found;
}

std::vector<MatrixFinding> productFindings(const dmat4 &m, const std::optional<NdcDepth> &depth)
{
    // The inverse and the transpose of a product almost have the form of a product if the view
    // looks at the world's origin; only w differs.
    const auto isPlain = [](const dmat4 &p) {
        const auto apart = decomposed(p);
        return isAffine(p) || (apart && std::abs(std::abs(apart->w) - 1.0) <= 10.0 * kZero);
    };
    const auto isProduct = [](const dmat4 &p) { return decomposed(p).has_value(); };
    const dmat4 transposed = glm::transpose(m), inverse = glm::inverse(m);
    const bool isMeant = isPlain(m) || (!isPlain(transposed) && !isPlain(inverse) && isProduct(m));
    if (!isMeant) {
        if (isPlain(transposed))
            return {{MatrixFault::Transposed, MatrixRepair::OtherOrder}};
        if (isPlain(inverse))
            return {{MatrixFault::Inverse, MatrixRepair::Invert}};
        return {{MatrixFault::UnknownForm}};
    }
    std::vector<MatrixFinding> found;
    const auto apart = decomposed(m);
    if (!apart)
        return found;
    if (apart->w < 0.0)
        found.push_back({MatrixFault::Negated, MatrixRepair::Negate});
    // A box's product alone does not tell the directions of its depth and its y.
    if (apart->isBox)
        return found;
    if (const auto r = projectionIn(apart->clipFromEye, depth))
        lookAtProjection(apart->clipFromEye, *r, depth, found);
    return found;
}

std::string number(double value)
{
    constexpr int kDigits = 5; // significant digits of near that survive in a matrix of single precision
    return numberText(value, Digits::Double, kDigits);
}

} // namespace

std::vector<MatrixFinding> findings(const dmat4 &matrix, MatrixRole role, const std::optional<NdcDepth> &ndcDepth,
                                    const std::optional<dmat4> &clipFromEye)
{
    if (isSingular(matrix))
        return {};
    switch (role) {
    case MatrixRole::View: return viewFindings(matrix, clipFromEye);
    case MatrixRole::Projection: return projectionFindings(matrix, ndcDepth);
    case MatrixRole::Product: break;
    }
    return productFindings(matrix, ndcDepth);
}

void turnEye(dmat4 &clipFromEye, dmat4 &eyeFromWorld)
{
    // A mirroring view was made for a left-handed eye. Any other is rotated by 180 degrees about x,
    // and y then points down.
    const bool isMirrored = glm::determinant(glm::dmat3(eyeFromWorld)) < 0.0;
    dmat4 turn(1.0);
    turn[1][1] = isMirrored ? 1.0 : -1.0;
    turn[2][2] = -1.0;
    clipFromEye = withoutNegativeZeros(clipFromEye * turn);
    eyeFromWorld = withoutNegativeZeros(turn * eyeFromWorld);
}

dmat4 repaired(const dmat4 &matrix, const MatrixFinding &finding)
{
    dmat4 m = matrix;
    const auto turnRow = [&m](int i) {
        for (int column = 0; column < 4; ++column)
            m[column][i] = m[column][i] == 0.0 ? 0.0 : -m[column][i];
    };
    switch (finding.repair) {
    case MatrixRepair::None:
    case MatrixRepair::Exchange:
    case MatrixRepair::DepthZeroToOne: break;
    case MatrixRepair::OtherOrder: return glm::transpose(m);
    case MatrixRepair::Invert: return glm::inverse(m);
    case MatrixRepair::TurnY: turnRow(1); break;
    case MatrixRepair::TurnX: turnRow(0); break;
    case MatrixRepair::Orthonormal: return orthonormal(m);
    case MatrixRepair::Negate: return withoutNegativeZeros(-m);
    case MatrixRepair::TurnEye: m[2] = -m[2]; return withoutNegativeZeros(m);
    case MatrixRepair::WithoutScale:
        // Eye coordinates stay, since near and far are measured in them; instead, the object's
        // coordinates are scaled to the world's.
        for (int column = 0; column < 3; ++column) {
            for (int i = 0; i < 3; ++i)
                m[column][i] /= finding.value;
        }
        break;
    }
    return m;
}

std::string findingText(const MatrixFinding &finding, MatrixRole role)
{
    const bool isView = role == MatrixRole::View;
    switch (finding.fault) {
    case MatrixFault::Transposed:
        return tr(isView ? "looks transposed: its last column, not its last row, is 0 0 0 1"
                         : "looks transposed: only its transpose has a projection's form");
    case MatrixFault::Inverse:
        return tr(isView ? "may be the inverse of a view (world from eye): read as a view, it hides the world's "
                           "origin; inverted, it shows the origin"
                         : "is an inverse: its own inverse has a projection's form");
    case MatrixFault::Exchanged:
        return tr(isView ? "has a projection's form: view and projection seem to be swapped"
                         : "has a view's form: view and projection seem to be swapped");
    case MatrixFault::UnknownForm:
        return isView                           ? tr("is not rotation + translation")
               : role == MatrixRole::Projection ? tr("is neither a perspective nor an orthographic projection")
                                                : tr("is not a perspective or orthographic projection times a view");
    case MatrixFault::DepthZeroToOne:
        return std::isnan(finding.other) ? tr(
                   "uses NDC depths from 0 to 1 (Direct3D, Vulkan), and is read so: near is %1", number(finding.value))
                                         : tr("seems to use NDC depths from 0 to 1 (Direct3D, Vulkan): near is then "
                                              "%1; it is read with depths from -1 to 1, near %2",
                                              number(finding.value), number(finding.other));
    case MatrixFault::DepthReversed: return tr("has reversed depths: near, %1, is at 1", number(finding.value));
    case MatrixFault::FarAtInfinity: return tr("has its far plane at infinity: depths there have no point");
    case MatrixFault::YDown: return tr("flips y, as is done for Vulkan: the view is upside down in OpenGL");
    case MatrixFault::Mirrored: return tr(isView ? "is mirrored: its axes are left-handed" : "mirrors x");
    case MatrixFault::LeftHanded: return tr("is for an eye space that looks along +z (Direct3D, OpenCV)");
    case MatrixFault::Negated:
        return tr("has every entry negated: the same points, but w < 0 in front of the eye, which OpenGL cuts off");
    case MatrixFault::Rounded:
        return tr("has axes that deviate by %1 from perpendicular and length 1, as after rounding or many rotations; "
                  "the formulas need 0.00001; give more decimals",
                  numberText(finding.value, Digits::Double, 2));
    case MatrixFault::OtherOrder:
        return tr(isView ? "is read in the order, by rows or by columns, that makes 0 0 0 1 its last row"
                         : "is read in the order, by rows or by columns, that makes it a projection");
    case MatrixFault::OrderOfOthers:
        return tr("has the same form in both orders, and is read in that of the other matrices");
    case MatrixFault::OrderOpen:
        return tr("is a camera's matrix by rows and by columns, a different one in each order");
    case MatrixFault::Scaled: break;
    }
    return tr(
        finding.repair == MatrixRepair::None
            ? "has axes of different lengths or not perpendicular, the longest %1: results are object coordinates, not "
              "world coordinates"
            : "scales by %1: it contains a model's scale, so results are object coordinates, not world coordinates",
        number(finding.value));
}

} // namespace unprojector::pipeline
