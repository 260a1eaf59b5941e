// .fcsv of 3D Slicer: comments with version and axes, then
// id,x,y,z,ow,ox,oy,oz,vis,sel,lock,label,desc,associatedNodeID.

#include "core/base/csv.h"
#include "core/base/json.h"
#include "core/base/number_text.h"
#include "core/base/text_scanner.h"
#include "core/base/translation.h"
#include "core/landmark_files/lines.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>

namespace unprojector::landmark_files {
using namespace geometry;
using namespace landmarks;
using base::CsvCell;
using base::marked;
using base::tr;
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
constexpr std::size_t kFieldCount = AutoCreated + 1, kOldFieldCount = 6;
/// Values of the fifteenth field, in newer files.
constexpr std::string_view kUndefined = "0", kPreview = "1", kDefined = "2", kMissing = "3";

/// The value of a key in a comment: "# CoordinateSystem = LPS". A spreadsheet pads it with
/// separators.
std::optional<std::string_view> valueOf(std::string_view comment, std::string_view key)
{
    const std::size_t equals = comment.find('=');
    if (equals == comment.npos || trimmed(comment.substr(1, equals - 1)) != key)
        return std::nullopt;
    const std::string_view value = comment.substr(equals + 1);
    return trimmed(value.substr(0, value.find_last_not_of(",; \t\r") + 1));
}

constexpr std::string_view kColumns = "id,x,y,z,ow,ox,oy,oz,vis,sel,lock,label,desc,associatedNodeID",
                           kOldColumns = "label,x,y,z,sel,vis";

/// The number of columns that a comment names. It must name the first of the known ones, in their
/// order; a spreadsheet uses another separator.
std::size_t columnCount(std::string_view names, bool hasVersion, std::size_t line)
{
    std::string list = lowerCase(names);
    list.erase(std::remove_if(list.begin(), list.end(), [](char c) { return c == ' ' || c == '"'; }), list.end());
    std::replace_if(
        list.begin(), list.end(), [](char c) { return c == ';' || c == '\t'; }, ',');
    const auto begins = [&list](std::string_view columns) {
        return (lowerCase(columns) + ',').starts_with(list + ',');
    };
    if (!begins(kColumns) && (hasVersion || !begins(kOldColumns)))
        fail(line, tr("the columns are %1; put them in the order %2", base::quoted(names), kColumns));
    return static_cast<std::size_t>(std::count(list.begin(), list.end(), ',')) + 1;
}

Axes axesOf(std::string_view word, std::size_t line)
{
    if (word == "LPS" || word == "1")
        return Axes::Lps;
    if (word == "RAS" || word == "0")
        return Axes::Ras;
    fail(line, tr("the coordinate system is %1; it must be LPS or RAS (1 or 0)", base::quoted(word)));
}

bool isMissing(std::string_view cell)
{
    return cell.empty() || isMissingWord(cell);
}

bool flagOf(const CsvCell &cell, bool usual, std::size_t line, const char *what)
{
    if (isMissing(cell.text))
        return usual;
    if (cell.text == "0" || cell.text == "1")
        return cell.text == "1";
    fail(line, tr("%1 is %2; it must be 0 or 1. Is there a comma in a label that is not in quotes?", tr(what),
                  base::quoted(cell.text)));
}

/// The position; empty if the row has NA.
std::optional<WorldPoint> positionOf(const base::CsvRow &row, std::size_t first, Axes axes,
                                     const base::DecimalMark &mark)
{
    std::array<std::string, 3> cells;
    for (std::size_t i = 0; i < cells.size(); ++i)
        cells[i] = mark.withPoint(row.cells[first + i].text);
    const std::array<std::string_view, 3> words{cells[0], cells[1], cells[2]};
    const std::optional<WorldPoint> place = landmarkAt(words, row.line, isMissing).world;
    return place ? std::optional(turned(*place, axes)) : std::nullopt;
}

/// A text written by R: empty for NA.
std::string textOf(const CsvCell &cell)
{
    return std::string(!cell.isQuoted && cell.text == "NA" ? std::string_view() : cell.text);
}

/// Parses label,x,y,z,sel,vis: 3D Slicer 3, always in RAS.
Landmark oldLandmarkOf(base::CsvRow &row, const base::DecimalMark &mark)
{
    row.cells.resize(kOldFieldCount);
    Landmark landmark;
    landmark.name = row.cells[0].text;
    landmark.world = positionOf(row, 1, Axes::Ras, mark);
    if (!flagOf(row.cells[4], true, row.line, "sel"))
        landmark.extra.edit()["selected"] = false;
    landmark.isHidden = !flagOf(row.cells[5], true, row.line, "vis");
    return landmark;
}

Landmark landmarkOf(base::CsvRow &row, Axes axes, std::size_t number, const base::DecimalMark &mark, Notes &notes)
{
    row.cells.resize(kFieldCount);
    const auto &cells = row.cells;
    Landmark landmark;
    landmark.name = cells[Label].text;
    landmark.note = textOf(cells[Description]);
    const std::optional<WorldPoint> position = positionOf(row, X, axes, mark);
    const std::string_view status = cells[Status].text;
    const bool isDefined = isMissing(status) || status == kDefined;
    if (isDefined)
        landmark.world = position;
    else if (status == kPreview)
        notes.add(kPreviewsLeftOut);
    else if (position && !(*position == WorldPoint()))
        notes.add(kHadPosition);
    if (status == kMissing)
        landmark.absence = Absence::Missing;
    landmark.isHidden = !flagOf(cells[Visible], true, row.line, "vis");
    if (const std::string id(cells[Id].text); !id.empty() && id != std::to_string(number))
        landmark.extra.edit()["id"] = id;
    bool isTurned = false;
    std::array<std::string, kOrientation.size()> orientation;
    for (std::size_t i = 0; i < kOrientation.size(); ++i) {
        orientation[i] = trimmed(mark.withPoint(textOf(cells[Orientation + i])));
        isTurned = isTurned || (!orientation[i].empty() && orientation[i] != kUsualOrientation[i]);
    }
    for (std::size_t i = 0; i < kOrientation.size() && isTurned; ++i) {
        static_cast<void>(numberOf(orientation[i], row.line, kOrientation[i]));
        landmark.extra.edit()[kOrientation[i]] = orientation[i];
    }
    if (!flagOf(cells[Selected], true, row.line, "sel"))
        landmark.extra.edit()["selected"] = false;
    if (flagOf(cells[Locked], false, row.line, "lock"))
        landmark.extra.edit()["locked"] = true;
    if (const std::string node = textOf(cells[AssociatedNode]); !node.empty())
        landmark.extra.edit()["associatedNodeID"] = node;
    if (flagOf(cells[AutoCreated], false, row.line, marked("the last field")))
        landmark.extra.edit()["autoCreated"] = true;
    return landmark;
}

/// The text of a comment, which a spreadsheet may have quoted; empty for another row.
std::optional<std::string_view> commentOf(const base::CsvRow &row)
{
    const std::string_view first = row.cells.front().text;
    if (!first.starts_with('#'))
        return std::nullopt;
    return row.cells.front().isQuoted ? first : trimmed(row.source);
}

/// The format of the rows of points.
struct Dialect {
    char separator = ',';
    base::DecimalMark mark{','};
};

/// True if a row, split by a separator, has coordinates in their columns.
bool hasPlace(std::string_view source, char separator)
{
    base::CsvReader reader(source, separator);
    if (!reader.next() || reader.row().cells.size() <= Z)
        return false;
    const auto &cells = reader.row().cells;
    base::DecimalMark mark(separator);
    for (std::size_t i = X; i <= Z; ++i)
        mark.see(cells[i].text);
    return std::all_of(cells.begin() + X, cells.begin() + Z + 1, [&mark](const CsvCell &cell) {
        return isMissing(cell.text) || base::doubleFromWord(mark.withPoint(cell.text));
    });
}

/// The first separator that makes a row a point. A label may contain other separators more often.
char separatorOf(std::string_view source)
{
    for (const char separator : base::kCsvSeparators) {
        if (hasPlace(source, separator))
            return separator;
    }
    return base::csvSeparatorOf(source);
}

/// The format according to the first row that is no comment.
Dialect dialectOf(std::string_view text)
{
    Dialect dialect;
    bool hasSeparator = false;
    for (base::CsvReader rows(text); rows.next() && !hasSeparator;) {
        hasSeparator = !commentOf(rows.row());
        if (hasSeparator)
            dialect.separator = separatorOf(rows.row().source);
    }
    dialect.mark = base::DecimalMark(dialect.separator);
    for (base::CsvReader rows(text, dialect.separator); rows.next();) {
        const auto &cells = rows.row().cells;
        for (std::size_t i = X; i <= Z && i < cells.size() && !commentOf(rows.row()); ++i)
            dialect.mark.see(cells[i].text);
    }
    return dialect;
}

/// True if a row ends with the text, without a line end.
bool isLastLine(std::string_view row, std::string_view text)
{
    return row.data() + row.size() == text.data() + text.size();
}

} // namespace

