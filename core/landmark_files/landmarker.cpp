// .ljson of landmarker.io and menpo, versions 1 to 3: points without names of their own, in groups
// with labels.

#include "core/base/json.h"
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

/// @param key  key of the point, for the message
Landmark landmarkOf(const Json &point, const std::string &key)
{
    Landmark landmark;
    if (point.is_null())
        return landmark;
    if (point.is_array() && point.size() == 2)
        fail(0, tr("%1 has two coordinates: these are points in an image, not in space", key));
    if (!point.is_array() || point.size() != 3)
        fail(0, tr("%1 is not a point; write three numbers, or null for a missing one", key));
    if (std::all_of(point.begin(), point.end(), [](const Json &value) { return value.is_null(); }))
        return landmark;
    glm::dvec3 v(0.0);
    for (std::size_t i = 0; i < 3; ++i) {
        if (!base::isJsonNumber(point[i]))
            fail(0, tr("%1 is not a point; write three numbers, or null for a missing one", key));
        v[static_cast<int>(i)] = base::valueOfJsonNumber(point[i]);
    }
    landmark.world = geometry::WorldPoint(v);
    return landmark;
}

const Json &listOf(const Json &object, const char *name, const std::string &key)
{
    if (!object.is_object() || !object.contains(name) || !object[name].is_array())
        fail(0, tr("%1 has no list \"%2\"", key, name));
    return object[name];
}

std::string labelOf(const Json &object, const std::string &key)
{
    if (!object.is_object() || !object.contains("label") || !object["label"].is_string())
        fail(0, tr("%1 has no text \"%2\"", key, "label"));
    return object["label"].get<std::string>();
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
LandmarkSet setOf(const Json &group, const std::string &key, Notes &notes)
{
    LandmarkSet set;
    if (!group.is_object() || !group.contains("landmarks"))
        fail(0, tr("%1 has no \"landmarks\"; is it another file?", key));
    const Json &points = listOf(group["landmarks"], "points", key + "landmarks");
    noteLinks(group["landmarks"], notes);
    for (std::size_t i = 0; i < points.size(); ++i)
        set.landmarks.push_back(landmarkOf(points[i], key + "landmarks.points[" + std::to_string(i) + ']'));
    if (!group.contains("labels"))
        return set;
    // A point may have several labels, including "all". The one with the fewest points is the most
    // specific.
    std::vector<std::size_t> fewest(points.size(), points.size() + 1);
    const Json &labels = listOf(group, "labels", key + "labels");
    for (std::size_t i = 0; i < labels.size(); ++i) {
        const std::string place = key + "labels[" + std::to_string(i) + ']';
        const std::string label = labelOf(labels[i], place);
        const Json &mask = listOf(labels[i], "mask", place);
        for (std::size_t k = 0; k < mask.size(); ++k) {
            const std::size_t point =
                mask[k].is_number_unsigned() ? mask[k].get<std::size_t>() : std::size_t(points.size());
            if (point >= points.size())
                fail(0, tr("%1.mask names point %2, and there are %3, counted from 0", place,
                           base::compactJson(mask[k]), points.size()));
            if (mask.size() < fewest[point]) {
                fewest[point] = mask.size();
                set.landmarks[point].name = nameOf(label, k, mask.size());
            }
        }
    }
    return set;
}

/// Parses {"groups": [{"label": "eye", "landmarks": [{"point": [x, y, z]}], "connectivity": […]}]}.
LandmarkSet firstVersion(const Json &groups, Notes &notes)
{
    LandmarkSet set;
    for (std::size_t i = 0; i < groups.size(); ++i) {
        const std::string key = "groups[" + std::to_string(i) + ']';
        const std::string label = labelOf(groups[i], key);
        const Json &points = listOf(groups[i], "landmarks", key);
        noteLinks(groups[i], notes);
        for (std::size_t k = 0; k < points.size(); ++k) {
            const std::string place = key + ".landmarks[" + std::to_string(k) + ']';
            if (!points[k].is_object() || !points[k].contains("point"))
                fail(0, tr("%1 has no \"point\"", place));
            Landmark landmark = landmarkOf(points[k]["point"], place + ".point");
            landmark.name = nameOf(label, k, points.size());
            set.landmarks.push_back(std::move(landmark));
        }
    }
    return set;
}

} // namespace

ReadLandmarks readLandmarker(std::string_view text)
{
    const auto json = base::parseJson(text);
    if (!json)
        throw json.error();
    ReadLandmarks read;
    Notes notes;
    if (json->is_object() && json->contains("groups") && (*json)["groups"].is_object()) {
        const Json &groups = (*json)["groups"];
        for (auto it = groups.begin(); it != groups.end(); ++it) {
            read.sets.push_back(setOf(*it, "groups." + it.key() + '.', notes));
            if (groups.size() > 1)
                read.sets.back().name = it.key();
        }
    } else if (json->is_object() && json->contains("groups") && (*json)["groups"].is_array()) {
        read.sets.push_back(firstVersion((*json)["groups"], notes));
    } else if (json->is_object() && json->contains("landmarks")) {
        read.sets.push_back(setOf(*json, {}, notes));
    }
    if (read.sets.empty())
        fail(0,
             tr("there are neither \"landmarks\" nor \"groups\", which hold the points of landmarker.io; is it another "
                "file?"));
    read.notes = notes.take();
    return read;
}

} // namespace unprojector::landmark_files
