// Our own table: name,x,y,z,object,face,u,v,w,note and, where a landmark has more, the columns for it.

#include "core/landmark_files/lines.h"
#include "core/scene_file/json_text.h"
#include "core/scene_file/strict_json.h"
#include "core/text/number_text.h"
#include "core/text/translation.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <charconv>
#include <set>

namespace unprojector::landmark_files {
using text::tr;
namespace {

using Json = nlohmann::ordered_json;

/// All columns that mean something here, in the order in which they are written.
enum Column : std::size_t {
    Specimen,
    Name,
    X,
    Y,
    Z,
    Object,
    Face,
    U,
    V,
    W,
    Note,
    Vertex,
    EdgeFrom,
    EdgeTo,
    EdgeShare,
    Dx,
    Dy,
    Dz,
    Color,
    Hidden,
    Mesh,
    Unit,
    CurveName, ///< of the curve that a row is a semilandmark of
    CurvePoints,
    CurveWay,
    CurveCount
};
constexpr std::size_t kColumnCount = CurveCount + 1;
constexpr std::array<const char *, kColumnCount> kColumnNames{
    "specimen", "name",   "x",      "y",        "z",      "object",      "face",      "u",         "v",
    "w",        "note",   "vertex", "edgefrom", "edgeto", "edgeshare",   "dx",        "dy",        "dz",
    "color",    "hidden", "mesh",   "unit",     "curve",  "curvepoints", "curvekind", "curvecount"};
constexpr std::array kCurveKinds{"geodesic", "planeSection"};

// ---- reading ----------------------------------------------------------------------------------------------------

/// The cells of a row by what they mean.
class Cells {
public:
    Cells(const std::array<std::size_t, kColumnCount> &places, const CsvRow &row) : m_places(places), m_row(row) {}

    std::string_view operator[](Column column) const
    {
        return m_places[column] < m_row.cells.size() ? std::string_view(m_row.cells[m_places[column]])
                                                     : std::string_view();
    }
    std::size_t line() const { return m_row.line; }

