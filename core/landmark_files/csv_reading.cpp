// Reads tables: this program's, and other programs' with named columns.

#include "core/base/json.h"
#include "core/base/number_text.h"
#include "core/base/translation.h"
#include "core/landmark_files/csv_table.h"
#include "core/landmark_files/lines.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <map>
#include <optional>
#include <system_error>
#include <utility>

namespace unprojector::landmark_files {
using namespace geometry;
using namespace landmarks;
using namespace csv;
using base::CsvCell;
using base::CsvRow;
using base::marked;
using base::tr;
namespace {

using Json = nlohmann::ordered_json;

/// True for a cell without quotes that means "missing" in R or a spreadsheet.
bool isNothing(const CsvCell &cell)
{
    return cell.text.empty() || (!cell.isQuoted && (cell.text == "NA" || cell.text == "#N/A"));
}

/// True if a table has all columns that this program always writes. In such a table an apostrophe
/// before a formula is not part of a text, and a coordinate of 9999 is one.
bool isOurs(const Header &header)
{
    for (std::size_t column = Name; column <= Note; ++column) {
        if (!header.has(Column(column)))
            return false;
    }
    return true;
}

/// A table whose current row's cells are read by column.
class Cells : public Table {
public:
    using Table::Table;

    /// The text of a cell. A name may be "NA", which is short for nasion.
    std::string_view operator[](Column column) const
    {
        if (!header().has(column))
            return {};
        const CsvCell &cell = row().cells[header().places[column]];
        return column != Name && column != Specimen && isNothing(cell) ? std::string_view()
                                                                       : std::string_view(cell.text);
    }
    std::size_t line() const { return row().line; }

    double number(Column column) const { return numberOf(mark().withPoint((*this)[column]), line(), titleOf(column)); }

    /// Three numbers; empty if all cells are empty or mean "missing".
    std::optional<glm::dvec3> numbers(Column first) const
    {
        constexpr int kCount = 3;
        const auto column = [first](int i) { return Column(first + std::size_t(i)); };
        const auto cell = [&](int i) { return rawText(column(i)); };
        const auto isMissing = [&](int i) { return cell(i).empty() || isMissingWord(cell(i)); };
        int given = 0;
        for (int i = 0; i < kCount; ++i)
            given += isMissing(i) ? 0 : 1;
        if (given == 0)
            return std::nullopt;
        glm::dvec3 v(0.0);
        for (int i = 0; i < kCount; ++i) {
            if (isMissing(i))
                fail(line(),
                     cell(i).empty()
                         ? tr("%1 is empty and its neighbours are not; give all three, or none", titleOf(column(i)))
                         : tr("%1 is \"%2\" and its neighbours are numbers; give all three, or none",
                              titleOf(column(i)), cell(i)));
            v[i] = number(column(i));
        }
        return v;
    }

    /// The position of a point; empty if it is missing. All three coordinates of other programs' missing points may
    /// be 9999 or -9999. This program's tables leave them empty.
    std::optional<glm::dvec3> position(Notes &notes) const
    {
        constexpr double kMissing = 9999.0;
        const std::optional<glm::dvec3> v = numbers(X);
        if (!v || glm::abs(*v) != glm::dvec3(kMissing) || v->x != v->y || v->y != v->z || isOurs(header()))
            return v;
        notes.add(
            {marked("%1 point has only coordinates of 9999 or -9999, the mark of a missing point; it has no position "
                    "here"),
             marked("%1 points have only coordinates of 9999 or -9999, the mark of missing points; they have no "
                    "position here")});
        return std::nullopt;
    }

