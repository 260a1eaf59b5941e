// .mrk.json of 3D Slicer: lists of control points, and curves.

#include "core/base/json_fields.h"
#include "core/base/translation.h"
#include "core/landmark_files/csv_columns.h"
#include "core/landmark_files/lines.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

namespace unprojector::landmark_files {
using namespace geometry;
using namespace landmarks;
using base::marked;
using base::tr;
namespace {

using base::Is, base::Json, base::Words;

constexpr const char *kSchema = "https://raw.githubusercontent.com/slicer/slicer/master/Modules/Loadable/Markups/"
                                "Resources/Schema/markups-schema-v1.0.3.json#";
constexpr std::size_t kLeastBytes = 200; ///< of a point
constexpr const char *kUnits = "coordinateUnits", *kCurve = "Curve";
/// Keys that 3D Slicer does not know and ignores.
constexpr const char *kCurvePoints = "curvePoints", *kCurveWay = "curveKind", *kCurveCount = "curveCount";

/// A control point as in the file.
struct Point {
    enum class Status { Undefined, Preview, Defined, Missing };

    std::string label, description;
    std::optional<glm::dvec3> position;
    bool visibility = true;
    Status status = Status::Defined;
    base::JsonValue extra;
};
struct Markup {
    std::string name;
    Axes axes = Axes::Lps;
    std::vector<Point> points;
    base::JsonValue extra;
};
struct Document {
    std::string schema = kSchema;
    std::vector<Markup> markups;
    base::JsonValue extra;
};

/// True for a position of a missing point, as programs write one: null, "", "NA", [] or three times null.
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

template <class Fields, Is<Point> T>
void describe(Fields &json, T &point)
{
    static constexpr std::array kStatuses{"undefined", "preview", "defined", "missing"};
    json.optional("label", point.label);
    json.optional("description", point.description);
    json.optionalObject("position", [&point](Fields &position) {
        if constexpr (Fields::kReads) {
            if (isNoPosition(position.json()))
                return;
        }
        position.value(point.position);
    });
    json.optional("visibility", point.visibility);
    json.optional("positionStatus", point.status, Words{kStatuses});
}

template <class Fields, Is<Markup> T>
void describe(Fields &json, T &markup)
{
    static constexpr std::array kAxes{"LPS", "RAS"};
    json.unlessDefault("name", markup.name);
    json.optional("coordinateSystem", markup.axes, Words{kAxes});
    json.optional("controlPoints", markup.points);
}

template <class Fields, Is<Document> T>
void describe(Fields &json, T &document)
{
    json.optional("@schema", document.schema);
    json.optional("markups", document.markups);
}

/// The other values of a point, as 3D Slicer writes them for one that is not rotated.
Json usualValues(Axes axes, std::size_t number)
{
    const int sign = axes == Axes::Lps ? -1 : 1;
    return {{"id", std::to_string(number + 1)},
            {"associatedNodeID", ""},
            {"orientation", Json{sign, 0, 0, 0, sign, 0, 0, 0, 1}},
            {"selected", true},
            {"locked", false}};
}

void removeUsual(base::JsonValue &extra, Axes axes, std::size_t number)
{
    const Json usual = usualValues(axes, number);
    for (const auto &[key, value] : usual.items()) {
        if (extra.json().contains(key) && extra.json()[key] == value)
            takenFrom(extra, key.c_str());
    }
}

Landmark landmarkOf(Point &&point, Axes axes, std::size_t number, Notes &notes)
{
    Landmark landmark;
    landmark.name = std::move(point.label);
    landmark.note = std::move(point.description);
    landmark.isHidden = !point.visibility;
    landmark.extra = std::move(point.extra);
    removeUsual(landmark.extra, axes, number);
    const bool isDefined = point.status == Point::Status::Defined;
    if (point.status == Point::Status::Missing)
        landmark.absence = Absence::Missing;
    if (isDefined && point.position)
        landmark.world = turned(WorldPoint(*point.position), axes);
    else if (point.status == Point::Status::Preview)
        notes.add(kPreviewsLeftOut);
    else if (point.position && *point.position != glm::dvec3(0.0))
        notes.add(kHadPosition);
    return landmark;
}

/// The unit of a markup: a word, the same word for each axis, or a code of UCUM with its meaning, as a
/// list or an object. Nothing for other values.
std::optional<std::string> unitOf(const Json &value)
{
    constexpr std::size_t kCount = 3; // axes, or code, scheme and meaning
    if (value.is_string())
        return value.get<std::string>();
    if (value.is_object() && value.contains("CodeValue") && value["CodeValue"].is_string())
        return value["CodeValue"].get<std::string>();
    const bool isList = value.is_array() && value.size() == kCount
                        && std::all_of(value.begin(), value.end(), [](const Json &each) { return each.is_string(); });
    if (isList && (value[1] == "UCUM" || (value[0] == value[1] && value[0] == value[2])))
        return value[0].get<std::string>();
    return std::nullopt;
}

/// Removes the unit from a markup's other values, if it is understood.
std::string takeUnit(base::JsonValue &extra)
{
    std::optional<std::string> unit = extra.json().contains(kUnits) ? unitOf(extra.json()[kUnits]) : std::nullopt;
    if (unit)
        takenFrom(extra, kUnits);
    return unit.value_or(std::string());
}

/// True if each control point is a semilandmark as this program writes them: "NAME:01" and so on.
/// The control points of another curve stay points, since each has a name of its own.
bool isOurCurve(const Markup &markup)
{
    const Json &extra = markup.extra.json();
    if (!extra.contains("type") || extra["type"] != kCurve)
        return false;
    const std::vector<Point> &points = markup.points;
    if (points.empty())
        return extra.contains(kCurveCount);
    const std::string &last = points.back().label;
    const std::string name = last.substr(0, last.rfind(':'));
    for (std::size_t i = 0; i < points.size(); ++i) {
        const bool isPlaced = points[i].position && points[i].status == Point::Status::Defined;
        if (!isPlaced || points[i].label != semilandmarkName(name, i, points.size()))
            return false;
    }
    return points.size() >= 2 && points.size() <= kMostSemilandmarks;
}

Curve curveOf(Markup &&markup, Notes &notes)
{
    Curve curve;
    curve.name = std::move(markup.name);
    // 3D Slicer keeps neither the name nor keys that it does not know.
    if (curve.name.empty() && !markup.points.empty() && !markup.extra.json().contains(kCurveCount))
        curve.name = markup.points.front().label.substr(0, markup.points.front().label.rfind(':'));
    curve.extra = std::move(markup.extra);
    takenFrom(curve.extra, "type");
    takeUnit(curve.extra); // the set's
    const Json names = takenFrom(curve.extra, kCurvePoints), kind = takenFrom(curve.extra, kCurveWay),
               count = takenFrom(curve.extra, kCurveCount);
    if (names.is_array()
        && std::all_of(names.begin(), names.end(), [](const Json &name) { return name.is_string(); })) {
        for (const Json &name : names)
            curve.points.push_back(name.get<std::string>());
    }
    if (kind == csv::kCurveKinds[static_cast<std::size_t>(CurveKind::PlaneSection)])
        curve.kind = CurveKind::PlaneSection;
    if (count.is_number_unsigned() && count >= 2u && count <= unsigned{kMostSemilandmarks})
        curve.count = count.get<std::uint32_t>();
    for (std::size_t i = 0; i < markup.points.size(); ++i) {
        Point &point = markup.points[i];
        curve.semilandmarks.push_back(turned(WorldPoint(*point.position), markup.axes));
        removeUsual(point.extra, markup.axes, i);
        if (!point.description.empty() || !point.visibility || !point.extra.json().is_null())
            notes.add(kCurveCellsLeftOut);
    }
    if (!curve.semilandmarks.empty())
        curve.count = static_cast<std::uint32_t>(curve.semilandmarks.size());
    return curve;
}

LandmarkSet setOf(Markup &&markup, Notes &notes)
{
    LandmarkSet set;
    set.name = std::move(markup.name);
    set.axes = markup.axes;
    set.extra = std::move(markup.extra);
    set.unit = takeUnit(set.extra); // others stay unchanged
    if (set.extra.json().contains("type") && set.extra.json()["type"] == "Fiducial")
        takenFrom(set.extra, "type");
    for (std::size_t i = 0; i < markup.points.size(); ++i)
        set.landmarks.push_back(landmarkOf(std::move(markup.points[i]), set.axes, i, notes));
    if (set.axes == Axes::Ras && !set.landmarks.empty())
        notes.add(kAxesFlipped);
    return set;
}

} // namespace

ReadLandmarks readSlicerJson(std::string_view text)
{
    const auto json = base::parseJson(text);
    if (!json)
        throw json.error();
    if (!json->contains("markups"))
        fail(1, tr("there is no list \"markups\", which holds the points of 3D Slicer; is it another file?"));
    auto described = base::valueOfJson<Markup, Document>(*json, text, {});
    if (!described)
        throw described.error();
    Document document = std::move(described).value();
    ReadLandmarks read;
    Notes notes;
    for (Markup &markup : document.markups) {
        if (!isOurCurve(markup)) {
            read.sets.push_back(setOf(std::move(markup), notes));
            continue;
        }
        if (read.sets.empty()) { // a file with a curve alone
            LandmarkSet &set = read.sets.emplace_back();
            set.axes = markup.axes;
            if (const Json &extra = markup.extra.json(); extra.contains(kUnits) && extra[kUnits].is_string())
                set.unit = extra[kUnits].get<std::string>();
            if (set.axes == Axes::Ras)
                notes.add(kAxesFlipped);
        }
        read.sets.back().curves.push_back(curveOf(std::move(markup), notes));
    }
    if (read.sets.empty())
        fail(1, tr("the list \"markups\" is empty; there are no points"));
    for (auto it = document.extra.json().begin(); it != document.extra.json().end(); ++it)
        notes.addSpecimenKeys(it.key());
    read.notes = notes.take();
    return read;
}

namespace {

Point pointOf(const Landmark &landmark, Axes axes, std::size_t number)
{
    const Point::Status status = landmark.isPlaced()    ? Point::Status::Defined
                                 : landmark.isMissing() ? Point::Status::Missing
                                                        : Point::Status::Undefined;
    Point point{landmark.name,      landmark.note, glm::dvec3(0.0),
                !landmark.isHidden, status,        base::JsonValue(usualValues(axes, number))};
    if (landmark.world)
        point.position = turned(*landmark.world, axes).coordinates();
    if (landmark.extra.json().is_object())
        point.extra.edit().update(landmark.extra.json());
    return point;
}

/// A curve with both ends: 3D Slicer leads it through its own points.
Markup markupOf(const Curve &curve, std::size_t index, const LandmarkSet &set)
{
    Markup markup{curve.name, set.axes, {}, base::JsonValue(Json::object())};
    Json &extra = markup.extra.edit();
    extra["type"] = kCurve;
    if (!set.unit.empty())
        extra[kUnits] = set.unit;
    if (!curve.points.empty())
        extra[kCurvePoints] = curve.points;
    extra[kCurveWay] = csv::kCurveKinds[static_cast<std::size_t>(curve.kind)];
    extra[kCurveCount] = curve.count;
    if (curve.extra.json().is_object())
        extra.update(curve.extra.json());
    for (std::size_t i = 0; i < curve.semilandmarks.size(); ++i) {
        Landmark landmark;
        landmark.name = semilandmarkName(nameOf(curve, index), i, curve.semilandmarks.size());
        landmark.world = curve.semilandmarks[i];
        markup.points.push_back(pointOf(landmark, set.axes, i));
    }
    return markup;
}

} // namespace

std::string slicerJsonText(std::span<const LandmarkSet> sets, Notes &notes)
{
    std::size_t points = 0;
    for (const LandmarkSet &set : sets) {
        points += set.landmarks.size();
        for (const Curve &curve : set.curves)
            points += curve.semilandmarks.size();
    }
    checkSize(points * kLeastBytes); // before gigabytes are built
    Document document;
    for (const LandmarkSet &set : sets) {
        Markup markup{set.name, set.axes, {}, base::JsonValue(Json::object())};
        const Json &kept = set.extra.json();
        Json &extra = markup.extra.edit();
        if (!kept.contains("type"))
            extra["type"] = "Fiducial";
        if (!set.unit.empty())
            extra[kUnits] = set.unit;
        if (kept.is_object())
            extra.update(kept);
        for (std::size_t i = 0; i < set.landmarks.size(); ++i) {
            const Landmark &landmark = set.landmarks[i];
            if (landmark.absence == Absence::Skipped)
                notes.add(kSkippedLeftOut);
            markup.points.push_back(pointOf(landmark, set.axes, i));
        }
        document.markups.push_back(std::move(markup));
        for (std::size_t i = 0; i < set.curves.size(); ++i)
            document.markups.push_back(markupOf(set.curves[i], i, set));
        if (!set.unit.empty() && set.unit != "mm")
            notes.add({marked("3D Slicer takes coordinates for mm, and these are in %1; they are not converted")}, 1,
                      {set.unit});
    }
    const auto text = base::readableJson(base::jsonOfValue<Markup>(document));
    if (!text)
        fail(0, tr("%1 is not UTF-8 and cannot be written as JSON; rename it", text.error().subject));
    return *text;
}

} // namespace unprojector::landmark_files
