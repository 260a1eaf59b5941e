#pragma once

#include "core/geometry/components.h"
#include "core/geometry/result.h"

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include <cmath>
#include <cstddef>
#include <initializer_list>
#include <optional>

namespace unprojector::geometry {

/// The first NaN or infinity among numbers; empty if all are finite.
inline std::optional<double> firstNotFinite(std::initializer_list<double> values)
{
    for (const double value : values) {
        if (!std::isfinite(value))
            return value;
    }
    return std::nullopt;
}

template <std::size_t Count>
std::optional<double> firstNotFinite(const double (&values)[Count])
{
    for (const double value : values) {
        if (!std::isfinite(value))
            return value;
    }
    return std::nullopt;
}

/// The first NaN or infinity among the components of a GLM vector.
template <class Vector>
requires requires(const Vector &v)
{
    v.length();
    v.x;
}
std::optional<double> firstNotFinite(const Vector &v)
{
    for (int i = 0; i < v.length(); ++i) {
        if (!std::isfinite(v[i]))
            return static_cast<double>(v[i]);
    }
    return std::nullopt;
}

/// The first NaN or infinity among the components of a point or a vector.
template <int Dimension>
std::optional<double> firstNotFinite(const Components<Dimension> &components)
{
    return firstNotFinite(components.coordinates());
}

/// The first NaN or infinity in a matrix, column by column.
inline std::optional<double> firstNotFinite(const glm::dmat4 &m)
{
    for (int column = 0; column < 4; ++column) {
        if (const std::optional<double> value = firstNotFinite(m[column]))
            return value;
    }
    return std::nullopt;
}

/// Checks that all entries are finite.
/// @return NotFinite with the index of the entry among the 16, column by column
inline Check checkFinite(const glm::dmat4 &m)
{
    for (int i = 0; i < 16; ++i) {
        if (!std::isfinite(m[i / 4][i % 4]))
            return Error{ErrorCode::NotFinite, m[i / 4][i % 4], double(i)};
    }
    return std::monostate{};
}

template <class Values>
bool isFinite(const Values &values)
{
    return !firstNotFinite(values).has_value();
}
inline bool isFinite(std::initializer_list<double> values)
{
    return !firstNotFinite(values).has_value();
}

} // namespace unprojector::geometry
