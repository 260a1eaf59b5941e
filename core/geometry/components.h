#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <concepts>

namespace unprojector::geometry {

/// The numbers of a point or a vector, without its space. They convert from and to GLM by name
/// only, as `WorldPoint(v)` and as `point.coordinates()`, so that the source shows each change of
/// space.
template <int Dimension>
struct Components;

template <>
struct Components<2> {
    double x = 0.0, y = 0.0;

    constexpr Components() = default;
    constexpr Components(double ofX, double ofY) : x(ofX), y(ofY) {}
    template <std::same_as<glm::dvec2> Exactly> // GLM would silently shorten a longer vector
    explicit constexpr Components(const Exactly &v) : x(v.x), y(v.y)
    {
    }

    constexpr glm::dvec2 coordinates() const { return {x, y}; }
    constexpr double &operator[](int i) { return i == 0 ? x : y; }
    constexpr double operator[](int i) const { return i == 0 ? x : y; }
};

template <>
struct Components<3> {
    double x = 0.0, y = 0.0, z = 0.0;

    constexpr Components() = default;
    constexpr Components(double ofX, double ofY, double ofZ) : x(ofX), y(ofY), z(ofZ) {}
    template <std::same_as<glm::dvec3> Exactly>
    explicit constexpr Components(const Exactly &v) : x(v.x), y(v.y), z(v.z)
    {
    }

    constexpr glm::dvec3 coordinates() const { return {x, y, z}; }
    constexpr double &operator[](int i) { return i == 0 ? x : i == 1 ? y : z; }
    constexpr double operator[](int i) const { return i == 0 ? x : i == 1 ? y : z; }
};

template <>
struct Components<4> {
    double x = 0.0, y = 0.0, z = 0.0, w = 0.0;

    constexpr Components() = default;
    constexpr Components(double ofX, double ofY, double ofZ, double ofW) : x(ofX), y(ofY), z(ofZ), w(ofW) {}
    template <std::same_as<glm::dvec4> Exactly>
    explicit constexpr Components(const Exactly &v) : x(v.x), y(v.y), z(v.z), w(v.w)
    {
    }

    constexpr glm::dvec4 coordinates() const { return {x, y, z, w}; }
    constexpr double &operator[](int i) { return i == 0 ? x : i == 1 ? y : i == 2 ? z : w; }
    constexpr double operator[](int i) const { return i == 0 ? x : i == 1 ? y : i == 2 ? z : w; }
};

} // namespace unprojector::geometry
