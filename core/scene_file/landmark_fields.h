#pragma once

#include "core/landmarks/landmark.h"
#include "core/scene_file/json_fields.h"

#include <array>
#include <cstdint>
#include <limits>

namespace unprojector::scene_file {

// The keys of the landmarks of a scene file; scene_fields.h has the others. Empty values are not
// written.

/// The number of a triangle or a vertex.
struct ElementNumber {
    static void read(const JsonNode &node, std::uint32_t &number);
    static nlohmann::ordered_json write(std::uint32_t number) { return number; }
};
/// The numbers of an edge's two vertices.
struct EdgeNumbers {
    static void read(const JsonNode &node, std::array<std::uint32_t, 2> &vertices);
    static nlohmann::ordered_json write(const std::array<std::uint32_t, 2> &vertices);
};
/// [red, green, blue], each from 0 to 255.
struct ColorNumbers {
    static void read(const JsonNode &node, glm::u8vec3 &color);
    static nlohmann::ordered_json write(const glm::u8vec3 &color);
};

template <class Fields, class Text>
void describeText(Fields &json, const char *key, Text &text)
{
    if (json.has(key, !text.empty()))
        json.required(key, text);
}

template <class Fields, Is<landmarks::Anchor> T>
void describe(Fields &json, T &hold)
{
    static constexpr std::array kKinds{"triangle", "vertex", "edge"};
    const auto held = [&hold]<class Kind>(const Kind *) -> auto &
    {
        if constexpr (!std::is_const_v<T>)
            hold = Kind{};
        return std::get<Kind>(hold);
    };
    // Free comes first in the variant, and is not written.
    switch (json.oneKeyOf(kKinds, hold.index() - 1)) {
    case 0: {
        auto &triangle = held(static_cast<const landmarks::OnTriangle *>(nullptr));
        json.required(kKinds[0], triangle.triangle, ElementNumber{});
        json.required("barycentric", triangle.barycentric);
        break;
    }
    case 1:
        json.required(kKinds[1], held(static_cast<const landmarks::AtVertex *>(nullptr)).vertex, ElementNumber{});
        break;
    default: {
        auto &edge = held(static_cast<const landmarks::OnEdge *>(nullptr));
        json.required(kKinds[2], edge.vertices, EdgeNumbers{});
        json.required("share", edge.share);
        break;
    }
    }
}

template <class Fields, Is<landmarks::Landmark> T>
void describe(Fields &json, T &landmark)
{
    static constexpr std::array kAbsences{"notPlaced", "skipped", "missing"};
    json.optional("name", landmark.name);
    json.nullable("position", landmark.world);
    if (!landmark.world && json.has("absence", landmark.absence != landmarks::Absence::NotPlaced))
        json.required("absence", landmark.absence, Words{kAbsences});
    describeText(json, "object", landmark.object);
    if (json.has("held", !std::holds_alternative<landmarks::Free>(landmark.anchor)))
        json.required("held", landmark.anchor);
    json.optional("uncertainty", landmark.uncertainty);
    describeText(json, "note", landmark.note);
    json.optional("color", landmark.color, ColorNumbers{});
    if (json.has("hidden", landmark.isHidden))
        json.required("hidden", landmark.isHidden);
}

template <class Fields, Is<landmarks::Curve> T>
void describe(Fields &json, T &curve)
{
    static constexpr std::array kKinds{"geodesic", "planeSection"};
    json.optional("name", curve.name);
    json.list("points", curve.points);
    json.required("kind", curve.kind, Words{kKinds});
    json.required("count", curve.count, Count{2, landmarks::kMostSemilandmarks});
    if (json.has("semilandmarks", !curve.semilandmarks.empty()))
        json.list("semilandmarks", curve.semilandmarks);
}

template <class Fields, Is<landmarks::KeptMeasure> T>
void describe(Fields &json, T &measure)
{
    static constexpr std::array kKinds{"distance", "angle", "height", "length", "surface"};
    json.required("name", measure.name);
    json.required("kind", measure.kind, Words{kKinds});
    json.list("landmarks", measure.landmarks);
}

template <class Fields, Is<landmarks::LandmarkSet> T>
void describe(Fields &json, T &set)
{
    static constexpr std::array kAxes{"LPS", "RAS"};
    describeText(json, "name", set.name);
    describeText(json, "mesh", set.mesh);
    describeText(json, "unit", set.unit);
    if (json.has("axes", set.axes != landmarks::Axes::Lps))
        json.required("axes", set.axes, Words{kAxes});
    json.list("points", set.landmarks);
    if (json.has("curves", !set.curves.empty()))
        json.list("curves", set.curves);
    if (json.has("measures", !set.measures.empty()))
        json.list("measures", set.measures);
}

} // namespace unprojector::scene_file
