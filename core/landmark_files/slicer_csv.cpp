// .fcsv of 3D Slicer: comments that say version and axes, then id,x,y,z,ow,ox,oy,oz,vis,sel,lock,label,desc,associatedNodeID.

#include "core/landmark_files/lines.h"
#include "core/mesh_import/text_scanner.h"
#include "core/scene_file/json_text.h"
#include "core/text/number_text.h"
#include "core/text/translation.h"

#include <nlohmann/json.hpp>

#include <array>

namespace unprojector::landmark_files {
using text::marked;
using text::tr;
namespace {

using Json = nlohmann::ordered_json;

constexpr std::array kOrientation{"ow", "ox", "oy", "oz"};
constexpr std::array kUsualOrientation{"0", "0", "0", "1"};

enum Field : std::size_t {
    Id,
    X,
    Y,
    Z,
    Orientation,
    Visible = 8,
    Selected,
    Locked,
    Label,
    Description,
    AssociatedNode,
    Status,
    AutoCreated
};
constexpr std::size_t kFieldCount = AutoCreated + 1;
/// Of newer files, the fifteenth field.
constexpr std::string_view kDefined = "2", kPreview = "1";

/// What follows a key in a comment: "# CoordinateSystem = LPS".
std::optional<std::string_view> valueOf(std::string_view comment, std::string_view key)
{
    const std::size_t equals = comment.find('=');
    if (equals == comment.npos || trimmed(comment.substr(1, equals - 1)) != key)
        return std::nullopt;
    return trimmed(comment.substr(equals + 1));
}

Axes axesOf(std::string_view word, std::size_t line)
{
    if (word == "LPS" || word == "1")
        return Axes::Lps;
    if (word == "RAS" || word == "0")
        return Axes::Ras;
    throw Failure{line, tr("the coordinate system is %1; it must be LPS or RAS (1 or 0)", mesh_import::quoted(word))};
}

bool flagOf(const std::string &cell, bool usual, std::size_t line, const char *what)
{
    if (cell.empty())
        return usual;
    if (cell == "0" || cell == "1")
        return cell == "1";
    throw Failure{line, tr("%1 is %2; it must be 0 or 1. Is there a comma in a label that is not in quotes?", tr(what),
                           mesh_import::quoted(cell))};
}

WorldPoint positionOf(const CsvRow &row, std::size_t first, Axes axes)
{
    glm::dvec3 v(0.0);
    for (int i = 0; i < 3; ++i)
        v[i] = numberOf(row.cells[first + std::size_t(i)], row.line, i == 0 ? "x" : i == 1 ? "y" : "z");
    return turned(WorldPoint(v), axes);
}

/// label,x,y,z,sel,vis: 3D Slicer 3, always in RAS.
Landmark oldLandmarkOf(CsvRow row)
{
    row.cells.resize(6);
    Landmark landmark;
    landmark.name = row.cells[0];
    landmark.world = positionOf(row, 1, Axes::Ras);
    if (!flagOf(row.cells[4], true, row.line, "sel"))
        landmark.extra.edit()["selected"] = false;
    landmark.isHidden = !flagOf(row.cells[5], true, row.line, "vis");
    return landmark;
}

Landmark landmarkOf(CsvRow row, Axes axes, std::size_t number, Notes &notes)
{
    row.cells.resize(kFieldCount);
    const auto &cells = row.cells;
    Landmark landmark;
    landmark.name = cells[Label];
    landmark.note = cells[Description];
    const WorldPoint position = positionOf(row, X, axes);
    const bool isDefined = cells[Status].empty() || cells[Status] == kDefined || cells[Status] == kPreview;
    if (isDefined)
        landmark.world = position;
    else if (!(position == WorldPoint()))
        notes.add(LandmarkNote::Kind::MissingHadPosition);
    landmark.isHidden = !flagOf(cells[Visible], true, row.line, "vis");
    if (!cells[Id].empty() && cells[Id] != std::to_string(number))
        landmark.extra.edit()["id"] = cells[Id];
    bool isTurned = false;
    for (std::size_t i = 0; i < kOrientation.size(); ++i)
        isTurned = isTurned || (!cells[Orientation + i].empty() && cells[Orientation + i] != kUsualOrientation[i]);
    for (std::size_t i = 0; i < kOrientation.size() && isTurned; ++i) {
        static_cast<void>(numberOf(cells[Orientation + i], row.line, kOrientation[i]));
        landmark.extra.edit()[kOrientation[i]] = cells[Orientation + i];
    }
    if (!flagOf(cells[Selected], true, row.line, "sel"))
        landmark.extra.edit()["selected"] = false;
    if (flagOf(cells[Locked], false, row.line, "lock"))
        landmark.extra.edit()["locked"] = true;
    if (!cells[AssociatedNode].empty())
        landmark.extra.edit()["associatedNodeID"] = cells[AssociatedNode];
    if (flagOf(cells[AutoCreated], false, row.line, marked("the last field")))
        landmark.extra.edit()["autoCreated"] = true;
    return landmark;
}

} // namespace

ReadLandmarks readSlicerCsv(std::string_view text)
{
    ReadLandmarks read;
    Notes notes;
    LandmarkSet &set = read.sets.emplace_back();
    set.axes = Axes::Ras; // of files that do not say
    bool hasVersion = false;
    Lines lines(text);
    while (lines.nextFilled()) {
        const std::string_view line = lines.text();
        if (line.front() == '#') {
            if (const auto system = valueOf(line, "CoordinateSystem"))
                set.axes = axesOf(*system, lines.number());
            else if (valueOf(line, "Markups fiducial file version"))
                hasVersion = true;
            else if (!valueOf(line, "columns"))
                notes.add(LandmarkNote::Kind::CommentsLeftOut);
            continue;
        }
        const std::vector<CsvRow> rows = csvRows(line, lines.number());
        const std::size_t most = hasVersion ? kFieldCount : 6;
        if (rows.empty() || rows.front().cells.size() < 4 || rows.front().cells.size() > most)
            throw Failure{lines.number(),
                          tr(hasVersion
                                 ? "%1 is no point; write id,x,y,z,ow,ox,oy,oz,vis,sel,lock,label,desc,"
                                   "associatedNodeID, with labels that have commas in quotes"
                                 : "%1 is no point; without a line \"# Markups fiducial file version = 5.8\" points "
                                   "are label,x,y,z,sel,vis",
                             mesh_import::quoted(line))};
        for (const std::size_t place : rows.front().trimmed) {
            if (hasVersion ? place == Label || place == Description : place == 0)
                notes.add(LandmarkNote::Kind::BlanksLeftOut);
        }
        set.landmarks.push_back(hasVersion ? landmarkOf(rows.front(), set.axes, set.landmarks.size(), notes)
                                           : oldLandmarkOf(rows.front()));
    }
    if (!hasVersion && set.landmarks.empty())
        throw Failure{
            1, tr("there are no points, and no line \"# Markups fiducial file version = 5.8\"; is it another file?")};
    if (!hasVersion)
        set.axes = Axes::Ras;
    if (set.axes == Axes::Ras && !set.landmarks.empty())
        notes.add(LandmarkNote::Kind::AxesTurned);
    read.notes = notes.take();
    return read;
}

std::string slicerCsvText(const LandmarkSet &set, Notes &notes)
{
    // These have their fields.
    LandmarkSet others = set;
    for (Landmark &landmark : others.landmarks) {
        if (!landmark.extra.json().is_object())
            continue;
        for (const char *key : {"id", "ow", "ox", "oy", "oz", "selected", "locked", "associatedNodeID", "autoCreated"})
            landmark.extra.edit().erase(key);
    }
    addLosses(notes, {&others, 1}, {.names = true, .notes = true, .hidden = true});
    std::string text = "# Markups fiducial file version = 5.8\n# CoordinateSystem = ";
    text += set.axes == Axes::Ras ? "RAS" : "LPS";
    text += "\n# columns = id,x,y,z,ow,ox,oy,oz,vis,sel,lock,label,desc,associatedNodeID\n";
    PlainNames names("#", false, notes); // readers count the lines that hold one
    Notes unused;
    PlainNames plain("#", false, unused);
    for (std::size_t i = 0; i < set.landmarks.size(); ++i) {
        const Landmark &landmark = set.landmarks[i];
        const auto extra = [&](const char *key, const std::string &usual) {
            const bool isThere = landmark.extra.json().is_object() && landmark.extra.json().contains(key);
            const Json value = isThere ? landmark.extra.json()[key] : Json(usual);
            if (value.is_boolean())
                return std::string(value.get<bool>() ? "1" : "0");
            return plain.of(value.is_string() ? value.get<std::string>() : scene_file::compactJson(value));
        };
        appendCell(text, extra("id", std::to_string(i)));
        appendNumbers(text, landmark.world ? turned(*landmark.world, set.axes).coordinates() : glm::dvec3(0.0), ',');
        for (std::size_t k = 0; k < kOrientation.size(); ++k) {
            text += ',';
            appendCell(text, extra(kOrientation[k], kUsualOrientation[k]));
        }
        text += landmark.isHidden ? ",0," : ",1,";
        text += extra("selected", "1") + ',' + extra("locked", "0") + ',';
        appendCell(text, names.of(landmark.name));
        text += ',';
        appendCell(text, plain.of(landmark.note));
        if (plain.of(landmark.note) != landmark.note)
            notes.add(LandmarkNote::Kind::NoteChanged, 1, landmark.name);
        text += ',';
        appendCell(text, extra("associatedNodeID", ""));
        const std::string autoCreated = extra("autoCreated", "0");
        if (landmark.isMissing()) {
            text += ",0," + autoCreated;
            notes.add(LandmarkNote::Kind::MissingAtOrigin);
        } else if (autoCreated != "0") {
            text += ",2," + autoCreated;
        }
        text += '\n';
    }
    return text;
}

} // namespace unprojector::landmark_files
