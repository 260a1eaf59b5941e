#include "core/unproject/exact_unprojection.h"

#include <algorithm>
#include <cmath>

namespace unprojector::unproject {
using namespace geometry;

namespace {

using Triple = std::array<Extended, 3>;
using Matrix = MatrixRows<Extended>;

Extended extended(const DoubleDouble &number)
{
    return Extended(number.value) + number.rest;
}

Triple extended(const Components<3> &v)
{
    return {Extended(v.x), Extended(v.y), Extended(v.z)};
}

Triple difference(const Triple &a, const Triple &b)
{
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

Triple cross(const Triple &a, const Triple &b)
{
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Triple unit(const Triple &v)
{
    const Extended length = sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
    return {v[0] / length, v[1] / length, v[2] / length};
}

Matrix extended(const PreciseMatrix &matrix)
{
    Matrix m;
    for (std::size_t row = 0; row < 4; ++row) {
        for (std::size_t column = 0; column < 4; ++column)
            m[row][column] = extended(matrix.columns[column][row]);
    }
    return m;
}

Matrix eyeFromWorld(const LookAt &camera)
{
    const Triple forward = unit(difference(extended(camera.center), extended(camera.eye)));
    const Triple side = unit(cross(forward, extended(camera.up)));
    const Triple upward = cross(side, forward);
    const Triple back{-forward[0], -forward[1], -forward[2]};
    Matrix m = extended(glm::dmat4(1.0));
    const Triple *rows[] = {&side, &upward, &back};
    for (std::size_t row = 0; row < 3; ++row) {
        m[row][3] = 0;
        for (std::size_t k = 0; k < 3; ++k) {
            m[row][k] = (*rows[row])[k];
            m[row][3] -= m[row][k] * camera.eye[static_cast<int>(k)];
        }
    }
    return m;
}

/// The numbers with which geometry::clipRows computes a projection matrix of 50 digits.
struct FiftyDigits {
    using Number = Extended;
    struct Edges {
        Extended left, right, bottom, top, skew;
    };
    static Extended of(const DoubleDouble &number) { return extended(number); }
    static Extended tangent(const DoubleDouble &radians) { return tan(extended(radians)); }
    static Extended cotangent(const Angle &angle) { return 1 / tangent(angle.radians); }
};

Matrix windowFromNdc(const Setup &g)
{
    const Extended dn = g.depthRange.atNear, df = g.depthRange.atFar;
    const bool zeroToOne = ndcDepthOf(g) == NdcDepth::ZeroToOne;
    Matrix m = extended(glm::dmat4(1.0));
    m[0][0] = Extended(g.viewport.width) / 2;
    m[0][3] = g.viewport.x + m[0][0];
    m[1][1] = Extended(g.viewport.height) / 2;
    m[1][3] = g.viewport.y + m[1][1];
    m[2][2] = zeroToOne ? df - dn : (df - dn) / 2;
    m[2][3] = zeroToOne ? dn : (df + dn) / 2;
    return m;
}

Matrix windowFromEye(const Setup &g)
{
    const auto *projection = std::get_if<MatrixProjection>(&g.lens);
    const Matrix clip =
        projection ? extended(projection->clipFromEye) : clipRows<FiftyDigits>(std::get<Projection>(g.lens));
    return product(windowFromNdc(g), clip);
}

Matrix windowFromWorld(const Setup &g)
{
    const auto *view = std::get_if<glm::dmat4>(&g.pose);
    return product(windowFromEye(g), view ? extended(*view) : eyeFromWorld(std::get<LookAt>(g.pose)));
}

} // namespace

std::optional<ExactUnprojection> ExactUnprojection::inverted(const Setup &setup, const Matrix &windowFromSpace)
{
    const Matrix spaceFromWindow =
        inverse(windowFromSpace, [](const Extended &number) -> Extended { return abs(number); });
    for (const MatrixRow<Extended> &row : spaceFromWindow) {
        if (!std::ranges::all_of(row, [](const Extended &number) { return isfinite(number); }))
            return std::nullopt;
    }
    return ExactUnprojection(spaceFromWindow, setup.surface);
}

std::optional<ExactUnprojection> ExactUnprojection::of(const Setup &setup)
{
    return inverted(setup, windowFromWorld(setup));
}

std::optional<ExactUnprojection> ExactUnprojection::toObject(const Setup &setup, const PreciseMatrix &worldFromObject)
{
    return inverted(setup, product(windowFromWorld(setup), extended(worldFromObject)));
}

std::optional<ExactUnprojection> ExactUnprojection::toEye(const Setup &setup)
{
    return inverted(setup, windowFromEye(setup));
}

std::optional<Triple> ExactUnprojection::at(const WindowPoint &window) const
{
    return at(window.x, window.y, window.z);
}

std::optional<Triple> ExactUnprojection::at(const DevicePoint &position, double depth) const
{
    return at(position.x, flippedY(m_surface, Extended(position.y)), depth);
}

std::optional<Triple> ExactUnprojection::at(const Extended &x, const Extended &y, const Extended &depth) const
{
    const MatrixRow<Extended> p = applied(m_spaceFromWindow, {x, y, depth, 1});
    // The point is beyond a double's range, or its w consists only of rounding error of 50 digits.
    if (abs(p[3]) * 1e30 <= abs(m_spaceFromWindow[3][3]) + abs(m_spaceFromWindow[3][2] * depth))
        return std::nullopt;
    return Triple{p[0] / p[3], p[1] / p[3], p[2] / p[3]};
}

} // namespace unprojector::unproject
