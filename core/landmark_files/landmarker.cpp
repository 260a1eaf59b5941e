// .ljson of landmarker.io and menpo, versions 1 to 3: points without names of their own, in groups
// with labels.

#include "core/base/json_fields.h"
#include "core/base/number_text.h"
#include "core/base/translation.h"
#include "core/landmark_files/lines.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace unprojector::landmark_files {
using namespace landmarks;
using base::Json;
using base::marked;
using base::tr;
namespace {

struct Room {};
using Reader = base::JsonReader<Room>;

struct Position {
    std::optional<geometry::WorldPoint> world;
};
using Positions = std::vector<Position>;

struct Label {
    std::string text;
    std::vector<std::size_t> mask; ///< indices of its points
};

/// True for null and three times null.
bool isMissing(const Json &point)
{
    return point.is_null()
           || (point.is_array() && point.size() == 3
               && std::all_of(point.begin(), point.end(), [](const Json &value) { return value.is_null(); }));
}

void readPosition(Reader &json, Position &position)
{
    if (json.exists() && json.json().is_array() && json.json().size() == 2)
        json.fail(tr("has two coordinates: these are points in an image, not in space"));
    if (json.exists() && isMissing(json.json()))
        return;
    glm::dvec3 v(0.0);
    json.value(v);
    position.world = geometry::WorldPoint(v);
}

/// Parses the index of one of the points.
std::size_t indexOf(const Reader &json, std::size_t count)
{
    const double index = json.number();
    if (!(index >= 0.0 && index < static_cast<double>(count) && index == std::floor(index)))
        json.fail(
            tr(count == 1 ? "is %1; there is %2 point, counted from 0" : "is %1; there are %2 points, counted from 0",
               base::shortestText(index), count));
    return static_cast<std::size_t>(index);
}

/// The name of a point of a label: the label if it has one point, else the label with the point's
/// number.
std::string nameOf(const std::string &label, std::size_t index, std::size_t count)
{
    return count == 1 ? label : label + '_' + std::to_string(index + 1);
}

void noteLinks(const Json &object, Notes &notes)
{
    if (object.contains("connectivity") && object["connectivity"].is_array())
        notes.add({marked("%1 line between two points is left out"), marked("%1 lines between points are left out")},
                  object["connectivity"].size());
}

/// Parses {"labels": [{"label": "eye", "mask": [0, 1]}], "landmarks": {"points": [[x, y, z]],
/// "connectivity": […]}}.
LandmarkSet setOf(Reader &json, Notes &notes)
{
    Positions positions;
    json.object("landmarks", [&](Reader &object) {
        object.required("points", positions, readPosition);
        noteLinks(object.json(), notes);
    });
    LandmarkSet set;
    for (const Position &position : positions)
        set.landmarks.emplace_back().world = position.world;
    std::vector<Label> labels;
    json.optional("labels", labels, [&positions](Reader &object, Label &label) {
        object.required("label", label.text);
        object.required("mask", label.mask, [&positions](Reader &element, std::size_t &index) {
            index = indexOf(element, positions.size());
        });
    });
    // A point may have several labels, including "all". The one with the fewest points is the most
    // specific.
    std::vector<std::size_t> fewest(positions.size(), positions.size() + 1);
    for (const auto &[text, mask] : labels) {
        for (std::size_t k = 0; k < mask.size(); ++k) {
            if (mask.size() >= fewest[mask[k]])
                continue;
            fewest[mask[k]] = mask.size();
            set.landmarks[mask[k]].name = nameOf(text, k, mask.size());
        }
    }
    return set;
}

/// Parses a list of {"label": "eye", "landmarks": [{"point": [x, y, z]}], "connectivity": […]}.
LandmarkSet firstVersion(Reader &json, Notes &notes)
{
    LandmarkSet set;
    for (std::size_t i = 0; i < json.size(); ++i) {
        Reader group(json, i);
        std::string label;
        Positions positions;
        group.required("label", label);
        group.required("landmarks", positions,
                       [](Reader &object, Position &position) { object.required("point", position, readPosition); });
        noteLinks(group.json(), notes);
        for (std::size_t k = 0; k < positions.size(); ++k) {
            Landmark &landmark = set.landmarks.emplace_back();
            landmark.name = nameOf(label, k, positions.size());
            landmark.world = positions[k].world;
        }
    }
    return set;
}

} // namespace

ReadLandmarks readLandmarker(std::string_view text)
{
    const auto document = base::parseJson(text);
    if (!document)
        throw document.error();
    Reader json(*document, text);
    ReadLandmarks read;
    Notes notes;
    if (document->contains("groups") && !(*document)["groups"].empty()) {
        json.object("groups", [&](Reader &groups) {
            if (groups.json().is_array()) {
                read.sets.push_back(firstVersion(groups, notes));
                return;
            }
            groups.requireObject();
            for (const auto &member : groups.json().items()) {
                groups.object(member.key(), [&](Reader &group) { read.sets.push_back(setOf(group, notes)); });
                if (groups.json().size() > 1)
                    read.sets.back().name = member.key();
            }
        });
    } else if (document->contains("landmarks")) {
        read.sets.push_back(setOf(json, notes));
    } else {
        fail(0, tr("there are neither \"landmarks\" nor \"groups\", which hold the points of landmarker.io; is it "
                   "another file?"));
    }
    read.notes = notes.take();
    return read;
}

} // namespace unprojector::landmark_files