ReadLandmarks readSlicerCsv(std::string_view text)
{
    ReadLandmarks read;
    Notes notes;
    LandmarkSet &set = read.sets.emplace_back();
    set.axes = Axes::Ras; // for files that do not name it
    bool hasVersion = false;
    std::optional<Axes> said;
    std::size_t fewest = 0; ///< cells of a row so far, or of the columns' names
    const Dialect dialect = dialectOf(text);
    base::CsvReader rows(text, dialect.separator);
    while (rows.next()) {
        base::CsvRow &row = rows.row();
        if (const auto comment = commentOf(row)) {
            if (const auto system = valueOf(*comment, "CoordinateSystem")) {
                const Axes axes = axesOf(*system, row.line);
                if ((said || !set.landmarks.empty()) && axes != set.axes)
                    fail(row.line, tr("the coordinate system is %1 here and another one before; keep one such line, "
                                      "before the points",
                                      base::quoted(*system)));
                said = set.axes = axes;
            } else if (valueOf(*comment, "Markups fiducial file version"))
                hasVersion = true;
            else if (const auto columns = valueOf(*comment, "columns"))
                fewest = columnCount(*columns, hasVersion, row.line);
            else
                notes.add(kCommentsLeftOut);
            continue;
        }
        if (row.isPadding())
            continue;
        // A single row may lack only the end of the description and of the node.
        const std::size_t whole = hasVersion ? Label + 1 : std::size_t{4};
        if (row.cells.size() < (set.landmarks.empty() ? std::min(fewest, whole) : fewest)
            && isLastLine(row.source, text))
            fail(row.line, tr("the file ends within this row, which has %1 of %2 cells; is it cut off?",
                              row.cells.size(), fewest));
        fewest = set.landmarks.empty() ? row.cells.size() : std::min(fewest, row.cells.size());
        const std::size_t most = hasVersion ? kFieldCount : kOldFieldCount;
        row.trimPadding(most);
        if (row.cells.size() < 4 || row.cells.size() > most)
            fail(row.line,
                 tr(hasVersion
                        ? "%1 is not a point; write id,x,y,z,ow,ox,oy,oz,vis,sel,lock,label,desc,associatedNodeID, "
                          "with labels that have commas in quotes"
                        : "%1 is not a point; without a line \"# Markups fiducial file version = 5.8\" points are "
                          "label,x,y,z,sel,vis",
                    base::quoted(trimmed(row.source))));
        for (std::size_t index = 0; index < row.cells.size(); ++index) {
            if (row.cells[index].hadBlanks && (hasVersion ? index == Label || index == Description : index == 0))
                notes.add(kBlanksLeftOut);
        }
        set.landmarks.push_back(hasVersion ? landmarkOf(row, set.axes, set.landmarks.size(), dialect.mark, notes)
                                           : oldLandmarkOf(row, dialect.mark));
    }
    if (rows.error())
        fail(rows.error()->line, rows.error()->text);
    if (!hasVersion && set.landmarks.empty())
        fail(1, tr("there are no points, and no line \"# Markups fiducial file version = 5.8\"; is it another file?"));
    if (!hasVersion)
        set.axes = Axes::Ras;
    if (dialect.mark.isComma())
        notes.add(kDecimalCommas);
    if (set.axes == Axes::Ras && !set.landmarks.empty())
        notes.add(kAxesFlipped);
    read.notes = notes.take();
    return read;
}

