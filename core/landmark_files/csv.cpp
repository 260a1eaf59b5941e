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
using base::marked;
using Json = nlohmann::ordered_json;
namespace {

using Row = std::array<std::string, kWrittenCount>;

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

void putNumbers(Row &cells, Column first, const glm::dvec3 &v)
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
/// @param cells  of its specimen
Row rowOf(Row cells, const Landmark &landmark, const std::string &absent)
{
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
/// @param cells  of its specimen
std::vector<Row> rowsOf(Row cells, const LandmarkSet &set, const Curve &curve, const std::string &name)
{
    const CurvePart part = partOf(curve, set);
    const std::size_t count = curve.semilandmarks.empty() ? curve.count : curve.semilandmarks.size();
    cells[Name] = cells[CurveName] = name;
    if (!curve.points.empty())
        cells[CurvePoints] = Json(curve.points).dump(-1, ' ', false, Json::error_handler_t::replace);
    cells[CurveWay] = kCurveKinds[static_cast<std::size_t>(curve.kind)];
    cells[CurveCount] = std::to_string(std::min<std::size_t>(count, kMostSemilandmarks));
    std::vector<Row> rows(std::max<std::size_t>(1, part.size()), cells);
    for (std::size_t i = 0; i < part.size(); ++i) {
        rows[i][Name] = semilandmarkName(name, part.begin + i, curve.semilandmarks.size());
        putNumbers(rows[i], X, curve.semilandmarks[part.begin + i].coordinates());
    }
    return rows;
}

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
        Row cells;
        cells[Specimen] = sets.size() > 1 ? names.of(set.name, std::to_string(i + 1)) : set.name;
        cells[Placing] = hasPlacings ? std::to_string(set.placing) : std::string();
        cells[Mesh] = set.mesh;
        cells[Unit] = set.unit;
        if (set.landmarks.empty() && set.curves.empty() && (sets.size() > 1 || !set.name.empty()))
            notes.add({marked("the specimen \"%1\" has no points and is left out")}, 1, {cells[Specimen]});
        for (const Landmark &landmark : set.landmarks)
            take(rowOf(cells, landmark, absent), &landmark);
        PlainNames curves("", true, notes); // rows of one name belong to one curve
        for (std::size_t k = 0; k < set.curves.size(); ++k) {
            const Curve &curve = set.curves[k];
            for (const Row &row : rowsOf(cells, set, curve, curves.of(nameOf(curve, k))))
                take(row, static_cast<const Landmark *>(nullptr));
            for (auto it = curve.extra.json().begin(); it != curve.extra.json().end(); ++it)
                notes.addSpecimenKeys(it.key());
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
    std::array<bool, kWrittenCount> isUsed{};
    std::vector<std::string> others;
    std::set<std::string> known;
    std::fill(isUsed.begin() + Name, isUsed.begin() + Vertex, true);
    isUsed[Specimen] = sets.size() > 1;
    forEachRow(sets, absent, notes, [&](const Row &row, const Landmark *landmark) {
        for (std::size_t column = 0; column < kWrittenCount; ++column)
            isUsed[column] = isUsed[column] || !row[column].empty();
        if (!landmark)
            return;
        for (auto it = landmark->extra.json().begin(); it != landmark->extra.json().end(); ++it) {
            if (it.key().empty() || columnOf(it.key()) < kWrittenCount) // it would be read as this program's
                notes.addKeys(it.key());
            else if (known.insert(it.key()).second)
                others.push_back(it.key());
        }
    });
    std::string text;
    base::RowWriter writer(text, texts);
    for (std::size_t column = 0; column < kWrittenCount; ++column) {
        if (isUsed[column])
            writer.plain(kColumnNames[column]);
    }
    for (const std::string &other : others)
        writer.text(other);
    writer.endRow();
    Notes said; // notes of the first pass
    forEachRow(sets, absent, said, [&](const Row &row, const Landmark *landmark) {
        // A row of commas only would look like a spreadsheet's padding.
        const bool isEmpty = std::all_of(row.begin(), row.end(), [](const std::string &cell) { return cell.empty(); });
        for (std::size_t column = 0; column < kWrittenCount; ++column) {
            if (!isUsed[column])
                continue;
            if (isEmpty && column == Name)
                writer.plain("\"\"");
            else if (column >= X && column <= Z) // NA in quotes would be a text
                writer.plain(row[column]);
            else
                writer.text(row[column]);
        }
        for (const std::string &other : others) {
            const Json *extra = landmark && landmark->extra.json().is_object() ? &landmark->extra.json() : nullptr;
            if (!extra || !extra->contains(other))
                writer.nothing();
            else if ((*extra)[other].is_null())
                writer.plain("NA");
            else
                writer.text(cellOf((*extra)[other]));
        }
        writer.endRow();
    });
    return text;
}

} // namespace unprojector::landmark_files
