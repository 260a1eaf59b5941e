#include "tests/support/oracle.h"

#include <boost/math/constants/constants.hpp>

#include <cstddef>
#include <stdexcept>
#include <utility>

namespace oracle {
namespace {

Vector3 extended(const std::array<double, 3> &v)
{
    return {Extended(v[0]), Extended(v[1]), Extended(v[2])};
}

Vector3 crossProduct(const Vector3 &a, const Vector3 &b)
{
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Vector3 normalized(const Vector3 &v)
{
    const Extended length = sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
    return {v[0] / length, v[1] / length, v[2] / length};
}

Vector4 times(const Matrix4 &m, const Vector4 &v)
{
    Vector4 result;
    for (std::size_t row = 0; row < 4; ++row)
        result[row] = m[row][0] * v[0] + m[row][1] * v[1] + m[row][2] * v[2] + m[row][3] * v[3];
    return result;
}

Vector3 divided(const Vector4 &v)
{
    return {v[0] / v[3], v[1] / v[3], v[2] / v[3]};
}

Matrix4 identity()
{
    Matrix4 m;
    for (std::size_t row = 0; row < 4; ++row) {
        for (std::size_t column = 0; column < 4; ++column)
            m[row][column] = row == column ? 1 : 0;
    }
    return m;
}

Matrix4 fromColumns(const std::array<double, 16> &columns)
{
    Matrix4 m;
    for (std::size_t i = 0; i < 16; ++i)
        m[i % 4][i / 4] = columns[i];
    return m;
}

/// Gauss elimination with partial pivoting, then back substitution.
Vector4 solved(Matrix4 a, Vector4 b)
{
    for (std::size_t k = 0; k < 4; ++k) {
        std::size_t pivot = k;
        for (std::size_t row = k + 1; row < 4; ++row) {
            if (abs(a[row][k]) > abs(a[pivot][k]))
                pivot = row;
        }
        if (a[pivot][k] == 0)
            throw std::domain_error("oracle: singular system");
        std::swap(a[k], a[pivot]);
        std::swap(b[k], b[pivot]);
        for (std::size_t row = k + 1; row < 4; ++row) {
            const Extended factor = a[row][k] / a[k][k];
            for (std::size_t column = k; column < 4; ++column)
                a[row][column] -= factor * a[k][column];
            b[row] -= factor * b[k];
        }
    }
    Vector4 x;
    for (std::size_t k = 4; k-- > 0;) {
        x[k] = b[k];
        for (std::size_t column = k + 1; column < 4; ++column)
            x[k] -= a[k][column] * x[column];
        x[k] /= a[k][k];
    }
    return x;
}

Vector4 homogeneous(const std::array<double, 3> &v)
{
    return {Extended(v[0]), Extended(v[1]), Extended(v[2]), Extended(1)};
}

Matrix4 frustumMatrix(const Extended &left, const Extended &right, const Extended &bottom, const Extended &top,
                      const Extended &zNear, const Extended &zFar)
{
    const Extended zero = 0;
    const Extended width = right - left, height = top - bottom, thickness = zFar - zNear;
    return {{
        {2 * zNear / width, zero, (right + left) / width, zero},
        {zero, 2 * zNear / height, (top + bottom) / height, zero},
        {zero, zero, -(zFar + zNear) / thickness, -2 * zFar * zNear / thickness},
        {zero, zero, Extended(-1), zero},
    }};
}

Matrix4 orthoMatrix(const Projection &p)
{
    const Extended zero = 0, one = 1;
    const Extended left = p.left, right = p.right, bottom = p.bottom, top = p.top;
    const Extended zNear = p.nearDistance, zFar = p.farDistance;
    const Extended width = right - left, height = top - bottom, thickness = zFar - zNear;
    return {{
        {2 / width, zero, zero, -(right + left) / width},
        {zero, 2 / height, zero, -(top + bottom) / height},
        {zero, zero, -2 / thickness, -(zFar + zNear) / thickness},
        {zero, zero, zero, one},
    }};
}

Extended radians(double angle, bool isDegrees)
{
    return isDegrees ? Extended(angle) * boost::math::constants::pi<Extended>() / 180 : Extended(angle);
}

} // namespace

Matrix4 lookAtMatrix(const View &view)
{
    const Vector3 eye = extended(view.eye);
    const Vector3 forward = normalized(difference(extended(view.center), eye));
    const Vector3 side = normalized(crossProduct(forward, extended(view.up)));
    const Vector3 upward = crossProduct(side, forward);
    // gluLookAt: a rotation, then glTranslate(-eye).
    Matrix4 rotation = identity(), translation = identity();
    for (std::size_t k = 0; k < 3; ++k) {
        rotation[0][k] = side[k];
        rotation[1][k] = upward[k];
        rotation[2][k] = -forward[k];
        translation[k][3] = -eye[k];
    }
    return product(rotation, translation);
}

Matrix4 projectionMatrix(const Projection &p)
{
    switch (p.kind) {
    case RandomKind::Frustum: return frustumMatrix(p.left, p.right, p.bottom, p.top, p.nearDistance, p.farDistance);
    case RandomKind::Ortho: return orthoMatrix(p);
    case RandomKind::Perspective: {
        // The page of gluPerspective gives its matrix with cot(fovy / 2), not through a frustum.
        const Extended zero = 0, zNear = p.nearDistance, zFar = p.farDistance;
        const Extended cot = 1 / tan(radians(p.verticalFovRadians, p.areDegrees) / 2);
        return {{
            {cot * p.aspectHeight / p.aspect, zero, zero, zero},
            {zero, cot, zero, zero},
            {zero, zero, (zFar + zNear) / (zNear - zFar), 2 * zFar * zNear / (zNear - zFar)},
            {zero, zero, Extended(-1), zero},
        }};
    }
    case RandomKind::Oblique: {
        Matrix4 shear = identity();
        shear[0][2] = 1 / tan(radians(p.thetaRadians, p.areDegrees));
        shear[1][2] = 1 / tan(radians(p.phiRadians, p.areDegrees));
        return product(orthoMatrix(p), shear);
    }
    }
    throw std::logic_error("oracle: unknown projection");
}

Matrix4 targetMatrix(const Target &t)
{
    const Extended half = Extended(1) / 2;
    Matrix4 m = identity();
    m[0][0] = half * t.width;
    m[1][1] = half * t.height;
    m[2][2] = half * (Extended(t.depthAtFar) - t.depthAtNear);
    m[0][3] = t.x + half * t.width;
    m[1][3] = t.y + half * t.height;
    m[2][3] = half * (Extended(t.depthAtFar) + t.depthAtNear);
    return m;
}

Matrix4 product(const Matrix4 &a, const Matrix4 &b)
{
    Matrix4 m;
    for (std::size_t row = 0; row < 4; ++row) {
        for (std::size_t column = 0; column < 4; ++column) {
            m[row][column] = 0;
            for (std::size_t k = 0; k < 4; ++k)
                m[row][column] += a[row][k] * b[k][column];
        }
    }
    return m;
}

Oracle::Oracle(const View &view, const Projection &projection, const Target &target)
    : m_eyeFromWorld(lookAtMatrix(view)), m_clipFromEye(projectionMatrix(projection)),
      m_windowFromNdc(targetMatrix(target)), m_windowFromEye(product(m_windowFromNdc, m_clipFromEye)),
      m_windowFromWorld(product(m_windowFromEye, m_eyeFromWorld))
{
}

Oracle::Oracle(const std::array<double, 16> &eyeFromWorld, const std::array<double, 16> &clipFromEye,
               const Target &target, bool zeroToOne)
    : m_eyeFromWorld(fromColumns(eyeFromWorld)), m_clipFromEye(fromColumns(clipFromEye)),
      m_windowFromNdc(targetMatrix(target))
{
    if (zeroToOne) {
        m_windowFromNdc[2][2] = Extended(target.depthAtFar) - target.depthAtNear;
        m_windowFromNdc[2][3] = target.depthAtNear;
    }
    m_windowFromEye = product(m_windowFromNdc, m_clipFromEye);
    m_windowFromWorld = product(m_windowFromEye, m_eyeFromWorld);
}

Stages Oracle::forward(const Vector3 &world) const
{
    const Vector4 eye = times(m_eyeFromWorld, {world[0], world[1], world[2], Extended(1)});
    const Vector4 clip = times(m_clipFromEye, eye);
    const Vector3 ndc = divided(clip);
    const Vector4 window = times(m_windowFromNdc, {ndc[0], ndc[1], ndc[2], Extended(1)});
    return {divided(eye), clip, ndc, divided(window)};
}

Vector3 Oracle::eyeUnder(const std::array<double, 3> &window) const
{
    return divided(solved(m_windowFromEye, homogeneous(window)));
}

Vector3 Oracle::worldUnder(const std::array<double, 3> &window) const
{
    return divided(solved(m_windowFromWorld, homogeneous(window)));
}

Vector3 Oracle::eyeAt(const Vector3 &window) const
{
    return divided(solved(m_windowFromEye, {window[0], window[1], window[2], Extended(1)}));
}

Vector3 Oracle::worldAt(const Vector3 &window) const
{
    return divided(solved(m_windowFromWorld, {window[0], window[1], window[2], Extended(1)}));
}

Extended maxNorm(const Vector3 &v)
{
    Extended largest = 0;
    for (const Extended &component : v) {
        if (abs(component) > largest)
            largest = abs(component);
    }
    return largest;
}

Vector3 difference(const Vector3 &a, const Vector3 &b)
{
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

} // namespace oracle