std::string slicerCsvText(std::span<const LandmarkSet> sets, Notes &notes)
{
    const LandmarkSet &set = sets.front();
    std::string text = "# Markups fiducial file version = 5.8\n# CoordinateSystem = ";
    text += set.axes == Axes::Ras ? "RAS" : "LPS";
    text += "\n# columns = id,x,y,z,ow,ox,oy,oz,vis,sel,lock,label,desc,associatedNodeID\n";
    PlainNames names("#", false, notes); // readers count the lines that contain '#'
    Notes unused;
    PlainNames plain("#", false, unused);
    base::RowWriter row(text);
    for (std::size_t i = 0; i < set.landmarks.size(); ++i) {
        const Landmark &landmark = set.landmarks[i];
        const auto extra = [&](const char *key, const std::string &usual) {
            const bool isThere = landmark.extra.json().is_object() && landmark.extra.json().contains(key);
            const Json value = isThere ? landmark.extra.json()[key] : Json(usual);
            if (value.is_boolean())
                return std::string(value.get<bool>() ? "1" : "0");
            return plain.of(value.is_string() ? value.get<std::string>() : base::compactJson(value));
        };
        const glm::dvec3 place = landmark.world ? turned(*landmark.world, set.axes).coordinates() : glm::dvec3(0.0);
        row.text(extra("id", std::to_string(i)));
        for (int axis = 0; axis < 3; ++axis)
            row.number(place[axis]);
        for (std::size_t k = 0; k < kOrientation.size(); ++k)
            row.text(extra(kOrientation[k], kUsualOrientation[k]));
        row.plain(landmark.isHidden ? "0" : "1");
        row.plain(extra("selected", "1"));
        row.plain(extra("locked", "0"));
        row.text(names.of(landmark.name));
        const std::string note = plain.of(landmark.note);
        row.text(note);
        if (note != landmark.note)
            notes.add({marked("the note of \"%1\" is written without line breaks and #")}, 1, {landmark.name});
        row.text(extra("associatedNodeID", ""));
        // All rows have these fields: R takes a longer row among shorter ones for two.
        row.plain(landmark.isPlaced() ? kDefined : landmark.isMissing() ? kMissing : kUndefined);
        row.plain(extra("autoCreated", "0"));
        row.endRow();
        if (!landmark.isPlaced())
            notes.add({marked("%1 point without a position is written as 0, 0, 0 with a status field, which older "
                              "readers ignore"),
                       marked("%1 points without a position are written as 0, 0, 0 with a status field, which older "
                              "readers ignore")});
        if (landmark.absence == Absence::Skipped)
            notes.add(kSkippedLeftOut);
    }
    return text;
}

} // namespace unprojector::landmark_files
