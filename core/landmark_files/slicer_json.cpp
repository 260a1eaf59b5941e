// .mrk.json of 3D Slicer: lists of control points.

#include "core/landmark_files/lines.h"
#include "core/scene_file/json_fields.h"
#include "core/scene_file/json_text.h"
#include "core/scene_file/scene_error_text.h"
#include "core/scene_file/strict_json.h"
#include "core/text/translation.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <set>
#include <utility>

namespace unprojector::landmark_files {
using namespace geometry;
using namespace landmarks;
using text::tr;
namespace {

using namespace scene_file;
using Json = nlohmann::ordered_json;

constexpr const char *kSchema = "https://raw.githubusercontent.com/slicer/slicer/master/Modules/Loadable/Markups/"
                                "Resources/Schema/markups-schema-v1.0.3.json#";
constexpr const char *kUnits = "coordinateUnits";

/// A control point as in the file.
struct Point {
    enum class Status { Undefined, Preview, Defined, Missing };

    std::string label, description;
    std::optional<glm::dvec3> position;
    bool visibility = true;
    Status status = Status::Defined;
    text::JsonValue extra;
};
struct Markup {
    std::string name;
    Axes axes = Axes::Lps;
    std::vector<Point> points;
    text::JsonValue extra;
};
struct Document {
    std::string schema = kSchema;
    std::vector<Markup> markups;
    text::JsonValue extra;
};

template <class Fields, Is<Point> T>
void describe(Fields &json, T &point)
{
    static constexpr std::array kStatuses{"undefined", "preview", "defined", "missing"};
    json.optional("label", point.label);
    json.optional("description", point.description);
    json.nullable("position", point.position);
    json.optional("visibility", point.visibility);
    json.optional("positionStatus", point.status, Words{kStatuses});
}

template <class Fields, Is<Markup> T>
void describe(Fields &json, T &markup)
{
    static constexpr std::array kAxes{"LPS", "RAS"};
    if (json.has("name", !markup.name.empty()))
        json.required("name", markup.name);
    json.optional("coordinateSystem", markup.axes, Words{kAxes});
    json.list("controlPoints", markup.points);
}

template <class Fields, Is<Document> T>
void describe(Fields &json, T &document)
{
    json.optional("@schema", document.schema);
    json.list("markups", document.markups);
}

/// The orientation that 3D Slicer writes for a point that is not rotated.
Json usualOrientation(Axes axes)
{
    return axes == Axes::Lps ? Json{-1, 0, 0, 0, -1, 0, 0, 0, 1} : Json{1, 0, 0, 0, 1, 0, 0, 0, 1};
}

/// Removes the keys of a point that have their default values.
void removeUsual(Json &extra, Axes axes, std::size_t number)
{
    if (!extra.is_object())
        return;
    const auto removeIf = [&extra](const char *key, const Json &usual) {
        if (extra.contains(key) && extra[key] == usual)
            extra.erase(key);
    };
    removeIf("id", std::to_string(number + 1));
    removeIf("associatedNodeID", "");
    removeIf("orientation", usualOrientation(axes));
    removeIf("selected", true);
    removeIf("locked", false);
    if (extra.empty())
        extra = nullptr;
}

Landmark landmarkOf(Point &&point, Axes axes, std::size_t number, Notes &notes)
{
    Landmark landmark;
    landmark.name = std::move(point.label);
    landmark.note = std::move(point.description);
    landmark.isHidden = !point.visibility;
    landmark.extra = std::move(point.extra);
    removeUsual(landmark.extra.edit(), axes, number);
    const bool isDefined = point.status == Point::Status::Defined || point.status == Point::Status::Preview;
    if (isDefined && point.position)
        landmark.world = turned(WorldPoint(*point.position), axes);
    else if (point.position && *point.position != glm::dvec3(0.0))
        notes.add(LandmarkNote::Kind::MissingHadPosition);
    return landmark;
}

LandmarkSet setOf(Markup &&markup, Notes &notes)
{
    LandmarkSet set;
    set.name = std::move(markup.name);
    set.axes = markup.axes;
    set.extra = std::move(markup.extra);
    if (Json &extra = set.extra.edit(); extra.is_object()) {
        if (extra.contains(kUnits) && extra[kUnits].is_string()) { // otherwise a code, which stays unchanged
            set.unit = extra[kUnits].get<std::string>();
            extra.erase(kUnits);
        }
        if (extra.contains("type") && extra["type"] == "Fiducial")
            extra.erase("type");
        if (extra.empty())
            extra = nullptr;
    }
    for (std::size_t i = 0; i < markup.points.size(); ++i)
        set.landmarks.push_back(landmarkOf(std::move(markup.points[i]), set.axes, i, notes));
    if (set.axes == Axes::Ras && !set.landmarks.empty())
        notes.add(LandmarkNote::Kind::AxesTurned);
    return set;
}

/// True if a value is a program's position of a missing point: "", "NA", [] or three times null.
bool isNoPosition(const Json &value)
{
    const auto isNothing = [](const Json &each) {
        return each.is_null()
               || (each.is_string()
                   && (trimmed(each.get_ref<const std::string &>()).empty()
                       || isMissingWord(trimmed(each.get_ref<const std::string &>()))));
    };
    return isNothing(value) || (value.is_array() && std::all_of(value.begin(), value.end(), isNothing));
}

/// Replaces each such position by null.
void clearNoPositions(Json &document)
{
    if (!document.is_object() || !document.contains("markups") || !document["markups"].is_array())
        return;
    for (Json &markup : document["markups"]) {
        if (!markup.is_object() || !markup.contains("controlPoints") || !markup["controlPoints"].is_array())
            continue;
        for (Json &point : markup["controlPoints"]) {
            if (point.is_object() && point.contains("position") && isNoPosition(point["position"]))
                point["position"] = nullptr;
        }
    }
}

} // namespace

Failure failureOf(SceneFileError error)
{
    const std::size_t line = std::exchange(error.line, 0);
    error.file.clear();
    std::string text = sceneErrorText(error);
    text.erase(0, text.find_first_not_of(": "));
    return {line, text,
            error.code == SceneFileErrorCode::TooLarge ? LandmarkFileError::Code::TooLarge
                                                       : LandmarkFileError::Code::Malformed};
}

ReadLandmarks readSlicerJson(std::string_view text)
{
    auto parsed = parseStrictJson(text, kMostLandmarkBytes);
    if (!parsed)
        throw failureOf(parsed.error());
    Json json = std::move(parsed).value();
    clearNoPositions(json);
    JsonNode::FirstError error;
    const JsonNode root(json, error);
    if (!json.is_object() || !json.contains("markups"))
        throw Failure{1, tr("there is no list \"markups\", which holds the points of 3D Slicer; is it another file?")};
    Document document;
    static_cast<void>(FieldReader::read(root, document, Plain{}));
    if (error)
        throw failureOf(*error);
    ReadLandmarks read;
    Notes notes;
    for (Markup &markup : document.markups)
        read.sets.push_back(setOf(std::move(markup), notes));
    if (read.sets.empty())
        throw Failure{1, tr("the list \"markups\" is empty; there are no points")};
    for (auto it = document.extra.json().begin(); it != document.extra.json().end(); ++it)
        notes.add(LandmarkNote::Kind::SpecimenKeysLeftOut, 1, it.key());
    read.notes = notes.take();
    return read;
}

std::string slicerJsonText(std::span<const LandmarkSet> sets, Notes &notes)
{
    addLosses(notes, sets,
              {.names = true,
               .notes = true,
               .hidden = true,
               .keys = true,
               .specimenKeys = true,
               .specimenName = true,
               .unit = true});
    Document document;
    for (const LandmarkSet &set : sets) {
        Markup markup{set.name, set.axes, {}, text::JsonValue(Json::object())};
        const Json &kept = set.extra.json();
        Json &extra = markup.extra.edit();
        if (!kept.is_object() || !kept.contains("type"))
            extra["type"] = "Fiducial";
        if (!set.unit.empty())
            extra[kUnits] = set.unit;
        if (kept.is_object())
            extra.update(kept);
        std::set<std::string> ids;
        for (std::size_t i = 0; i < set.landmarks.size(); ++i) {
            const Landmark &landmark = set.landmarks[i];
            Point point{landmark.name,
                        landmark.note,
                        glm::dvec3(0.0),
                        !landmark.isHidden,
                        landmark.world ? Point::Status::Defined : Point::Status::Undefined,
                        text::JsonValue(Json::object())};
            if (landmark.world)
                point.position = turned(*landmark.world, set.axes).coordinates();
            Json &pointExtra = point.extra.edit();
            pointExtra["id"] = std::to_string(i + 1);
            pointExtra["associatedNodeID"] = "";
            pointExtra["orientation"] = usualOrientation(set.axes);
            pointExtra["selected"] = true;
            pointExtra["locked"] = false;
            if (landmark.extra.json().is_object())
                pointExtra.update(landmark.extra.json());
            markup.points.push_back(std::move(point));
        }
        document.markups.push_back(std::move(markup));
    }
    const auto text = readableJson(FieldWriter::write(document, Plain{}, nullptr));
    if (!text)
        throw Failure{0, tr("%1 is not UTF-8 and cannot be written as JSON; rename it", text.error().keyPath),
                      LandmarkFileError::Code::CannotHold};
    return *text;
}

} // namespace unprojector::landmark_files
