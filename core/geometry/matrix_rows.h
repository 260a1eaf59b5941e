#pragma once

#include "core/geometry/projection.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <variant>

/// Matrices with more digits than doubles have, row by row. The same code computes with 32 digits
/// (WayForward, WayBack) and with 50 (unproject/exact_unprojection).
namespace unprojector::geometry {

template <class Number>
using MatrixRow = std::array<Number, 4>;
template <class Number>
using MatrixRows = std::array<MatrixRow<Number>, 4>;

template <class Number>
MatrixRow<Number> applied(const MatrixRows<Number> &rows, const MatrixRow<Number> &v)
{
    MatrixRow<Number> result;
    for (std::size_t row = 0; row < 4; ++row)
        result[row] = rows[row][0] * v[0] + rows[row][1] * v[1] + rows[row][2] * v[2] + rows[row][3] * v[3];
    return result;
}

template <class Number>
MatrixRows<Number> product(const MatrixRows<Number> &a, const MatrixRows<Number> &b)
{
    MatrixRows<Number> result{};
    for (std::size_t row = 0; row < 4; ++row) {
        for (std::size_t column = 0; column < 4; ++column) {
            for (std::size_t k = 0; k < 4; ++k)
                result[row][column] = result[row][column] + a[row][k] * b[k][column];
        }
    }
    return result;
}

/// Gauss and Jordan's inverse with scaled pivots; not finite for a singular matrix.
/// @param size  size(number) is its absolute value, in a type whose range has that of all numbers here
template <class Number, class Size>
MatrixRows<Number> inverse(MatrixRows<Number> m, const Size &size)
{
    MatrixRows<Number> result{};
    std::array<decltype(size(m[0][0])), 4> scale{};
    for (std::size_t row = 0; row < 4; ++row) {
        result[row][row] = 1.0;
        for (const Number &number : m[row])
            scale[row] = std::max(scale[row], size(number));
    }
    for (std::size_t k = 0; k < 4; ++k) {
        std::size_t pivot = k;
        for (std::size_t row = k + 1; row < 4; ++row) {
            if (size(m[row][k]) / scale[row] > size(m[pivot][k]) / scale[pivot])
                pivot = row;
        }
        std::swap(m[k], m[pivot]);
        std::swap(result[k], result[pivot]);
        std::swap(scale[k], scale[pivot]);
        const Number divisor = m[k][k];
        for (std::size_t column = 0; column < 4; ++column) {
            m[k][column] = m[k][column] / divisor;
            result[k][column] = result[k][column] / divisor;
        }
        for (std::size_t row = 0; row < 4; ++row) {
            const Number factor = m[row][k];
            if (row == k || size(factor) == 0)
                continue;
            for (std::size_t column = 0; column < 4; ++column) {
                m[row][column] = m[row][column] - factor * m[k][column];
                result[row][column] = result[row][column] - factor * result[k][column];
            }
        }
    }
    return result;
}

/// The edges of a projection's window, see preciseEdges.
/// @tparam Digits  has `Number`, `Edges` with its left, right, bottom, top and skew, of(DoubleDouble) and
///         tangent(DoubleDouble)
template <class Digits>
typename Digits::Edges edgesOf(const Projection &projection)
{
    using Number = typename Digits::Number;
    if (const auto *p = std::get_if<Perspective>(&projection)) {
        const Number top = p->nearDistance * Digits::tangent(p->verticalFov.radians / 2.0),
                     right = top * Digits::of(p->aspect);
        return {-right, right, -top, top, 0.0};
    }
    if (const auto *p = std::get_if<Pinhole>(&projection)) {
        const Number n = p->nearDistance, toCorner = p->areCentersWhole ? 0.5 : 0.0;
        const Number cx = p->cx + toCorner, cy = p->cy + toCorner;
        return {-(n * cx) / p->fx, n * (p->width - cx) / p->fx, -(n * (p->height - cy)) / p->fy, n * cy / p->fy,
                p->skew == 0.0 ? Number() : -Number(p->skew) / p->fx};
    }
    const ProjectionWindow w = projectionWindow(projection);
    return {w.left, w.right, w.bottom, w.top, w.skew};
}

/// The projection matrix.
/// @tparam Digits  has what edgesOf requires, and cotangent(Angle)
template <class Digits>
MatrixRows<typename Digits::Number> clipRows(const Projection &projection)
{
    using Number = typename Digits::Number;
    const auto &[l, r, b, t, skew] = edgesOf<Digits>(projection);
    const ProjectionWindow w = projectionWindow(projection);
    const Number n = w.nearDistance, f = w.farDistance, thickness = f - n;
    const Number xSkew = (r + l) / (r - l), ySkew = (t + b) / (t - b), zSkew = (f + n) / thickness;
    if (isPerspective(projection))
        return {{{2.0 * n / (r - l), w.skew == 0.0 ? Number() : 2.0 * n * skew / (r - l), xSkew, 0.0},
                 {0.0, 2.0 * n / (t - b), ySkew, 0.0},
                 {0.0, 0.0, -zSkew, -2.0 * n * (f / thickness)},
                 {0.0, 0.0, -1.0, 0.0}}};
    MatrixRows<Number> rows{{{2.0 / (r - l), 0.0, 0.0, -xSkew},
                             {0.0, 2.0 / (t - b), 0.0, -ySkew},
                             {0.0, 0.0, -2.0 / thickness, -zSkew},
                             {0.0, 0.0, 0.0, 1.0}}};
    if (const auto *oblique = std::get_if<Oblique>(&projection)) {
        rows[0][2] = rows[0][0] * Digits::cotangent(oblique->theta);
        rows[1][2] = rows[1][1] * Digits::cotangent(oblique->phi);
    }
    return rows;
}

/// The 32 digits of a DoubleDouble.
struct TwoDoubles {
    using Number = DoubleDouble;
    using Edges = PreciseEdges;
    static DoubleDouble of(const DoubleDouble &number) { return number; }
    static DoubleDouble tangent(const DoubleDouble &radians) { return preciseTangent(radians); }
    static DoubleDouble cotangent(const Angle &angle) { return preciseCotangent(angle); }
};

} // namespace unprojector::geometry
