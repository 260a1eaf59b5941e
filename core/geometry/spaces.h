#pragma once

#include "core/geometry/components.h"
#include "core/geometry/numbers.h"

#include <glm/geometric.hpp>

#include <concepts>

/// The coordinate spaces. The whole project uses these names.
///
///   object  a mesh's own coordinates
///   world   the scene
///   eye     right-handed, origin at the eye, looking down -z, y up
///   clip    homogeneous, after the projection matrix, before the divide by w
///   NDC     [-1, 1]^3, left-handed: z grows away from the eye
///   window  device pixels, origin at the bottom-left corner, y up, depth in the depth range
///   device  device pixels, origin at the top-left corner, y down (as a screenshot counts its rows)
///   widget  logical pixels, origin at the top-left corner, y down; times the pixel ratio = device
///
/// Vectors are columns, `M * v`. A transform is named targetFromSource, so that in a product the
/// inner names match: `clipFromWorld = clipFromEye * eyeFromWorld`.
///
/// Pixel (i, j) covers [i, i+1) x [j, j+1). Its centre is (i + 1/2, j + 1/2), where OpenGL samples
/// colour and depth.
namespace unprojector::geometry {

struct ObjectSpace {
    static constexpr int kDimension = 3;
};
struct WorldSpace {
    static constexpr int kDimension = 3;
};
struct EyeSpace {
    static constexpr int kDimension = 3;
};
struct ClipSpace {
    static constexpr int kDimension = 4;
};
struct NdcSpace {
    static constexpr int kDimension = 3;
};
struct WindowSpace {
    static constexpr int kDimension = 3;
};
struct DeviceSpace {
    static constexpr int kDimension = 2;
};
struct WidgetSpace {
    static constexpr int kDimension = 2;
};

/// A position in a space: an eye, a pixel, a vertex of a model. The default is the origin.
template <class Space>
struct Point : Components<Space::kDimension> {
    using Components<Space::kDimension>::Components;
};

/// A space with vectors: all but clip space, whose points are homogeneous. Their difference is
/// defined only after the divide by w, in NDC.
template <class Space>
concept Affine = !std::same_as<Space, ClipSpace>;

/// A displacement, independent of the start: an offset, an axis, "up". If the origin of the space
/// moved, its points would get new coordinates and its vectors would keep theirs. The default has
/// length 0.
template <Affine Space>
struct Vector : Components<Space::kDimension> {
    using Components<Space::kDimension>::Components;
};

// The operations, all within one space:
//
//   point - point = vector       from the second to the first
//   point + vector = point       -, +=, -=
//   vector + vector = vector     -, +=, -=, and -vector
//   vector * number = vector     number * vector, vector / number
//   point == point, vector == vector
//   distance of two points; dot, cross, length and normalized of vectors
//
// Nothing else compiles: no sum or multiple of points, no length of a point, nothing between two
// spaces.

template <Affine Space>
constexpr Vector<Space> operator-(const Point<Space> &to, const Point<Space> &from)
{
    return Vector<Space>(to.coordinates() - from.coordinates());
}
template <Affine Space>
constexpr Point<Space> operator+(const Point<Space> &p, const Vector<Space> &v)
{
    return Point<Space>(p.coordinates() + v.coordinates());
}
template <Affine Space>
constexpr Point<Space> operator-(const Point<Space> &p, const Vector<Space> &v)
{
    return Point<Space>(p.coordinates() - v.coordinates());
}
template <Affine Space>
constexpr Point<Space> &operator+=(Point<Space> &p, const Vector<Space> &v)
{
    return p = p + v;
}
template <Affine Space>
constexpr Point<Space> &operator-=(Point<Space> &p, const Vector<Space> &v)
{
    return p = p - v;
}

template <Affine Space>
constexpr Vector<Space> operator+(const Vector<Space> &a, const Vector<Space> &b)
{
    return Vector<Space>(a.coordinates() + b.coordinates());
}
template <Affine Space>
constexpr Vector<Space> operator-(const Vector<Space> &a, const Vector<Space> &b)
{
    return Vector<Space>(a.coordinates() - b.coordinates());
}
template <Affine Space>
constexpr Vector<Space> operator-(const Vector<Space> &v)
{
    return Vector<Space>(-v.coordinates());
}
template <Affine Space>
constexpr Vector<Space> &operator+=(Vector<Space> &a, const Vector<Space> &b)
{
    return a = a + b;
}
template <Affine Space>
constexpr Vector<Space> &operator-=(Vector<Space> &a, const Vector<Space> &b)
{
    return a = a - b;
}
template <Affine Space>
constexpr Vector<Space> operator*(const Vector<Space> &v, double factor)
{
    return Vector<Space>(v.coordinates() * factor);
}
template <Affine Space>
constexpr Vector<Space> operator*(double factor, const Vector<Space> &v)
{
    return Vector<Space>(factor * v.coordinates());
}
template <Affine Space>
constexpr Vector<Space> operator/(const Vector<Space> &v, double divisor)
{
    return Vector<Space>(v.coordinates() / divisor);
}

template <class Space>
constexpr bool operator==(const Point<Space> &a, const Point<Space> &b)
{
    return a.coordinates() == b.coordinates();
}
template <Affine Space>
constexpr bool operator==(const Vector<Space> &a, const Vector<Space> &b)
{
    return a.coordinates() == b.coordinates();
}

template <Affine Space>
double dot(const Vector<Space> &a, const Vector<Space> &b)
{
    return glm::dot(a.coordinates(), b.coordinates());
}
template <Affine Space>
requires(Space::kDimension == 3) Vector<Space> cross(const Vector<Space> &a, const Vector<Space> &b)
{
    return Vector<Space>(glm::cross(a.coordinates(), b.coordinates()));
}
template <Affine Space>
double length(const Vector<Space> &v)
{
    return glm::length(v.coordinates());
}
/// The vector of length 1 that points the same way.
/// @pre v is not 0
template <Affine Space>
Vector<Space> normalized(const Vector<Space> &v)
{
    return Vector<Space>(glm::normalize(v.coordinates()));
}
template <Affine Space>
double distance(const Point<Space> &a, const Point<Space> &b)
{
    return length(a - b);
}

using ObjectPoint = Point<ObjectSpace>;
using WorldPoint = Point<WorldSpace>;
using EyePoint = Point<EyeSpace>;
using ClipPoint = Point<ClipSpace>;
using NdcPoint = Point<NdcSpace>;
using WindowPoint = Point<WindowSpace>;
using DevicePoint = Point<DeviceSpace>;
using WidgetPoint = Point<WidgetSpace>;

using WorldVector = Vector<WorldSpace>;
using EyeVector = Vector<EyeSpace>;

/// One pixel of the framebuffer: column i from the left, row j from the top.
struct DevicePixel {
    int i = 0;
    int j = 0;
    friend bool operator==(const DevicePixel &, const DevicePixel &) = default;
};

/// A point before rounding, for a further step to another space.
template <class Space>
struct PrecisePoint {
    DoubleDouble x, y, z;

    PrecisePoint() = default;
    PrecisePoint(const DoubleDouble &ofX, const DoubleDouble &ofY, const DoubleDouble &ofZ) : x(ofX), y(ofY), z(ofZ) {}
    PrecisePoint(const Point<Space> &point) : x(point.x), y(point.y), z(point.z) {} // every point is one

    Point<Space> rounded() const { return Point<Space>(x.value, y.value, z.value); }
};

} // namespace unprojector::geometry
