#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <cstddef>
#include <type_traits>

/// The coordinate spaces, stated once. Everything else in the project uses these names.
///
///   object  a mesh's own coordinates
///   world   the scene
///   eye     right-handed, origin at the eye, looking down -z, y up
///   clip    homogeneous, after the projection matrix, before the divide by w
///   NDC     [-1, 1]^3, left-handed: z grows away from the eye
///   window  device pixels, origin at the bottom-left corner, y up, depth in the depth range
///   device  device pixels, origin at the top-left corner, y down (what a screenshot's row numbers count)
///   widget  logical pixels, origin at the top-left corner, y down; times the pixel ratio = device
///
/// Vectors are columns, `M * v`. A transform is named targetFromSource, so that in a product the inner
/// names meet: `clipFromWorld = clipFromEye * eyeFromWorld`.
///
/// Pixel (i, j) covers [i, i+1) x [j, j+1); its centre is (i + 1/2, j + 1/2), which is where OpenGL samples
/// colour and depth.
namespace unprojector::geometry {

struct ObjectSpace {
    using Coordinates = glm::dvec3;
};
struct WorldSpace {
    using Coordinates = glm::dvec3;
};
struct EyeSpace {
    using Coordinates = glm::dvec3;
};
struct ClipSpace {
    using Coordinates = glm::dvec4;
};
struct NdcSpace {
    using Coordinates = glm::dvec3;
};
struct WindowSpace {
    using Coordinates = glm::dvec3;
};
struct DeviceSpace {
    using Coordinates = glm::dvec2;
};
struct WidgetSpace {
    using Coordinates = glm::dvec2;
};

/// A position in one space. Points of different spaces do not convert into each other, so that mixing them up is
/// a compile error; a point reads as the GLM vector of its coordinates.
template <class Space>
struct Point : Space::Coordinates {
    using Coordinates = typename Space::Coordinates;

    Point() : Coordinates(0.0) {}
    /// One number a coordinate. GLM's own constructors are not taken over: they would let any vector become a point.
    template <class... Scalars>
    requires(sizeof...(Scalars) == static_cast<std::size_t>(Coordinates::length())
             && (std::is_arithmetic_v<Scalars> && ...)) Point(Scalars... scalars)
        : Coordinates(static_cast<double>(scalars)...)
    {
    }
    explicit Point(const Coordinates &coordinates) : Coordinates(coordinates) {}
    template <class Other>
    Point(const Point<Other> &) = delete;

    const Coordinates &coordinates() const { return *this; }
};

using ObjectPoint = Point<ObjectSpace>;
using WorldPoint = Point<WorldSpace>;
using EyePoint = Point<EyeSpace>;
using ClipPoint = Point<ClipSpace>;
using NdcPoint = Point<NdcSpace>;
using WindowPoint = Point<WindowSpace>;
using DevicePoint = Point<DeviceSpace>;
using WidgetPoint = Point<WidgetSpace>;

/// One pixel of the framebuffer: column i from the left, row j from the top.
struct DevicePixel {
    int i = 0;
    int j = 0;
    friend bool operator==(const DevicePixel &, const DevicePixel &) = default;
};

} // namespace unprojector::geometry
