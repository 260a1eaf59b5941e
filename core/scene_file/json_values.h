#pragma once

#include "core/geometry/api_conventions.h"
#include "core/geometry/camera.h"
#include "core/geometry/matrix_projection.h"
#include "core/geometry/transform.h"
#include "core/geometry/viewport.h"
#include "core/scene_file/json_node.h"
#include "core/scene_file/json_text.h"

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <filesystem>
#include <span>
#include <string>

namespace unprojector::scene_file {

// Forms: the JSON of values that are no objects. A form has `void read(const JsonNode &, T &)` and
// `Json write(const T &)`; numbers have all their digits.

/// The default form of a type.
struct Plain {
    using Json = nlohmann::ordered_json;

    static void read(const JsonNode &node, bool &value) { value = node.boolean(); }
    static void read(const JsonNode &node, double &value) { value = node.number(); }
    static void read(const JsonNode &node, std::string &value) { value = node.text(); }
    /// Not empty, without a zero byte.
    static void read(const JsonNode &node, std::filesystem::path &value);
    static void read(const JsonNode &node, glm::dvec2 &value);
    static void read(const JsonNode &node, glm::dvec3 &value);
    static void read(const JsonNode &node, glm::dvec4 &value);
    /// A point or a vector.
    template <int Dimension>
    static void read(const JsonNode &node, geometry::Components<Dimension> &value)
    {
        auto coordinates = value.coordinates();
        read(node, coordinates);
        value = geometry::Components<Dimension>(coordinates);
    }
    /// 16 numbers, column by column.
    static void read(const JsonNode &node, glm::dmat4 &value);
    /// [at near, at far]
    static void read(const JsonNode &node, geometry::DepthRange &value);
    /// [i, j]
    static void read(const JsonNode &node, geometry::DevicePixel &value);
    /// [-1, 1] or [0, 1]
    static void read(const JsonNode &node, geometry::NdcDepth &value);
    /// [degrees, x, y, z]
    static void read(const JsonNode &node, geometry::Rotate &value);

    static Json write(bool value) { return value; }
    static Json write(double value) { return jsonNumber(value); }
    static Json write(const std::string &value) { return value; }
    static Json write(const std::filesystem::path &value);
    static Json write(const glm::dvec2 &value);
    static Json write(const glm::dvec3 &value);
    static Json write(const glm::dvec4 &value);
    template <int Dimension>
    static Json write(const geometry::Components<Dimension> &value)
    {
        return write(value.coordinates());
    }
    static Json write(const glm::dmat4 &value);
    static Json write(const geometry::DepthRange &value);
    static Json write(const geometry::DevicePixel &value) { return Json::array({value.i, value.j}); }
    static Json write(geometry::NdcDepth value);
    static Json write(const geometry::Rotate &value);
};

/// A whole number within both ends.
struct Count {
    int lowest, highest;

    template <class Whole>
    void read(const JsonNode &node, Whole &value) const
    {
        value = static_cast<Whole>(node.count(lowest, highest));
    }
    template <class Whole>
    static nlohmann::ordered_json write(Whole value)
    {
        return value;
    }
};

/// One of some words, in the order of an enumeration's values.
struct Words {
    std::span<const char *const> words;

    template <class Enumeration>
    void read(const JsonNode &node, Enumeration &value) const
    {
        value = static_cast<Enumeration>(node.oneOf(words));
    }
    template <class Enumeration>
    nlohmann::ordered_json write(Enumeration value) const
    {
        return words[static_cast<std::size_t>(value)];
    }
};

/// NDC depths of an API, which may allow only one of them.
struct NdcDepthOf {
    geometry::Api api;

    void read(const JsonNode &node, geometry::NdcDepth &value) const;
    static nlohmann::ordered_json write(geometry::NdcDepth value) { return Plain::write(value); }
};

/// A text that must not be empty.
struct SomeText {
    static void read(const JsonNode &node, std::string &value);
    static nlohmann::ordered_json write(const std::string &value) { return value; }
};

/// A matrix that has an inverse.
struct InvertibleMatrix {
    static void read(const JsonNode &node, glm::dmat4 &value);
    static nlohmann::ordered_json write(const glm::dmat4 &value) { return Plain::write(value); }
};

/// (A, B, C, D), the first three not all 0.
struct ClipPlaneNumbers {
    static void read(const JsonNode &node, glm::dvec4 &value);
    static nlohmann::ordered_json write(const glm::dvec4 &value) { return Plain::write(value); }
};

/// Device pixels per logical pixel. The reader accepts values that give the window's smaller side
/// at least one device pixel after rounding, and its larger side at most `most` device pixels.
struct PixelRatio {
    int width, height; ///< logical pixels
    int most;          ///< device pixels

    void read(const JsonNode &node, double &value) const;
    static nlohmann::ordered_json write(double value) { return Plain::write(value); }
};

/// The version of the format, always the same.
struct Version {
    int readable;

    void read(const JsonNode &node, int &value) const;
    static nlohmann::ordered_json write(int value) { return value; }
};

} // namespace unprojector::scene_file
