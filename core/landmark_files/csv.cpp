// Writes this program's table: name,x,y,z,object,face,u,v,w,note and the columns for other data
// that a landmark has.

#include "core/base/json.h"
#include "core/base/number_text.h"
#include "core/landmark_files/csv_columns.h"
#include "core/landmark_files/lines.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <map>
#include <set>

namespace unprojector::landmark_files {
using namespace landmarks;
using namespace csv;
using Json = nlohmann::ordered_json;
namespace {

std::string cellOf(const Json &value)
{
    return value.is_string() ? value.get<std::string>() : base::compactJson(value);
}

std::string number(double value)
{
    std::string text;
    base::appendNumber(text, value);
    return text;
}

void putNumbers(std::array<std::string, kWrittenCount> &cells, Column first, const glm::dvec3 &v)
{
    for (int i = 0; i < 3; ++i)
        cells[first + std::size_t(i)] = number(v[i]);
}

std::string colorText(const glm::u8vec3 &color)
{
    constexpr char kDigits[] = "0123456789abcdef";
    std::string text = "#";
    for (int i = 0; i < 3; ++i) {
        text += kDigits[color[i] >> 4];
        text += kDigits[color[i] & 0xf];
    }
    return text;
}

/// @param absent  stands for each coordinate of a landmark without a position
std::array<std::string, kWrittenCount> cellsOf(const LandmarkSet &set, const Landmark &landmark,
                                               const std::string &absent)
{
    std::array<std::string, kWrittenCount> cells;
    cells[Mesh] = set.mesh;
    cells[Unit] = set.unit;
    cells[Name] = landmark.name;
    if (landmark.world)
        putNumbers(cells, X, landmark.world->coordinates());
    else
        std::fill_n(cells.begin() + X, 3, absent);
    cells[Object] = landmark.object;
    if (const auto *triangle = std::get_if<OnTriangle>(&landmark.anchor)) {
        cells[Face] = std::to_string(triangle->triangle);
        putNumbers(cells, U, triangle->barycentric);
    } else if (const auto *vertex = std::get_if<AtVertex>(&landmark.anchor)) {
        cells[Vertex] = std::to_string(vertex->vertex);
    } else if (const auto *edge = std::get_if<OnEdge>(&landmark.anchor)) {
        cells[EdgeFrom] = std::to_string(edge->vertices[0]);
        cells[EdgeTo] = std::to_string(edge->vertices[1]);
        cells[EdgeShare] = number(edge->share);
    }
    cells[Note] = landmark.note;
    if (landmark.uncertainty)
        putNumbers(cells, Dx, landmark.uncertainty->coordinates());
    cells[Color] = landmark.color ? colorText(*landmark.color) : "";
    cells[Hidden] = landmark.isHidden ? "1" : "";
    if (!landmark.isPlaced())
        cells[AbsenceWord] = kAbsences[static_cast<std::size_t>(landmark.absence)];
    return cells;
}

/// The rows of a curve: one per semilandmark that is no landmark, or one without coordinates.
std::vector<std::array<std::string, kWrittenCount>> rowsOf(const LandmarkSet &set, const Curve &curve,
                                                           const std::string &name)
{
    const CurvePart part = partOf(curve, set);
    std::vector<std::array<std::string, kWrittenCount>> rows(std::max<std::size_t>(1, part.size()));
    for (std::size_t i = 0; i < rows.size(); ++i) {
        std::array<std::string, kWrittenCount> &cells = rows[i];
        cells[Mesh] = set.mesh;
        cells[Unit] = set.unit;
        cells[Name] = name;
        if (part.size() > 0) {
            cells[Name] = semilandmarkName(name, part.begin + i, curve.semilandmarks.size());
            putNumbers(cells, X, curve.semilandmarks[part.begin + i].coordinates());
        }
        cells[CurveName] = name;
        if (!curve.points.empty())
            cells[CurvePoints] = Json(curve.points).dump(-1, ' ', false, Json::error_handler_t::replace);
        cells[CurveWay] = kCurveKinds[static_cast<std::size_t>(curve.kind)];
        const std::size_t count = curve.semilandmarks.empty() ? curve.count : curve.semilandmarks.size();
        cells[CurveCount] = std::to_string(std::min<std::size_t>(count, kMostSemilandmarks));
    }
    return rows;
}

/// The name of a column in its usual spelling.
std::string titleOf(std::size_t column)
{
    switch (column) {
    case EdgeFrom: return "edgeFrom";
    case EdgeTo: return "edgeTo";
    case EdgeShare: return "edgeShare";
    case CurvePoints: return "curvePoints";
    case CurveWay: return "curveKind";
    case CurveCount: return "curveCount";
    default: return kColumnNames[column];
    }
}

using Row = std::array<std::string, kWrittenCount>;

/// Calls a function with each row of a table and its landmark, null for a semilandmark. All rows at
/// once would need a kilobyte per landmark.
template <class Take>
void forEachRow(std::span<const LandmarkSet> sets, const std::string &absent, Notes &notes, const Take &take)
{
    const bool hasPlacings = hasSeveralPlacings(sets);
    std::map<int, PlainNames> specimens; // rows of one name and placing belong to one specimen
    for (std::size_t i = 0; i < sets.size(); ++i) {
        const LandmarkSet &set = sets[i];
        PlainNames &names = specimens.try_emplace(set.placing, "", true, notes).first->second;
        const std::string specimen = sets.size() > 1 ? names.of(set.name, std::to_string(i + 1)) : set.name;
        const std::string placing = hasPlacings ? std::to_string(set.placing) : std::string();
        if (set.landmarks.empty() && set.curves.empty() && (sets.size() > 1 || !set.name.empty()))
            notes.add(LandmarkNote::Kind::EmptySpecimenLeftOut, 1, specimen);
        for (const Landmark &landmark : set.landmarks) {
            Row row = cellsOf(set, landmark, absent);
            row[Specimen] = specimen;
            row[Placing] = placing;
            take(row, &landmark);
        }
        PlainNames curves("", true, notes); // rows of one name belong to one curve
        for (std::size_t k = 0; k < set.curves.size(); ++k) {
            const Curve &curve = set.curves[k];
            for (Row &row : rowsOf(set, curve, curves.of(nameOf(curve, k)))) {
                row[Specimen] = specimen;
                row[Placing] = placing;
                take(row, static_cast<const Landmark *>(nullptr));
            }
            for (auto it = curve.extra.json().begin(); it != curve.extra.json().end(); ++it)
                notes.add(LandmarkNote::Kind::SpecimenKeysLeftOut, 1, it.key());
        }
    }
}

} // namespace

bool hasSeveralPlacings(std::span<const LandmarkSet> sets)
{
    return std::any_of(sets.begin(), sets.end(), [](const LandmarkSet &set) { return set.placing > 1; });
}

std::string csvText(std::span<const LandmarkSet> sets, base::CellTexts texts, Notes &notes, const std::string &absent)
{
    FormatCapabilities all;
    all.names = all.objects = all.anchors = all.uncertainties = all.notes = all.colors = all.hidden = all.keys = true;
    all.absences = all.specimenName = all.placings = all.mesh = all.unit = true;
    addLosses(notes, sets, all);

    std::array<bool, kWrittenCount> isUsed{};
    std::vector<std::string> others;
    std::set<std::string> known;
    const auto isOurs = [](const std::string &key) { // a column of that name would be read as this program's
        return std::find(kColumnNames.begin(), kColumnNames.end(), lowerCase(trimmed(key))) != kColumnNames.end();
    };
    std::fill(isUsed.begin() + Name, isUsed.begin() + Vertex, true);
    isUsed[Specimen] = sets.size() > 1;
    forEachRow(sets, absent, notes, [&](const Row &row, const Landmark *landmark) {
        for (std::size_t column = 0; column < kWrittenCount; ++column)
            isUsed[column] = isUsed[column] || !row[column].empty();
        if (!landmark)
            return;
        for (auto it = landmark->extra.json().begin(); it != landmark->extra.json().end(); ++it) {
            if (it.key().empty() || isOurs(it.key()))
                notes.add(LandmarkNote::Kind::KeysLeftOut, 1, it.key());
            else if (known.insert(it.key()).second)
                others.push_back(it.key());
        }
    });
    std::string text;
    const char *separator = "";
    for (std::size_t column = 0; column < kWrittenCount; ++column) {
        if (!isUsed[column])
            continue;
        text += separator + titleOf(column);
        separator = ",";
    }
    for (const std::string &other : others) {
        text += ',';
        appendCell(text, other, texts);
    }
    text += '\n';
    Notes said; // notes of the first pass
    forEachRow(sets, absent, said, [&](const Row &row, const Landmark *landmark) {
        separator = "";
        // A row of commas only would look like a spreadsheet's padding.
        const bool isEmpty = std::all_of(row.begin(), row.end(), [](const std::string &cell) { return cell.empty(); });
        for (std::size_t column = 0; column < kWrittenCount; ++column) {
            if (!isUsed[column])
                continue;
            text += separator;
            if (isEmpty && column == Name)
                text += "\"\"";
            if (column >= X && column <= Z) // NA in quotes would be a text
                text += row[column];
            else
                appendCell(text, row[column], texts);
            separator = ",";
        }
        for (const std::string &other : others) {
            text += ',';
            if (!landmark)
                continue;
            const Json &extra = landmark->extra.json();
            if (!extra.is_object() || !extra.contains(other))
                continue;
            if (extra[other].is_null())
                text += "NA";
            else
                appendCell(text, cellOf(extra[other]), texts);
        }
        text += '\n';
    });
    return text;
}

} // namespace unprojector::landmark_files
