#include "core/unproject/exact_unprojection.h"

#include <utility>

namespace unprojector::unproject {
using namespace geometry;

namespace {

using Triple = std::array<Extended, 3>;

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

} // namespace

ExactUnprojection::Matrix ExactUnprojection::product(const Matrix &a, const Matrix &b)
{
    Matrix m;
    for (std::size_t row = 0; row < 4; ++row) {
        for (std::size_t column = 0; column < 4; ++column) {
            m[row][column] = 0;
            for (std::size_t k = 0; k < 4; ++k)
                m[row][column] += a[row][k] * b[k][column];
        }
    }
    return m;
}

ExactUnprojection::Matrix ExactUnprojection::extended(const PreciseMatrix &matrix)
{
    Matrix m;
    for (std::size_t row = 0; row < 4; ++row) {
        for (std::size_t column = 0; column < 4; ++column) {
            const DoubleDouble &number = matrix.columns[column][row];
            m[row][column] = Extended(number.value) + number.rest;
        }
    }
    return m;
}

ExactUnprojection::Matrix ExactUnprojection::eyeFromWorld(const LookAt &camera)
{
    const Triple forward = unit(difference(unproject::extended(camera.center), unproject::extended(camera.eye)));
    const Triple side = unit(cross(forward, unproject::extended(camera.up)));
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

ExactUnprojection::Matrix ExactUnprojection::clipFromEye(const Projection &projection)
{
    Matrix m = extended(glm::dmat4(0.0));
    if (const auto *p = std::get_if<Perspective>(&projection)) {
        const Extended n = p->nearDistance, f = p->farDistance;
        const Extended cotangent = 1 / tan(unproject::extended(p->verticalFov.radians) / 2);
        m[0][0] = cotangent / unproject::extended(p->aspect);
        m[1][1] = cotangent;
        m[2][2] = -(f + n) / (f - n);
        m[2][3] = -2 * f * n / (f - n);
        m[3][2] = -1;
        return m;
    }
    if (const auto *p = std::get_if<Pinhole>(&projection)) {
        const Extended n = p->nearDistance, f = p->farDistance, toCorner = p->areCentersWhole ? 0.5 : 0.0;
        m[0][0] = 2 * Extended(p->fx) / p->width;
        m[0][1] = -2 * Extended(p->skew) / p->width;
        m[0][2] = 1 - 2 * (p->cx + toCorner) / p->width;
        m[1][1] = 2 * Extended(p->fy) / p->height;
        m[1][2] = 2 * (p->cy + toCorner) / p->height - 1;
        m[2][2] = -(f + n) / (f - n);
        m[2][3] = -2 * f * n / (f - n);
        m[3][2] = -1;
        return m;
    }
    const ProjectionWindow w = projectionWindow(projection);
    const Extended l = w.left, r = w.right, b = w.bottom, t = w.top, n = w.nearDistance, f = w.farDistance;
    if (isPerspective(projection)) {
        m[0][0] = 2 * n / (r - l);
        m[0][1] = m[0][0] * w.skew;
        m[0][2] = (r + l) / (r - l);
        m[1][1] = 2 * n / (t - b);
        m[1][2] = (t + b) / (t - b);
        m[2][2] = -(f + n) / (f - n);
        m[2][3] = -2 * f * n / (f - n);
        m[3][2] = -1;
        return m;
    }
    m[0][0] = 2 / (r - l);
    m[0][3] = -(r + l) / (r - l);
    m[1][1] = 2 / (t - b);
    m[1][3] = -(t + b) / (t - b);
    m[2][2] = -2 / (f - n);
    m[2][3] = -(f + n) / (f - n);
    m[3][3] = 1;
    if (const auto *oblique = std::get_if<Oblique>(&projection)) {
        Matrix shear = extended(glm::dmat4(1.0));
        shear[0][2] = 1 / tan(unproject::extended(oblique->theta.radians));
        shear[1][2] = 1 / tan(unproject::extended(oblique->phi.radians));
        m = product(m, shear);
    }
    return m;
}

ExactUnprojection::Matrix ExactUnprojection::windowFromNdc(const Setup &g)
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

std::optional<ExactUnprojection::Matrix> ExactUnprojection::inverse(Matrix m)
{
    Matrix result = extended(glm::dmat4(1.0));
    for (std::size_t k = 0; k < 4; ++k) {
        std::size_t pivot = k;
        for (std::size_t row = k + 1; row < 4; ++row) {
            if (abs(m[row][k]) > abs(m[pivot][k]))
                pivot = row;
        }
        if (m[pivot][k] == 0)
            return std::nullopt;
        std::swap(m[k], m[pivot]);
        std::swap(result[k], result[pivot]);
        const Extended scale = 1 / m[k][k];
        for (std::size_t column = 0; column < 4; ++column) {
            m[k][column] *= scale;
            result[k][column] *= scale;
        }
        for (std::size_t row = 0; row < 4; ++row) {
            const Extended factor = row == k ? Extended(0) : m[row][k];
            for (std::size_t column = 0; column < 4; ++column) {
                m[row][column] -= factor * m[k][column];
                result[row][column] -= factor * result[k][column];
            }
        }
    }
    return result;
}

ExactUnprojection::Matrix ExactUnprojection::windowFromEye(const Setup &g)
{
    const auto *projection = std::get_if<MatrixProjection>(&g.lens);
    const Matrix clip = projection ? extended(projection->clipFromEye) : clipFromEye(std::get<Projection>(g.lens));
    return product(windowFromNdc(g), clip);
}

ExactUnprojection::Matrix ExactUnprojection::windowFromWorld(const Setup &g)
{
    const auto *view = std::get_if<glm::dmat4>(&g.pose);
    return product(windowFromEye(g), view ? extended(*view) : eyeFromWorld(std::get<LookAt>(g.pose)));
}

std::optional<ExactUnprojection> ExactUnprojection::inverted(const Setup &setup, const Matrix &windowFromSpace)
{
    const std::optional<Matrix> spaceFromWindow = inverse(windowFromSpace);
    if (!spaceFromWindow)
        return std::nullopt;
    return ExactUnprojection(*spaceFromWindow, setup.surface);
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
    std::array<Extended, 4> p;
    for (std::size_t row = 0; row < 4; ++row) {
        const auto &m = m_spaceFromWindow[row];
        p[row] = m[0] * x + m[1] * y + m[2] * depth + m[3];
    }
    // The point is beyond a double's range, or its w consists only of rounding error of 50 digits.
    if (abs(p[3]) * 1e30 <= abs(m_spaceFromWindow[3][3]) + abs(m_spaceFromWindow[3][2] * depth))
        return std::nullopt;
    return Triple{p[0] / p[3], p[1] / p[3], p[2] / p[3]};
}

} // namespace unprojector::unproject
