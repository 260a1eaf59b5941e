#pragma once

#include <boost/multiprecision/cpp_bin_float.hpp>

#include <array>

/// A second, independent implementation of projecting and unprojecting, to test core. It is written
/// from the OpenGL 2.1 reference pages and includes nothing of core. It takes plain doubles and
/// computes with 50 digits, so its own rounding is negligible beside a double's.
///
/// Unprojecting uses no formula: the point under a window position solves the linear system of the
/// forward matrices.
namespace oracle {

using Extended = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<50>, boost::multiprecision::et_off>;
using Vector3 = std::array<Extended, 3>;
using Vector4 = std::array<Extended, 4>;
using Matrix4 = std::array<Vector4, 4>; ///< m[row][column], column vectors

/// The arguments of gluLookAt.
struct View {
    std::array<double, 3> eye, center, up;
};

enum class RandomKind { Frustum, Ortho, Perspective, Oblique };

/// The arguments of glFrustum, glOrtho, gluPerspective or of a sheared glOrtho, as a user writes
/// them: nothing is rounded that is computed from them. Arguments that the kind does not have are
/// ignored.
struct Projection {
    RandomKind kind = RandomKind::Ortho;
    double left = -1.0, right = 1.0, bottom = -1.0, top = 1.0;
    double nearDistance = 1.0, farDistance = 2.0;
    double verticalFovRadians = 1.0, aspect = 1.0;
    double thetaRadians = 1.0, phiRadians = 1.0;
    bool areDegrees = false;   ///< the angles above
    double aspectHeight = 1.0; ///< the aspect is aspect / aspectHeight: a viewport's width and height
};

/// The arguments of glViewport and glDepthRange.
struct Target {
    double x = 0.0, y = 0.0, width = 1.0, height = 1.0;
    double depthAtNear = 0.0, depthAtFar = 1.0;
};

struct Stages {
    Vector3 eye;
    Vector4 clip;
    Vector3 ndc;
    Vector3 window;
};

Matrix4 lookAtMatrix(const View &view);
Matrix4 projectionMatrix(const Projection &projection);
Matrix4 targetMatrix(const Target &target);
Matrix4 product(const Matrix4 &a, const Matrix4 &b);

class Oracle {
public:
    Oracle(const View &view, const Projection &projection, const Target &target);
    /// Takes the matrices of a program, 16 numbers column by column.
    /// @param zeroToOne  NDC depths go from 0 to 1: d = dn + z_n (df - dn)
    Oracle(const std::array<double, 16> &eyeFromWorld, const std::array<double, 16> &clipFromEye, const Target &target,
           bool zeroToOne);

    Stages forward(const Vector3 &world) const;
    /// @param window  origin bottom-left; its depth in the target's depth range
    Vector3 eyeUnder(const std::array<double, 3> &window) const;
    Vector3 worldUnder(const std::array<double, 3> &window) const;
    Vector3 eyeAt(const Vector3 &window) const;
    Vector3 worldAt(const Vector3 &window) const;

    const Matrix4 &eyeFromWorld() const { return m_eyeFromWorld; }
    const Matrix4 &clipFromEye() const { return m_clipFromEye; }

private:
    Matrix4 m_eyeFromWorld;
    Matrix4 m_clipFromEye;
    Matrix4 m_windowFromNdc;
    Matrix4 m_windowFromEye;
    Matrix4 m_windowFromWorld;
};

/// The largest absolute component.
Extended maxNorm(const Vector3 &v);
Vector3 difference(const Vector3 &a, const Vector3 &b);

} // namespace oracle