    /// Parses 0 or 1, or the words for them.
    bool flag(Column column, bool usual) const
    {
        const std::string word = lowerCase((*this)[column]);
        if (word.empty())
            return usual;
        const bool isTrue = word == "1" || word == "true";
        if (!isTrue && word != "0" && word != "false")
            fail(line(), tr("%1 is \"%2\"; write 1 or 0", titleOf(column), (*this)[column]));
        return isTrue;
    }

private:
    std::string_view rawText(Column column) const
    {
        return header().has(column) ? row().text(header().places[column]) : std::string_view();
    }
    /// The table's own name of the column.
    const std::string &titleOf(Column column) const { return header().titles[column]; }
};

/// The tolerance of the sum of barycentric coordinates, which must be 1: the error of single
/// precision and six digits.
constexpr double kBarycentricSum = 1e-3; // other programs write few digits

Anchor anchorOf(const Cells &cells)
{
    const bool isFace = !cells[Face].empty(), isVertex = !cells[Vertex].empty(), isEdge = !cells[EdgeFrom].empty();
    if (isFace + isVertex + isEdge > 1)
        fail(cells.line(), tr("a point is held by one of face, vertex and edge; leave the others empty"));
    const std::optional<glm::dvec3> barycentric = cells.numbers(U);
    if (isFace != barycentric.has_value())
        fail(cells.line(), tr("face and u, v, w belong together; give all of them, or none"));
    if (isFace) {
        const double sum = barycentric->x + barycentric->y + barycentric->z;
        if (!(std::abs(sum - 1.0) <= kBarycentricSum))
            fail(cells.line(), tr("the sum of u, v and w is %1; it must be 1", base::shortestText(sum)));
        OnTriangle held; // GCC 12 reports uninitialized padding if it is built in one expression
        held.triangle = countOf(cells[Face], cells.line(), "face");
        held.barycentric = *barycentric;
        return held;
    }
    if (isVertex)
        return AtVertex{countOf(cells[Vertex], cells.line(), "vertex")};
    if (isEdge)
        return OnEdge{
            {countOf(cells[EdgeFrom], cells.line(), "edgeFrom"), countOf(cells[EdgeTo], cells.line(), "edgeTo")},
            cells.number(EdgeShare)};
    return Free{};
}

/// Parses "#ff8000".
std::optional<glm::u8vec3> colorOf(std::string_view text, std::size_t line)
{
    if (text.empty())
        return std::nullopt;
    std::uint32_t value = 0;
    const char *end = text.data() + text.size();
    const bool isHex =
        text.size() == 7 && text.front() == '#' && std::from_chars(text.data() + 1, end, value, 16).ptr == end;
    if (!isHex)
        fail(line, tr("color is \"%1\"; write it as #rrggbb", text));
    return glm::u8vec3(value >> 16, (value >> 8) & 0xff, value & 0xff);
}

Absence absenceOf(const Cells &cells, bool isPlaced)
{
    const std::string word = lowerCase(cells[AbsenceWord]);
    const auto found = std::find(kAbsences.begin(), kAbsences.end(), word);
    if (found == kAbsences.end())
        fail(cells.line(),
             tr("absence is \"%1\"; write skipped or missing, or leave the cell empty", cells[AbsenceWord]));
    if (isPlaced && !word.empty())
        fail(cells.line(), tr("this landmark is marked as %1 and has coordinates; empty the one or the other", word));
    return static_cast<Absence>(found - kAbsences.begin());
}

/// A cell in another program's column: a JSON value if it is written as one, otherwise a text.
Json jsonOf(const std::string &cell)
{
    const auto json = base::parseJson(cell); // limits the nesting to what the JSON writer's stack allows
    const bool isJson = json && !json->is_string() && base::compactJson(*json) == cell;
    return isJson ? *json : Json(cell);
}

Landmark landmarkOf(const Cells &cells, Notes &notes)
{
    Landmark landmark;
    landmark.name = cells[Name];
    const std::optional<glm::dvec3> world = cells.position(notes);
    const bool isDefined = cells.flag(Defined, true);
    if (world && isDefined)
        landmark.world = turned(WorldPoint(*world), cells.header().axes);
    else if (world && *world != glm::dvec3(0.0))
        notes.add(kHadPosition);
    landmark.absence = absenceOf(cells, world.has_value());
    landmark.object = cells[Object];
    landmark.anchor = anchorOf(cells);
    landmark.note = cells[Note];
    if (const auto uncertainty = cells.numbers(Dx))
        landmark.uncertainty = WorldVector(*uncertainty);
    landmark.color = colorOf(cells[Color], cells.line());
    landmark.isHidden = cells.flag(Hidden, !cells.flag(Visible, true));
    if (!cells.flag(Selected, true))
        landmark.extra.edit()["selected"] = false;
    if (cells.flag(Locked, false))
        landmark.extra.edit()["locked"] = true;
    for (const auto &[place, name] : cells.header().others) {
        const CsvCell &cell = cells.row().cells[place];
        if (isNothing(cell))
            continue;
        if (name.empty())
            fail(cells.line(),
                 tr("the cell \"%1\" is in a column without a name; give it one in the first line", cell.text));
        landmark.extra.edit()[name] = jsonOf(std::string(cell.text));
    }
    return landmark;
}

std::vector<std::string> namesOf(std::string_view text, std::size_t line)
{
    std::vector<std::string> names;
    if (text.empty())
        return names;
    const auto json = base::parseJson(std::string(text));
    const bool isList = json && json->is_array()
                        && std::all_of(json->begin(), json->end(), [](const Json &j) { return j.is_string(); });
    if (!isList)
        fail(line, tr("curvePoints is %1; write the names as %2", text, R"(["A","B"])"));
    for (const Json &name : *json)
        names.push_back(name.get<std::string>());
    return names;
}

/// The rows of one curve.
struct CurveRows {
    struct Row {
        std::size_t line = 0, number = 0; ///< `number`: the semilandmark's, from 1; 0: the row's name has none
        std::optional<WorldPoint> place;
    };
    std::size_t set = 0; ///< index of the specimen
    Curve curve;         ///< without its semilandmarks; its count is 0 until a row gives it
    bool hasKind = false;
    std::vector<Row> rows;
};

/// The number in "NAME:03"; 0 for an empty name and for the curve's own.
std::size_t semilandmarkNumber(std::string_view name, const std::string &curve, std::size_t line)
{
    if (name.empty() || name == curve)
        return 0;
    std::size_t number = 0;
    if (name.size() > curve.size() && name.starts_with(curve) && name[curve.size()] == ':') {
        const char *end = name.data() + name.size();
        const auto read = std::from_chars(name.data() + curve.size() + 1, end, number);
        if (read.ec != std::errc() || read.ptr != end)
            number = 0;
    }
    if (number == 0)
        fail(line, tr("\"%1\" is not a semilandmark of the curve \"%2\"; their names are \"%3\", \"%4\" and so on",
                      name, curve, semilandmarkName(curve, 0, 2), semilandmarkName(curve, 1, 2)));
    return number;
}

/// Fails if a row of a curve contradicts the rows before it.
void checkSame(bool isSame, std::size_t line, const char *column, const std::string &curve)
{
    if (!isSame)
        fail(line, tr("%1 of the curve \"%2\" is not that of the rows before; give it once, or the same in each row",
                      column, curve));
}

/// Adds a row with the properties of a curve and the position of one of its semilandmarks.
void addToCurve(CurveRows &known, const Cells &cells, Notes &notes)
{
    Curve &curve = known.curve;
    if (std::vector<std::string> points = namesOf(cells[CurvePoints], cells.line()); !points.empty()) {
        checkSame(curve.points.empty() || curve.points == points, cells.line(), "curvePoints", curve.name);
        curve.points = std::move(points);
    }
    if (!cells[CurveWay].empty()) {
        const auto found = std::find(kCurveKinds.begin(), kCurveKinds.end(), cells[CurveWay]);
        if (found == kCurveKinds.end())
            fail(cells.line(), tr("curveKind is \"%1\"; write geodesic or planeSection", cells[CurveWay]));
        const auto kind = static_cast<CurveKind>(found - kCurveKinds.begin());
        checkSame(!known.hasKind || curve.kind == kind, cells.line(), "curveKind", curve.name);
        curve.kind = kind;
        known.hasKind = true;
    }
    if (!cells[CurveCount].empty()) {
        const std::uint32_t count = countOf(cells[CurveCount], cells.line(), "curveCount");
        if (count < 2 || count > kMostSemilandmarks)
            fail(cells.line(), tr("curveCount is %1; write 2 to %2", cells[CurveCount], kMostSemilandmarks));
        checkSame(curve.count == 0 || curve.count == count, cells.line(), "curveCount", curve.name);
        curve.count = count;
    }
    CurveRows::Row &row = known.rows.emplace_back();
    row.line = cells.line();
    row.number = semilandmarkNumber(cells[Name], curve.name, row.line);
    if (const auto place = cells.position(notes))
        row.place = turned(WorldPoint(*place), cells.header().axes);
}

/// Adds the rows of the ends that are landmarks, which a table does not repeat.
void addEnds(CurveRows &known, const LandmarkSet &set)
{
    std::vector<CurveRows::Row> &rows = known.rows;
    const Curve &curve = known.curve;
    const auto has = [&rows](std::size_t number) {
        return std::any_of(rows.begin(), rows.end(), [number](const auto &row) { return row.number == number; });
    };
    const auto isPlace = [](const CurveRows::Row &row) { return row.number > 0 && row.place.has_value(); };
    if (curve.points.empty() || !std::any_of(rows.begin(), rows.end(), isPlace))
        return;
    for (const auto &[number, name] :
         {std::pair(std::size_t{1}, curve.points.front()), std::pair(std::size_t{curve.count}, curve.points.back())}) {
        const std::optional<std::size_t> index = placedIndexOf(name, set);
        if (index && number > 0 && !has(number))
            rows.push_back({rows.front().line, number, set.landmarks[*index].world});
    }
}

/// Sorts the rows of a curve by number. If none has a number, they keep the table's order.
void sortRows(CurveRows &known)
{
    std::vector<CurveRows::Row> &rows = known.rows;
    const std::string &curve = known.curve.name;
    const bool isNumbered = rows.front().number > 0;
    for (const CurveRows::Row &row : rows) {
        if ((row.number > 0) != isNumbered)
            fail(row.line, tr("the curve \"%1\" has rows with a number in their names and rows without; name "
                              "them \"%2\", \"%3\" and so on",
                              curve, semilandmarkName(curve, 0, 2), semilandmarkName(curve, 1, 2)));
    }
    if (!isNumbered)
        return;
    std::stable_sort(rows.begin(), rows.end(), [](const auto &a, const auto &b) { return a.number < b.number; });
    for (std::size_t i = 0; i < rows.size(); ++i) {
        if (rows[i].number == i)
            fail(rows[i].line, tr("the semilandmark \"%1\" is already in line %2; remove one of them",
                                  semilandmarkName(curve, i - 1, rows.size()), rows[i - 1].line));
        if (rows[i].number > i + 1)
            fail(rows[i].line,
                 tr("the semilandmark \"%2\" of the curve \"%1\" is missing; give each of its semilandmarks a row",
                    curve, semilandmarkName(curve, i, rows.size())));
    }
}

/// Puts the ends that are landmarks exactly where those are. A curve of two semilandmarks has ends
/// only, so its row needs no coordinates.
void fitEnds(Curve &curve, const LandmarkSet &set)
{
    if (curve.semilandmarks.empty() && curve.count == 2 && !curve.points.empty()) {
        const auto from = placedIndexOf(curve.points.front(), set), to = placedIndexOf(curve.points.back(), set);
        if (from && to)
            curve.semilandmarks = {*set.landmarks[*from].world, *set.landmarks[*to].world};
        return;
    }
    const CurvePart part = partOf(curve, set);
    if (part.before)
        curve.semilandmarks.front() = *set.landmarks[*part.before].world;
    if (part.behind)
        curve.semilandmarks.back() = *set.landmarks[*part.behind].world;
}

/// A curve with all its semilandmarks, or none.
/// @param set  the landmarks of its specimen
Curve curveOf(CurveRows known, const LandmarkSet &set)
{
    addEnds(known, set);
    sortRows(known);
    Curve curve = std::move(known.curve);
    const auto isGiven = [](const CurveRows::Row &row) { return row.place.has_value(); };
    const std::vector<CurveRows::Row> &rows = known.rows;
    const bool hasPlaces = std::any_of(rows.begin(), rows.end(), isGiven);
    if (const auto missing = std::find_if_not(rows.begin(), rows.end(), isGiven); hasPlaces && missing != rows.end())
        fail(missing->line, tr("this semilandmark has no coordinates, and others of the curve \"%1\" have; give "
                               "all of them, or none",
                               curve.name));
    const auto count = static_cast<std::uint32_t>(std::min<std::size_t>(rows.size(), kMostSemilandmarks));
    const bool isCounted = hasPlaces || rows.front().number > 0; // otherwise one row holds the curve's properties
    if (isCounted && count != (curve.count > 0 ? curve.count : std::max(count, std::uint32_t{2})))
        fail(rows.back().line,
             curve.count > 0
                 ? tr("the curve \"%1\" has %2 semilandmarks here, and curveCount is %3; give all of them, or one "
                      "row without coordinates",
                      curve.name, rows.size(), curve.count)
                 : tr("the curve \"%1\" has one semilandmark; a curve needs at least 2", curve.name));
    if (!isCounted && rows.size() > 1)
        fail(rows[1].line, tr("the curve \"%1\" has a second row without coordinates; remove it, or give the "
                              "coordinates of its semilandmarks",
                              curve.name));
    if (curve.count == 0)
        curve.count = std::max(count, std::uint32_t{2});
    for (const CurveRows::Row &row : rows) {
        if (row.place)
            curve.semilandmarks.push_back(*row.place);
    }
    fitEnds(curve, set);
    return curve;
}

/// True if a row of a curve has data that only landmarks keep.
bool saysMore(const Cells &cells)
{
    const auto isOther = [&](const auto &other) { return !isNothing(cells.row().cells[other.first]); };
    for (std::size_t column = Object; column <= AbsenceWord; ++column) {
        if (!cells[Column(column)].empty())
            return true;
    }
    return std::any_of(cells.header().others.begin(), cells.header().others.end(), isOther);
}

/// The number of a row's texts with blanks around them. Numbers do not count, because they lose
/// nothing.
std::size_t trimmedTexts(const Cells &cells)
{
    const Header &header = cells.header();
    const CsvRow &row = cells.row();
    constexpr std::array kTexts{Specimen, Name, Object, Note, Mesh, Unit, CurveName};
    std::size_t count = 0;
    for (std::size_t index = 0; index < row.cells.size(); ++index) {
        if (!row.cells[index].hadBlanks || header.rowNames == index)
            continue;
        const auto known = std::find(header.places.begin(), header.places.end(), index);
        const bool isText =
            known == header.places.end()
            || std::find(kTexts.begin(), kTexts.end(), Column(known - header.places.begin())) != kTexts.end();
        count += isText ? 1 : 0;
    }
    return count;
}

/// Adds notes about losses of the whole table.
void addTableNotes(Notes &notes, const Table &table)
{
    if (table.header().isGuessed)
        notes.add({marked("the table has no first line that names its columns; they are read as %1")}, 1,
                  {table.header().has(Name) ? "name,x,y,z" : "x,y,z"});
    if (table.mark().isComma())
        notes.add(kDecimalCommas);
    notes.add({marked("%1 empty row at the end of the table is left out"),
               marked("%1 empty rows at the end of the table are left out")},
              table.paddingCount());
    if (table.header().axes == Axes::Ras)
        notes.add(kAxesFlipped);
}

} // namespace

ReadLandmarks readCsv(std::string_view text)
{
    Cells cells(text);
    const Header &header = cells.header();
    ReadLandmarks read;
    Notes notes;
    addTableNotes(notes, cells);
    std::map<std::pair<std::string, std::uint32_t>, std::size_t> places;    ///< by specimen and placing
    std::map<std::pair<std::size_t, std::string>, std::size_t> curvePlaces; ///< by specimen and name
    std::vector<CurveRows> curves;
    std::size_t rowNames = 0;
    while (cells.next()) {
        const CsvRow &row = cells.row();
        notes.add(kBlanksLeftOut, trimmedTexts(cells));
        const std::uint32_t placing =
            cells[Placing].empty() ? 1 : countOf(cells[Placing], row.line, kColumnNames[Placing]);
        if (placing == 0 || placing > kMostPlacings)
            fail(row.line, tr("placing is %1; write a whole number from 1 to %2", placing, kMostPlacings));
        const auto [place, isNew] = places.try_emplace({std::string(cells[Specimen]), placing}, read.sets.size());
        if (isNew) {
            LandmarkSet set;
            set.name = cells[Specimen];
            set.placing = static_cast<int>(placing);
            set.mesh = cells[Mesh];
            set.unit = cells[Unit];
            set.axes = header.axes;
            read.sets.push_back(std::move(set));
        }
        LandmarkSet &set = read.sets[place->second];
        for (const auto &[column, known] : {std::pair(Mesh, &set.mesh), std::pair(Unit, &set.unit)}) {
            if (cells[column] != *known)
                fail(row.line, tr("%1 is \"%2\", and that of the rows before is \"%3\"; a specimen has one, "
                                  "so give it in each of its rows",
                                  kColumnNames[column], cells[column], *known));
        }
        if (header.rowNames) { // row numbers have no meaning
            const std::string_view name = row.text(*header.rowNames);
            rowNames += name.find_first_not_of("0123456789") == name.npos ? 0u : 1u;
        }
        if (cells[CurveName].empty()) {
            set.landmarks.push_back(landmarkOf(cells, notes));
        } else {
            const auto [known, isNewCurve] =
                curvePlaces.try_emplace({place->second, std::string(cells[CurveName])}, curves.size());
            if (isNewCurve) {
                CurveRows &rowsOfCurve = curves.emplace_back();
                rowsOfCurve.set = place->second;
                rowsOfCurve.curve.name = cells[CurveName];
                rowsOfCurve.curve.count = 0;
            }
            addToCurve(curves[known->second], cells, notes);
            if (saysMore(cells))
                notes.add(kCurveCellsLeftOut);
        }
    }
    if (!isOurs(header))
        notes.add(
            {marked("the apostrophe before %1 text is left out; it keeps spreadsheets from computing what follows"),
             marked("the apostrophes before %1 texts are left out; they keep spreadsheets from computing what "
                    "follows")},
            cells.apostropheCount());
    notes.add({marked("%1 row name beside the names of the points is left out"),
               marked("%1 row names beside the names of the points are left out")},
              rowNames);
    read.notes = notes.take();
    for (CurveRows &rowsOfCurve : curves) {
        LandmarkSet &set = read.sets[rowsOfCurve.set];
        set.curves.push_back(curveOf(std::move(rowsOfCurve), set));
    }
    if (read.sets.empty())
        read.sets.emplace_back();
    return read;
}

} // namespace unprojector::landmark_files