    /// Three numbers; nothing where all are empty.
    std::optional<glm::dvec3> numbers(Column first) const
    {
        glm::dvec3 v(0.0);
        int given = 0;
        for (int i = 0; i < 3; ++i)
            given += (*this)[Column(first + std::size_t(i))].empty() ? 0 : 1;
        if (given == 0)
            return std::nullopt;
        for (int i = 0; i < 3; ++i) {
            const auto column = Column(first + std::size_t(i));
            if ((*this)[column].empty())
                throw Failure{line(), tr("%1 is empty and its neighbours are not; give all three, or none",
                                         kColumnNames[column])};
            v[i] = numberOf((*this)[column], line(), kColumnNames[column]);
        }
        return v;
    }

private:
    const std::array<std::size_t, kColumnCount> &m_places;
    const CsvRow &m_row;
};

Hold holdOf(const Cells &cells)
{
    const bool isFace = !cells[Face].empty(), isVertex = !cells[Vertex].empty(), isEdge = !cells[EdgeFrom].empty();
    if (isFace + isVertex + isEdge > 1)
        throw Failure{cells.line(), tr("a point is held by one of face, vertex and edge; leave the others empty")};
    const std::optional<glm::dvec3> barycentric = cells.numbers(U);
    if (isFace != barycentric.has_value())
        throw Failure{cells.line(), tr("face and u, v, w belong together; give all of them, or none")};
    if (isFace) {
        OnTriangle held; // in one piece GCC 12 calls its padding uninitialized
        held.triangle = countOf(cells[Face], cells.line(), "face");
        held.barycentric = *barycentric;
        return held;
    }
    if (isVertex)
        return AtVertex{countOf(cells[Vertex], cells.line(), "vertex")};
    if (isEdge)
        return OnEdge{
            {countOf(cells[EdgeFrom], cells.line(), "edgeFrom"), countOf(cells[EdgeTo], cells.line(), "edgeTo")},
            numberOf(cells[EdgeShare], cells.line(), "edgeShare")};
    return Free{};
}

/// "#ff8000"
std::optional<glm::u8vec3> colorOf(std::string_view text, std::size_t line)
{
    if (text.empty())
        return std::nullopt;
    std::uint32_t value = 0;
    const char *end = text.data() + text.size();
    const bool isHex =
        text.size() == 7 && text.front() == '#' && std::from_chars(text.data() + 1, end, value, 16).ptr == end;
    if (!isHex)
        throw Failure{line, tr("color is \"%1\"; write it as #rrggbb", text)};
    return glm::u8vec3(value >> 16, (value >> 8) & 0xff, value & 0xff);
}

bool hiddenOf(std::string_view text, std::size_t line)
{
    if (text.empty() || text == "0" || text == "1")
        return text == "1";
    throw Failure{line, tr("hidden is \"%1\"; write 1 or 0", text)};
}

/// A cell of a column of somebody else's: as JSON where it is what JSON writes, else as a text.
Json jsonOf(const std::string &cell)
{
    const auto json = scene_file::parseStrictJson(cell); // no deeper than what writes it has stack for
    const bool isJson = json && !json->is_string() && scene_file::compactJson(*json) == cell;
    return isJson ? *json : Json(cell);
}

/// Where each column stands; those that are not known keep their names.
struct Header {
    std::array<std::size_t, kColumnCount> places;
    std::vector<std::pair<std::size_t, std::string>> others;
    std::size_t count = 0;
};

Header headerOf(const CsvRow &row)
{
    Header header;
    header.places.fill(std::size_t(-1));
    header.count = row.cells.size();
    if (row.cells.size() == 1 && row.cells.front().find(';') != std::string::npos)
        throw Failure{row.line, tr("the columns are separated by semicolons; save the table with commas, and numbers "
                                   "with a decimal point")};
    std::set<std::string> names;
    for (std::size_t i = 0; i < row.cells.size(); ++i) {
        const std::string name = lowerCase(trimmed(row.cells[i]));
        const auto known = std::find(kColumnNames.begin(), kColumnNames.end(), name);
        if (!name.empty() && !names.insert(known != kColumnNames.end() ? name : row.cells[i]).second)
            throw Failure{row.line, tr("the column \"%1\" is there twice; rename one of them", row.cells[i])};
        if (known != kColumnNames.end())
            header.places[static_cast<std::size_t>(known - kColumnNames.begin())] = i;
        else
            header.others.emplace_back(i, row.cells[i]);
    }
    for (const Column column : {X, Y, Z}) {
        if (header.places[column] == std::size_t(-1))
            throw Failure{row.line, tr("there is no column %1; the first line names the columns, name,x,y,z at least",
                                       kColumnNames[column])};
    }
    return header;
}

Landmark landmarkOf(const Header &header, const CsvRow &row)
{
    const Cells cells(header.places, row);
    Landmark landmark;
    landmark.name = cells[Name];
    if (const auto world = cells.numbers(X))
        landmark.world = WorldPoint(*world);
    landmark.object = cells[Object];
    landmark.hold = holdOf(cells);
    landmark.note = cells[Note];
    if (const auto uncertainty = cells.numbers(Dx))
        landmark.uncertainty = WorldVector(*uncertainty);
    landmark.color = colorOf(cells[Color], row.line);
    landmark.isHidden = hiddenOf(cells[Hidden], row.line);
    for (const auto &[place, name] : header.others) {
        if (name.empty() && !row.cells[place].empty())
            throw Failure{row.line,
                          tr("the cell \"%1\" stands in a column without a name; give it one in the first line",
                             row.cells[place])};
        if (!row.cells[place].empty())
            landmark.extra.edit()[name] = jsonOf(row.cells[place]);
    }
    return landmark;
}

std::vector<std::string> namesOf(std::string_view text, std::size_t line)
{
    std::vector<std::string> names;
    if (text.empty())
        return names;
    const auto json = scene_file::parseStrictJson(std::string(text));
    const bool isList = json && json->is_array()
                        && std::all_of(json->begin(), json->end(), [](const Json &j) { return j.is_string(); });
    if (!isList)
        throw Failure{line, tr("curvePoints is %1; write the names as %2", text, R"(["A","B"])")};
    for (const Json &name : *json)
        names.push_back(name.get<std::string>());
    return names;
}

/// Takes a row that says of a curve what it is, and where one of its semilandmarks.
void addToCurve(LandmarkSet &set, const Cells &cells)
{
    const std::string name(cells[CurveName]);
    auto curve = std::find_if(set.curves.begin(), set.curves.end(), [&](const Curve &c) { return c.name == name; });
    if (curve == set.curves.end()) {
        curve = set.curves.insert(curve, Curve());
        curve->name = name;
        curve->points = namesOf(cells[CurvePoints], cells.line());
        const auto kind = std::find(kCurveKinds.begin(), kCurveKinds.end(), cells[CurveWay]);
        if (kind == kCurveKinds.end() && !cells[CurveWay].empty())
            throw Failure{cells.line(), tr("curveKind is \"%1\"; write geodesic or planeSection", cells[CurveWay])};
        if (kind != kCurveKinds.end())
            curve->kind = static_cast<CurveKind>(kind - kCurveKinds.begin());
        curve->count = 0;
        if (!cells[CurveCount].empty()) {
            curve->count = countOf(cells[CurveCount], cells.line(), "curveCount");
            if (curve->count < 2 || curve->count > kMostSemilandmarks)
                throw Failure{cells.line(),
                              tr("curveCount is %1; write 2 to %2", cells[CurveCount], kMostSemilandmarks)};
        }
    }
    if (const auto place = cells.numbers(X))
        curve->semilandmarks.push_back(WorldPoint(*place));
}

/// Whether a row of a curve has what is kept of landmarks only.
bool saysMore(const Cells &cells, const Header &header, const CsvRow &row)
{
    const auto isOther = [&](const auto &other) { return !row.cells[other.first].empty(); };
    for (std::size_t column = Object; column <= Hidden; ++column) {
        if (!cells[Column(column)].empty())
            return true;
    }
    return std::any_of(header.others.begin(), header.others.end(), isOther);
}

/// How many texts of a row had blanks around them: numbers lose nothing by that.
std::size_t trimmedTexts(const Header &header, const CsvRow &row)
{
    constexpr std::array kTexts{Specimen, Name, Object, Note, Mesh, Unit, CurveName};
    const auto isText = [&](std::size_t place) {
        const auto known = std::find(header.places.begin(), header.places.end(), place);
        return known == header.places.end()
               || std::find(kTexts.begin(), kTexts.end(), Column(known - header.places.begin())) != kTexts.end();
    };
    return static_cast<std::size_t>(std::count_if(row.trimmed.begin(), row.trimmed.end(), isText));
}

} // namespace

ReadLandmarks readCsv(std::string_view text)
{
    const std::vector<CsvRow> rows = csvRows(text);
    if (rows.empty())
        throw Failure{1, tr("the file is empty; the first line names the columns, name,x,y,z at least")};
    const Header header = headerOf(rows.front());
    ReadLandmarks read;
    Notes notes;
    std::map<std::string, std::size_t, std::less<>> places;
    for (std::size_t i = 1; i < rows.size(); ++i) {
        const CsvRow &row = rows[i];
        if (row.cells.size() != header.count)
            throw Failure{
                row.line,
                tr("here are %1 cells, and the first line names %2 columns; put cells that have commas in quotes",
                   row.cells.size(), header.count)};
        if (const std::size_t count = trimmedTexts(header, row); count > 0)
            notes.add(LandmarkNote::Kind::BlanksLeftOut, count);
        const Cells cells(header.places, row);
        const auto [place, isNew] = places.try_emplace(std::string(cells[Specimen]), read.sets.size());
        if (isNew) {
            LandmarkSet set;
            set.name = cells[Specimen];
            set.mesh = cells[Mesh];
            set.unit = cells[Unit];
            read.sets.push_back(std::move(set));
        }
        LandmarkSet &set = read.sets[place->second];
        for (const auto &[column, known] : {std::pair(Mesh, &set.mesh), std::pair(Unit, &set.unit)}) {
            if (cells[column] != *known)
                throw Failure{row.line, tr("%1 is \"%2\", and that of the rows before is \"%3\"; a specimen has one, "
                                           "so give it in each of its rows",
                                           kColumnNames[column], cells[column], *known)};
        }
        if (cells[CurveName].empty()) {
            set.landmarks.push_back(landmarkOf(header, row));
        } else {
            addToCurve(set, cells);
            if (saysMore(cells, header, row))
                notes.add(LandmarkNote::Kind::CurveCellsLeftOut);
        }
    }
    read.notes = notes.take();
    for (LandmarkSet &set : read.sets) {
        for (Curve &curve : set.curves) {
            if (curve.count == 0) // the table of somebody who knows the semilandmarks only
                curve.count = static_cast<std::uint32_t>(
                    std::clamp<std::size_t>(curve.semilandmarks.size(), 2, kMostSemilandmarks));
        }
    }
    if (read.sets.empty())
        read.sets.emplace_back();
    return read;
}

// ---- writing ----------------------------------------------------------------------------------------------------

namespace {

std::string cellOf(const Json &value)
{
    return value.is_string() ? value.get<std::string>() : scene_file::compactJson(value);
}

std::string number(double value)
{
    std::string text;
    text::appendNumber(text, value);
    return text;
}

void putNumbers(std::array<std::string, kColumnCount> &cells, Column first, const glm::dvec3 &v)
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

std::array<std::string, kColumnCount> cellsOf(const LandmarkSet &set, const Landmark &landmark)
{
    std::array<std::string, kColumnCount> cells;
    cells[Mesh] = set.mesh;
    cells[Unit] = set.unit;
    cells[Name] = landmark.name;
    if (landmark.world)
        putNumbers(cells, X, landmark.world->coordinates());
    cells[Object] = landmark.object;
    if (const auto *triangle = std::get_if<OnTriangle>(&landmark.hold)) {
        cells[Face] = std::to_string(triangle->triangle);
        putNumbers(cells, U, triangle->barycentric);
    } else if (const auto *vertex = std::get_if<AtVertex>(&landmark.hold)) {
        cells[Vertex] = std::to_string(vertex->vertex);
    } else if (const auto *edge = std::get_if<OnEdge>(&landmark.hold)) {
        cells[EdgeFrom] = std::to_string(edge->vertices[0]);
        cells[EdgeTo] = std::to_string(edge->vertices[1]);
        cells[EdgeShare] = number(edge->share);
    }
    cells[Note] = landmark.note;
    if (landmark.uncertainty)
        putNumbers(cells, Dx, landmark.uncertainty->coordinates());
    cells[Color] = landmark.color ? colorText(*landmark.color) : "";
    cells[Hidden] = landmark.isHidden ? "1" : "";
    return cells;
}

/// The rows of a curve: one a semilandmark, or one without a place where they are not known.
std::vector<std::array<std::string, kColumnCount>> rowsOf(const LandmarkSet &set, const Curve &curve,
                                                          const std::string &name)
{
    std::vector<std::array<std::string, kColumnCount>> rows(std::max<std::size_t>(1, curve.semilandmarks.size()));
    for (std::size_t i = 0; i < rows.size(); ++i) {
        std::array<std::string, kColumnCount> &cells = rows[i];
        cells[Mesh] = set.mesh;
        cells[Unit] = set.unit;
        cells[Name] = name;
        if (!curve.semilandmarks.empty()) {
            cells[Name] = semilandmarkName(name, i, rows.size());
            putNumbers(cells, X, curve.semilandmarks[i].coordinates());
        }
        cells[CurveName] = name;
        if (!curve.points.empty())
            cells[CurvePoints] = Json(curve.points).dump(-1, ' ', false, Json::error_handler_t::replace);
        cells[CurveWay] = kCurveKinds[static_cast<std::size_t>(curve.kind)];
        cells[CurveCount] = std::to_string(curve.count);
    }
    return rows;
}

/// The name of a column as people write it.
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

} // namespace

std::string csvText(std::span<const LandmarkSet> sets, Notes &notes)
{
    Holds all;
    all.names = all.objects = all.holds = all.uncertainties = all.notes = all.colors = all.hidden = all.keys = true;
    all.specimenName = all.mesh = all.unit = true;
    addLosses(notes, sets, all);

    std::vector<std::array<std::string, kColumnCount>> rows;
    std::vector<const Landmark *> landmarks;
    std::array<bool, kColumnCount> isUsed{};
    std::vector<std::string> others;
    std::set<std::string> known;
    const auto isOurs = [](const std::string &key) { // a column of that name would be read as ours
        return std::find(kColumnNames.begin(), kColumnNames.end(), lowerCase(trimmed(key))) != kColumnNames.end();
    };
    std::fill(isUsed.begin() + Name, isUsed.begin() + Vertex, true);
    isUsed[Specimen] = sets.size() > 1;
    PlainNames specimens("", true, notes); // rows of one name are one specimen's
    const auto use = [&](const std::array<std::string, kColumnCount> &row) {
        for (std::size_t column = 0; column < kColumnCount; ++column)
            isUsed[column] = isUsed[column] || !row[column].empty();
    };
    for (std::size_t i = 0; i < sets.size(); ++i) {
        const LandmarkSet &set = sets[i];
        const std::string specimen = sets.size() > 1 ? specimens.of(set.name, std::to_string(i + 1)) : set.name;
        if (set.landmarks.empty() && set.curves.empty() && (sets.size() > 1 || !set.name.empty()))
            notes.add(LandmarkNote::Kind::EmptySpecimenLeftOut, 1, specimen);
        for (const Landmark &landmark : set.landmarks) {
            rows.push_back(cellsOf(set, landmark));
            rows.back()[Specimen] = specimen;
            landmarks.push_back(&landmark);
            use(rows.back());
            for (auto it = landmark.extra.json().begin(); it != landmark.extra.json().end(); ++it) {
                if (it.key().empty() || isOurs(it.key()))
                    notes.add(LandmarkNote::Kind::KeysLeftOut, 1, it.key());
                else if (known.insert(it.key()).second)
                    others.push_back(it.key());
            }
        }
        PlainNames curves("", true, notes); // rows of one name are one curve's
        for (std::size_t k = 0; k < set.curves.size(); ++k) {
            const Curve &curve = set.curves[k];
            const std::string name = curves.of(nameOf(curve, k));
            for (std::array<std::string, kColumnCount> &row : rowsOf(set, curve, name)) {
                row[Specimen] = specimen;
                use(row);
                rows.push_back(std::move(row));
                landmarks.push_back(nullptr);
            }
            for (auto it = curve.extra.json().begin(); it != curve.extra.json().end(); ++it)
                notes.add(LandmarkNote::Kind::SpecimenKeysLeftOut, 1, it.key());
        }
    }
    std::string text;
    const char *separator = "";
    for (std::size_t column = 0; column < kColumnCount; ++column) {
        if (!isUsed[column])
            continue;
        text += separator + titleOf(column);
        separator = ",";
    }
    for (const std::string &other : others) {
        text += ',';
        appendCell(text, other);
    }
    text += '\n';
    for (std::size_t row = 0; row < rows.size(); ++row) {
        separator = "";
        for (std::size_t column = 0; column < kColumnCount; ++column) {
            if (!isUsed[column])
                continue;
            text += separator;
            appendCell(text, rows[row][column]);
            separator = ",";
        }
        for (const std::string &other : others) {
            text += ',';
            if (!landmarks[row])
                continue;
            const Json &extra = landmarks[row]->extra.json();
            if (extra.is_object() && extra.contains(other))
                appendCell(text, cellOf(extra[other]));
        }
        text += '\n';
    }
    return text;
}

WrittenLandmarks wideTable(std::span<const LandmarkSet> specimens)
{
    Notes notes;
    const std::vector<LandmarkSet> sets = withCurvesAsPoints(specimens, notes);
    std::vector<std::string> names;
    std::map<std::string, std::size_t> places;
    std::vector<std::map<std::size_t, const Landmark *>> rows;
    for (const LandmarkSet &set : sets) {
        auto &row = rows.emplace_back();
        std::map<std::string, std::size_t> counts;
        for (std::size_t i = 0; i < set.landmarks.size(); ++i) {
            std::string name = set.landmarks[i].name.empty() ? std::to_string(i + 1) : set.landmarks[i].name;
            if (const std::size_t count = ++counts[name]; count > 1)
                name += " (" + std::to_string(count) + ')';
            const auto [place, isNew] = places.try_emplace(name, names.size());
            if (isNew)
                names.push_back(name);
            row[place->second] = &set.landmarks[i];
        }
    }
    Holds held;
    held.names = held.specimenName = true;
    addLosses(notes, sets, held);
    std::string text = "specimen";
    for (const std::string &name : names) {
        for (const char *axis : {"_x", "_y", "_z"}) {
            text += ',';
            appendCell(text, name + axis);
        }
    }
    text += '\n';
    for (std::size_t i = 0; i < sets.size(); ++i) {
        appendCell(text, sets[i].name);
        for (std::size_t k = 0; k < names.size(); ++k) {
            const auto found = rows[i].find(k);
            if (found != rows[i].end() && found->second->world)
                appendNumbers(text, found->second->world->coordinates(), ',');
            else
                text += ",,,";
        }
        text += '\n';
    }
    return {std::move(text), notes.take()};
}

} // namespace unprojector::landmark_files
