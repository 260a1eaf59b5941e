#include "core/base/parallel.h"
#include "core/base/printable.h"
#include "core/base/text_scanner.h"
#include "core/base/translation.h"
#include "core/geometry/finite.h"
#include "core/mesh/import/mesh_normals.h"
#include "core/mesh/import/mesh_reader.h"
#include "core/mesh/import/obj_materials.h"
#include "core/mesh/import/polygon_triangulation.h"
#include "core/mesh/numbering.h"

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cstdint>
#include <deque>
#include <iterator>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <system_error>
#include <tuple>
#include <utility>

namespace unprojector::mesh::reader {
using namespace geometry;
using namespace base;

namespace {

constexpr std::size_t kCornersBetweenReports = 1 << 18;
constexpr std::int64_t kBeyond32Bits = std::int64_t{1} << 40;
/// More words than any valid vertex has.
constexpr int kMostVertexWords = 9;

/// Statements without shown geometry: groups, parts of curves, display attributes, commands. Some
/// programs add their own.
constexpr std::string_view kWithoutGeometry[] = {
    "vp",     "cstype", "deg",        "bmat",      "step",  "parm",  "trim",  "hole",       "scrv",     "sp",
    "end",    "con",    "g",          "s",         "mg",    "o",     "bevel", "c_interp",   "d_interp", "lod",
    "usemap", "maplib", "shadow_obj", "trace_obj", "ctech", "stech", "res",   "vertexcolor"};

/// Statements for unsupported geometry: curves and surfaces, also of older format versions; other
/// files; output of system commands.
constexpr std::string_view kNotShown[] = {"curv", "curv2", "surf", "bsp", "bzp", "cdc", "cdp", "call", "csh"};

bool isLineEnd(char c)
{
    return c == '\n' || c == '\r';
}

bool isBlank(char c)
{
    return c == ' ' || c == '\t' || c == '\v' || c == '\f';
}

/// Iterates over the statements of an OBJ file, which end at "#". A backslash at the end of a line
/// joins it with the next. Line ends: LF, CRLF or CR.
class ObjCursor {
public:
    explicit ObjCursor(std::string_view text) : m_at(text.data()), m_end(m_at + text.size()) {}

    bool isAtEnd() const { return m_at == m_end; }
    /// The number of line ends so far.
    std::size_t linesBefore() const { return m_lines; }

    /// Returns whether the statement has no further word.
    bool isAtStatementEnd()
    {
        while (m_at != m_end) {
            if (isBlank(*m_at)) {
                ++m_at;
                continue;
            }
            if (*m_at != '\\')
                return isLineEnd(*m_at) || *m_at == '#';
            const char *next = afterJoint(m_at);
            if (!next)
                return false;
            m_lines += next != m_end ? 1 : 0;
            m_at = next;
        }
        return true;
    }
    /// Moves to the start of the next statement.
    void skipStatement()
    {
        while (!isAtStatementEnd()) {
            while (!isAtWordEnd(m_at))
                ++m_at;
        }
        while (m_at != m_end && !isLineEnd(*m_at))
            ++m_at;
        if (m_at != m_end) {
            m_at = afterLineEnd(m_at);
            ++m_lines;
        }
    }
    /// The next word, empty at the end of the statement.
    std::string_view word()
    {
        if (isAtStatementEnd())
            return {};
        const char *begin = m_at;
        while (!isAtWordEnd(m_at))
            ++m_at;
        return {begin, static_cast<std::size_t>(m_at - begin)};
    }
    /// The rest of the line, comments included, without blanks at its ends: names may contain
    /// blanks and "#".
    std::string_view restOfLine()
    {
        while (m_at != m_end && isBlank(*m_at))
            ++m_at;
        const char *begin = m_at;
        while (m_at != m_end && !isLineEnd(*m_at))
            ++m_at;
        const char *end = m_at;
        while (end != begin && isBlank(end[-1]))
            --end;
        return {begin, static_cast<std::size_t>(end - begin)};
    }
    /// Reads the word as a number, rounded correctly. A number beyond the range of double becomes
    /// infinite or 0. The names that C libraries print for NaN and infinity are read too.
    /// @return false if it is no number; then the word is not consumed
    bool readNumber(double &value)
    {
        if (isAtStatementEnd())
            return false;
        const char *begin = m_at;
        if (*begin == '+' && begin + 1 != m_end && begin[1] != '-')
            ++begin;
        const std::from_chars_result result = std::from_chars(begin, m_end, value);
        if (result.ec == std::errc::invalid_argument)
            return false;
        if (result.ec == std::errc() && isAtWordEnd(result.ptr)
            && (result.ptr[-1] != '.' || result.ptr == m_end || *result.ptr != '#')) {
            m_at = result.ptr;
            return true;
        }
        // Out of range; or "1.#IND", whose # begins no comment.
        const char *end = result.ptr;
        while (end != m_end && !isBlank(*end) && !isLineEnd(*end) && !(*end == '#' && end[-1] != '.'))
            ++end;
        const std::optional<double> rare = doubleFromWord({begin, static_cast<std::size_t>(end - begin)});
        if (!rare)
            return false;
        value = *rare;
        m_at = end;
        return true;
    }
    /// Reads an integer up to the first character that cannot belong to it. A value beyond 32 bits
    /// becomes some number beyond 32 bits.
    /// @return false if there is none
    bool readInteger(std::int64_t &value)
    {
        const char *at = m_at;
        const bool isNegative = at != m_end && *at == '-';
        if (isNegative || (at != m_end && *at == '+'))
            ++at;
        const char *digits = at;
        std::int64_t sum = 0;
        for (; at != m_end && *at >= '0' && *at <= '9'; ++at)
            sum = sum < kBeyond32Bits ? sum * 10 + (*at - '0') : sum;
        if (at == digits)
            return false;
        value = isNegative ? -sum : sum;
        m_at = at;
        return true;
    }
    /// Consumes the next character if it equals c.
    bool readIf(char c)
    {
        if (m_at == m_end || *m_at != c)
            return false;
        ++m_at;
        return true;
    }
    bool isAtWordEnd() const { return isAtWordEnd(m_at); }

private:
    bool isAtWordEnd(const char *at) const
    {
        return at == m_end || isBlank(*at) || isLineEnd(*at) || *at == '#' || (*at == '\\' && afterJoint(at));
    }
    /// The start of the line that a backslash joins, or null if it joins none.
    const char *afterJoint(const char *backslash) const
    {
        const char *at = backslash + 1;
        while (at != m_end && isBlank(*at))
            ++at;
        if (at == m_end)
            return at;
        return isLineEnd(*at) ? afterLineEnd(at) : nullptr;
    }
    const char *afterLineEnd(const char *lineEnd) const
    {
        const bool isPair = *lineEnd == '\r' && lineEnd + 1 != m_end && lineEnd[1] == '\n';
        return lineEnd + (isPair ? 2 : 1);
    }

    const char *m_at;
    const char *m_end;
    std::size_t m_lines = 0;
};

/// The kinds of references of a face corner, in the order of "1/2/3". Also indexes counts and
/// arrays by kind.
enum ObjKind : std::size_t { ObjVertex, ObjTexcoord, ObjNormal };
constexpr std::size_t kObjKinds = 3;
using ObjCounts = std::array<std::int64_t, kObjKinds>;

/// Consecutive faces with the same properties.
struct ObjRun {
    std::uint32_t cornersEach = 3;
    std::uint32_t faces = 0;
    std::uint32_t material = 0; ///< into ObjChunk::materials
    bool hasTexcoords = false;  ///< at each corner
    bool hasNormals = false;    ///< at each corner

    bool isLike(const ObjRun &other) const
    {
        return cornersEach == other.cornersEach && material == other.material && hasTexcoords == other.hasTexcoords
               && hasNormals == other.hasNormals;
    }
};

/// What is not shown, or not as the file has it.
enum ObjLoss : std::size_t {
    LostLines,
    LostPoints,
    LostWords,     ///< vertices with more words than coordinates and colours
    LostWeights,   ///< vertices with a fourth number, not 1
    UnknownLines,  ///< that begin with an unknown word
    LostTexcoords, ///< faces without texture coordinates, though they name some
    LostNormals,   ///< faces without normals, though they name some
    kObjLosses
};
using ObjLosses = std::array<std::size_t, kObjLosses>;

/// Some whole statements of an OBJ file, parsed independently of the others. resolve() does the
/// parts that depend on the others.
class ObjChunk {
public:
    /// Parses the statements. Throws no error, since an earlier chunk may have failed first, see
    /// failure().
    void parse(std::string_view text)
    {
        m_text = text;
        if (const std::size_t zero = text.find('\0'); zero != text.npos) {
            TextScanner before(text.substr(0, zero));
            while (!before.isAtEnd())
                before.skipLine();
            m_failure = {before.line() - 1, tr("the text has a byte 0; save the file as UTF-8 or ASCII text")};
            return;
        }
        ObjCursor cursor(text);
        while (!cursor.isAtEnd() && !m_failure) {
            readStatement(cursor);
            cursor.skipStatement();
        }
        m_lineCount = cursor.linesBefore();
    }
    /// Numbers the corners from the beginning of the file. References to missing texture
    /// coordinates or normals are removed from their faces.
    /// @param before  the counts of all chunks before
    /// @param linesBefore  theirs, for messages
    /// Throws Damage for a face with a vertex that the file does not have.
    void resolve(const ObjCounts &before, const ObjCounts &total, std::size_t linesBefore)
    {
        for (std::size_t kind = 0; kind < kObjKinds; ++kind) {
            for (const std::size_t at : m_countedBack[kind])
                corners[kind][at] += static_cast<std::int32_t>(before[kind]);
            m_countedBack[kind] = {};
            if (kind != ObjVertex && !corners[kind].empty())
                corners[kind].resize(corners[ObjVertex].size(), -1);
        }
        const std::vector<std::int32_t> &vertices = corners[ObjVertex];
        const auto vertexCount = static_cast<std::uint32_t>(total[ObjVertex]);
        const auto missing = std::find_if(vertices.begin(), vertices.end(), [vertexCount](std::int32_t vertex) {
            return static_cast<std::uint32_t>(vertex) >= vertexCount;
        });
        if (missing != vertices.end()) {
            auto corner = static_cast<std::size_t>(missing - vertices.begin());
            std::size_t face = 0;
            for (const ObjRun &run : runs) {
                const std::size_t inRun = std::size_t{run.cornersEach} * run.faces;
                if (corner < inRun) {
                    face += corner / run.cornersEach;
                    break;
                }
                corner -= inRun;
                face += run.faces;
            }
            failAtFace(face, before, total, linesBefore);
        }
        if (!corners[ObjTexcoord].empty() || !corners[ObjNormal].empty())
            checkParts(total);
    }

    /// The first statement that cannot be used.
    struct StatementFailure {
        std::size_t line;    ///< of the chunk, counted from 0
        std::string message; ///< without the line; empty: the next vertex is not finite
    };
    const std::optional<StatementFailure> &failure() const { return m_failure; }
    std::size_t lineCount() const { return m_lineCount; }
    ObjCounts counts() const
    {
        return {static_cast<std::int64_t>(positions.size()), static_cast<std::int64_t>(texcoords.size()),
                static_cast<std::int64_t>(normals.size())};
    }

    std::vector<glm::dvec3> positions;
    geometry::Box box;
    std::vector<glm::u8vec4> colors; ///< one a position, or empty
    std::vector<glm::vec2> texcoords;
    std::vector<glm::vec3> normals;
    std::vector<ObjRun> runs;
    /// The references of all face corners by ObjKind, counted from 0 once resolved. Texture
    /// coordinates and normals: either for all corners, −1 for a missing one, or empty.
    std::array<std::vector<std::int32_t>, kObjKinds> corners;
    /// The names after "usemtl". The first is a placeholder for the last name before this chunk.
    std::vector<std::string> materials{std::string()};
    std::vector<std::string> libraries; ///< the rest of each line after "mtllib"

    ObjLosses losses{};
    std::size_t firstUnknownLine = 0;            ///< number of lines of the chunk before it
    std::string firstUnknown;                    ///< its first word
    std::map<std::string, std::size_t> notShown; ///< free-form curves and the like, by keyword

private:
    using Corner = std::array<std::int64_t, kObjKinds>; ///< as written, 0: none

    void fail(ObjCursor &cursor, std::string message)
    {
        if (!m_failure)
            m_failure = {cursor.linesBefore(), std::move(message)};
    }

    void readStatement(ObjCursor &cursor)
    {
        const std::string_view keyword = cursor.word();
        if (keyword == "v") {
            readVertex(cursor);
        } else if (keyword == "f" || keyword == "fo") {
            readFace(cursor);
        } else if (keyword == "vn") {
            double values[3] = {};
            readVector(cursor, marked("a normal"), 3, 3, values);
            normals.emplace_back(values[0], values[1], values[2]);
        } else if (keyword == "vt") {
            double values[2] = {};
            readVector(cursor, marked("a texture coordinate"), 1, 2, values);
            texcoords.emplace_back(values[0], values[1]);
        } else if (!keyword.empty()) {
            readOther(cursor, keyword);
        }
    }

    void readVertex(ObjCursor &cursor)
    {
        double values[kMostVertexWords];
        int count = 0;
        while (count < kMostVertexWords && cursor.readNumber(values[count]))
            ++count;
        if (count < 3) {
            const std::string_view word = cursor.word();
            fail(cursor, word.empty() ? tr("a vertex needs three numbers")
                                      : tr("a vertex needs three numbers, not %1", quoted(word)));
            return;
        }
        // x y z, x y z w, x y z r g b, x y z r g b a, x y z w r g b a.
        const bool isKnown = (count <= 8 && count != 5) && cursor.isAtStatementEnd();
        // The format defines w as a weight in rational curves and surfaces. It has no meaning for
        // polygons.
        const bool hasWeight = (count == 4 || count == 8) && values[3] != 1.0;
        losses[LostWords] += isKnown ? 0U : 1U;
        losses[LostWeights] += isKnown && hasWeight ? 1U : 0U;
        const glm::dvec3 position(values[0], values[1], values[2]);
        if (!isFinite(position)) {
            fail(cursor, {});
            return;
        }
        if (isKnown && count >= 6) {
            const double *color = values + (count == 8 ? 4 : 3);
            colors.resize(positions.size(), glm::u8vec4(255));
            colors.emplace_back(byteFromShare(color[0]), byteFromShare(color[1]), byteFromShare(color[2]),
                                count == 6 ? std::uint8_t{255} : byteFromShare(color[3]));
        } else if (!colors.empty()) {
            colors.emplace_back(255);
        }
        positions.push_back(position);
        box.add(position);
    }

    void readVector(ObjCursor &cursor, const char *what, int least, int most, double *values)
    {
        int count = 0;
        while (count < most && cursor.readNumber(values[count]))
            ++count;
        if (count >= least)
            return;
        const std::string_view word = cursor.word();
        std::string message = tr(least == 1 ? "%1 needs a number" : "%1 needs three numbers", tr(what));
        if (!word.empty())
            message = tr("%1, not %2", message, quoted(word));
        fail(cursor, std::move(message));
    }

    /// Reads "1", "1/2", "1//3" or "1/2/3".
    static bool readCorner(ObjCursor &cursor, Corner &corner)
    {
        corner = {};
        if (!cursor.readInteger(corner[ObjVertex]))
            return false;
        for (std::size_t kind = ObjTexcoord; kind < kObjKinds && cursor.readIf('/'); ++kind)
            cursor.readInteger(corner[kind]);
        return cursor.isAtWordEnd();
    }

    void addCorner(ObjKind kind, std::int64_t number, bool isNamed)
    {
        constexpr std::int64_t kMost = std::numeric_limits<std::int32_t>::max();
        std::vector<std::int32_t> &ofKind = corners[kind];
        const std::size_t at = corners[ObjVertex].size() - (kind == ObjVertex ? 0 : 1);
        if (kind != ObjVertex) {
            if (ofKind.empty() && !isNamed)
                return;
            ofKind.resize(at, -1);
        }
        if (number < 0) {
            m_countedBack[kind].push_back(at);
            number += counts()[kind];
            ofKind.push_back(static_cast<std::int32_t>(std::max(number, -kMost)));
        } else {
            ofKind.push_back(static_cast<std::int32_t>(std::min(number, kMost) - 1));
        }
    }

    void dropCornersFrom(std::size_t first)
    {
        for (std::size_t kind = 0; kind < kObjKinds; ++kind) {
            if (corners[kind].size() > first)
                corners[kind].resize(first);
            while (!m_countedBack[kind].empty() && m_countedBack[kind].back() >= first)
                m_countedBack[kind].pop_back();
        }
    }

    void addFace(ObjRun face)
    {
        face.faces = 1;
        if (!runs.empty() && runs.back().isLike(face))
            ++runs.back().faces;
        else
            runs.push_back(face);
    }

    void readFace(ObjCursor &cursor)
    {
        const std::size_t first = corners[ObjVertex].size();
        ObjRun face{0, 1, m_material, true, true};
        bool namesTexcoords = false;
        while (!cursor.isAtStatementEnd()) {
            ObjCursor word = cursor;
            Corner corner;
            if (!readCorner(cursor, corner)) {
                fail(cursor, tr("%1 is not a corner of a face", quoted(word.word())));
                return;
            }
            addCorner(ObjVertex, corner[ObjVertex], true);
            addCorner(ObjTexcoord, corner[ObjTexcoord], corner[ObjTexcoord] != 0);
            addCorner(ObjNormal, corner[ObjNormal], corner[ObjNormal] != 0);
            namesTexcoords = namesTexcoords || corner[ObjTexcoord] != 0;
            face.hasTexcoords = face.hasTexcoords && corner[ObjTexcoord] != 0;
            face.hasNormals = face.hasNormals && corner[ObjNormal] != 0;
            ++face.cornersEach;
        }
        if (face.cornersEach < 3) {
            dropCornersFrom(first);
            ++losses[LostLines];
            return;
        }
        losses[LostTexcoords] += namesTexcoords && !face.hasTexcoords ? 1 : 0;
        addFace(face);
    }

    void readOther(ObjCursor &cursor, std::string_view keyword)
    {
        if (keyword == "usemtl") {
            const std::string_view name = cursor.restOfLine();
            if (name.empty() || name == materials[m_material])
                return;
            m_material = static_cast<std::uint32_t>(materials.size());
            materials.emplace_back(name);
        } else if (keyword == "mtllib") {
            const std::string_view names = cursor.restOfLine();
            if (!names.empty() && (libraries.empty() || libraries.back() != names))
                libraries.emplace_back(names);
        } else if (keyword == "l") {
            ++losses[LostLines];
        } else if (keyword == "p") {
            while (!cursor.word().empty())
                ++losses[LostPoints];
        } else if (std::find(std::begin(kNotShown), std::end(kNotShown), keyword) != std::end(kNotShown)) {
            ++notShown[std::string(keyword)];
        } else if (std::find(std::begin(kWithoutGeometry), std::end(kWithoutGeometry), keyword)
                   == std::end(kWithoutGeometry)) {
            if (losses[UnknownLines]++ == 0) {
                firstUnknownLine = cursor.linesBefore();
                firstUnknown = base::printableBeginning(keyword, 40);
            }
        }
    }

    /// Removes the texture coordinates or normals from faces that name missing ones.
    void checkParts(const ObjCounts &total)
    {
        const auto isMissing = [&](ObjKind kind, std::size_t corner) {
            return static_cast<std::uint32_t>(corners[kind][corner]) >= static_cast<std::uint32_t>(total[kind]);
        };
        const std::vector<ObjRun> named = std::move(runs);
        runs.clear();
        std::size_t corner = 0;
        for (const ObjRun &run : named) {
            for (std::uint32_t f = 0; f < run.faces; ++f) {
                ObjRun face = run;
                for (std::uint32_t c = 0; c < run.cornersEach; ++c, ++corner) {
                    face.hasTexcoords = face.hasTexcoords && !isMissing(ObjTexcoord, corner);
                    face.hasNormals = face.hasNormals && !isMissing(ObjNormal, corner);
                }
                losses[LostTexcoords] += run.hasTexcoords && !face.hasTexcoords ? 1 : 0;
                losses[LostNormals] += run.hasNormals && !face.hasNormals ? 1 : 0;
                addFace(face);
            }
        }
    }

    /// Reads the lines again: to save memory, the line of each face is not stored for the rare error.
    [[noreturn]] void failAtFace(std::size_t face, const ObjCounts &before, const ObjCounts &total,
                                 std::size_t linesBefore) const
    {
        ObjCursor cursor(m_text);
        ObjCounts soFar = before;
        for (std::size_t faces = 0; !cursor.isAtEnd(); cursor.skipStatement()) {
            const std::string_view keyword = cursor.word();
            soFar[ObjVertex] += keyword == "v" ? 1 : 0;
            if (keyword != "f" && keyword != "fo")
                continue;
            ObjCursor ahead = cursor;
            std::size_t count = 0;
            while (!ahead.word().empty())
                ++count;
            if (count < 3 || faces++ != face)
                continue;
            Corner corner;
            while (!cursor.isAtStatementEnd() && readCorner(cursor, corner)) {
                const std::int64_t number = corner[ObjVertex];
                const bool exists = number > 0 ? number <= total[ObjVertex] : number < 0 && number >= -soFar[ObjVertex];
                if (!exists)
                    failMalformed(tr("line %1: a face refers to vertex %2, the file has %3",
                                     linesBefore + cursor.linesBefore() + 1, number, total[ObjVertex]));
            }
        }
        failMalformed(tr("a face refers to a vertex that the file does not have"));
    }

    std::string_view m_text;
    std::size_t m_lineCount = 0;
    std::optional<StatementFailure> m_failure;
    std::uint32_t m_material = 0;
    /// Indices of corners with a relative number, counted back from their line. They are resolved
    /// when all chunks are known.
    std::array<std::vector<std::size_t>, kObjKinds> m_countedBack;
};

/// The next possible end of a chunk: after a line that no backslash joins with the next.
std::size_t statementEnd(std::string_view text, std::size_t from)
{
    for (std::size_t at = from; at < text.size(); ++at) {
        if (!isLineEnd(text[at]) || (text[at] == '\r' && at + 1 < text.size() && text[at + 1] == '\n'))
            continue;
        std::size_t last = at;
        while (last > 0 && (isLineEnd(text[last]) || text[last] == ' ' || text[last] == '\t'))
            --last;
        if (text[last] != '\\')
            return at + 1;
    }
    return text.size();
}

/// The vertices of a mesh: one for each combination of position, texture coordinate and normal in its
/// corners.
class ObjVertices {
public:
    /// The indices by ObjKind, counted from 0; −1: none.
    using Vertex = std::array<std::int32_t, kObjKinds>;

    /// @param kept  this many of the file's vertices keep their numbers: the first combination of
    ///         each gets its number, others are appended. With 0, vertices are numbered in the
    ///         order of use.
    explicit ObjVertices(std::size_t kept) : m_isUsed(kept, false), m_kept(kept)
    {
        for (std::size_t v = 0; v < kept; ++v)
            m_kept[v] = {static_cast<std::int32_t>(v), -1, -1};
    }
    /// The vertex's number in the mesh.
    std::uint32_t add(const Vertex &vertex)
    {
        const auto position = static_cast<std::size_t>(vertex[ObjVertex]);
        if (position < m_kept.size()) {
            if (!m_isUsed[position])
                m_kept[position] = vertex;
            m_isUsed[position] = true;
            if (m_kept[position] == vertex)
                return static_cast<std::uint32_t>(position);
        }
        return static_cast<std::uint32_t>(m_kept.size()) + m_others.add(vertex);
    }
    std::size_t count() const { return m_kept.size() + m_others.size(); }
    /// An unused vertex has neither texture coordinate nor normal.
    const Vertex &operator[](std::size_t number) const
    {
        return number < m_kept.size() ? m_kept[number] : m_others.keys()[number - m_kept.size()];
    }

private:
    struct Hash {
        std::uint64_t operator()(const Vertex &vertex) const
        {
            return hashOf(std::bit_cast<std::array<std::uint32_t, kObjKinds>>(vertex));
        }
    };
    std::vector<bool> m_isUsed;
    std::vector<Vertex> m_kept;
    Numbering<Vertex, Hash> m_others;
};

/// Combines the chunks.
class ObjReader {
public:
    explicit ObjReader(const Source &source) : m_source(source), m_materials(source, m_model) {}

    Model read()
    {
        parse();
        throwFirstFailure();
        placePositions();
        resolveFaces();
        addNotes();
        if (m_hasFaces)
            makeMeshes();
        else
            makePoints();
        return std::move(m_model);
    }

private:
    /// Consecutive corners of triangles.
    struct Corners {
        std::size_t chunk, begin, end;
    };
    /// A mesh of the model, and the position of its faces.
    struct Part {
        Material material;
        bool hasTexcoords = false;
        bool hasNormals = false;
        std::vector<Corners> corners;
        std::size_t cornerCount = 0;
    };

    void parse()
    {
        const std::vector<std::string_view> pieces = textPieces(m_source.unpaddedText(), statementEnd);
        m_chunks.resize(pieces.size());
        inParallel(pieces.size(), m_source.progress.part(0.0, 0.6),
                   [&](std::size_t i) { m_chunks[i].parse(pieces[i]); });
    }

    void throwFirstFailure()
    {
        std::size_t lines = 0;
        std::size_t faces = 0;
        for (const ObjChunk &chunk : m_chunks) {
            if (chunk.failure() && chunk.failure()->message.empty())
                failNotFinite(static_cast<std::size_t>(m_total[ObjVertex]) + chunk.positions.size());
            if (chunk.failure())
                failAtLine(lines + chunk.failure()->line + 1, chunk.failure()->message);
            lines += chunk.lineCount();
            m_before.push_back(m_total);
            for (std::size_t kind = 0; kind < kObjKinds; ++kind)
                m_total[kind] += chunk.counts()[kind];
            faces += chunk.runs.size();
        }
        m_hasFaces = faces > 0;
        // Any text file would pass up to here.
        if (m_total[ObjVertex] == 0 && !m_hasFaces)
            failMalformed(tr("the file holds no OBJ vertices and no faces"));
        if (*std::max_element(m_total.begin(), m_total.end()) >= std::numeric_limits<std::int32_t>::max())
            failMalformed(tr("the file has more than 2147483646 vertices"));
    }

    void placePositions()
    {
        Box box;
        for (const ObjChunk &chunk : m_chunks)
            box.add(chunk.box);
        m_vertices.origin = originFor(box);
        m_model.fileVertices = static_cast<std::size_t>(m_total[ObjVertex]);
        m_vertices.positions.reserve(m_model.fileVertices);
        const bool hasColors =
            std::any_of(m_chunks.begin(), m_chunks.end(), [](const ObjChunk &chunk) { return !chunk.colors.empty(); });
        for (std::size_t i = 0; i < m_chunks.size(); ++i) {
            m_source.progress.part(0.6, 0.65)(static_cast<double>(i) / static_cast<double>(m_chunks.size()));
            ObjChunk &chunk = m_chunks[i];
            for (const glm::dvec3 &position : chunk.positions) {
                addPosition(m_vertices, position);
                if (!isFinite(m_vertices.positions.back()))
                    failNotFinite(m_vertices.positions.size() - 1);
            }
            chunk.positions = {};
            std::vector<glm::u8vec4> &colors = m_vertices.colors;
            colors.insert(colors.end(), chunk.colors.begin(), chunk.colors.end());
            if (hasColors)
                colors.resize(m_vertices.positions.size(), glm::u8vec4(255));
            m_texcoords.insert(m_texcoords.end(), chunk.texcoords.begin(), chunk.texcoords.end());
            m_normals.insert(m_normals.end(), chunk.normals.begin(), chunk.normals.end());
        }
    }

    void resolveFaces()
    {
        std::vector<std::size_t> linesBefore(m_chunks.size());
        for (std::size_t i = 1; i < m_chunks.size(); ++i)
            linesBefore[i] = linesBefore[i - 1] + m_chunks[i - 1].lineCount();
        inParallel(m_chunks.size(), m_source.progress.part(0.65, 0.85), [&](std::size_t i) {
            ObjChunk &chunk = m_chunks[i];
            chunk.resolve(m_before[i], m_total, linesBefore[i]);
            triangulate(chunk);
            chunk.colors = {};
            chunk.texcoords = {};
            chunk.normals = {};
        });
    }

    /// Triangulates all faces of a chunk.
    void triangulate(ObjChunk &chunk) const
    {
        if (std::all_of(chunk.runs.begin(), chunk.runs.end(), [](const ObjRun &run) { return run.cornersEach == 3; }))
            return;
        PolygonTriangulator triangulator;
        std::vector<glm::vec3> outline;
        std::vector<std::uint32_t> triangles; // corner indices within the face
        std::array<std::vector<std::int32_t>, kObjKinds> cut;
        std::size_t first = 0;
        for (ObjRun &run : chunk.runs) {
            for (std::uint32_t face = 0; face < run.faces; ++face, first += run.cornersEach) {
                outline.clear();
                for (std::size_t corner = first; corner < first + run.cornersEach; ++corner)
                    outline.push_back(m_vertices.positions[static_cast<std::size_t>(chunk.corners[ObjVertex][corner])]);
                triangles.clear();
                triangulator.triangulate(outline, triangles);
                for (std::size_t kind = 0; kind < kObjKinds; ++kind) {
                    if (chunk.corners[kind].empty())
                        continue;
                    for (const std::uint32_t corner : triangles)
                        cut[kind].push_back(chunk.corners[kind][first + corner]);
                }
            }
            run.faces *= run.cornersEach - 2;
            run.cornersEach = 3;
        }
        chunk.corners = std::move(cut);
    }

    void addNotes()
    {
        ObjLosses losses{};
        std::vector<std::string> unknown; // the first: its word and line
        std::size_t linesBefore = 0;
        std::map<std::string, std::size_t> notShown;
        for (const ObjChunk &chunk : m_chunks) {
            if (unknown.empty() && chunk.losses[UnknownLines] > 0)
                unknown = {chunk.firstUnknown, std::to_string(linesBefore + chunk.firstUnknownLine + 1)};
            linesBefore += chunk.lineCount();
            for (std::size_t kind = 0; kind < kObjLosses; ++kind)
                losses[kind] += chunk.losses[kind];
            for (const auto &[keyword, count] : chunk.notShown)
                notShown[keyword] += count;
        }
        std::vector<Note> &notes = m_model.notes;
        noteLines(notes, losses[LostLines] + (m_hasFaces ? losses[LostPoints] : 0));
        noteVerticesWithMore(notes, losses[LostWords]);
        addNote(notes, losses[LostWeights],
                marked("%1 vertex has a fourth number, the weight of rational curves: it is not used"),
                marked("%1 vertices have a fourth number, the weight of rational curves: it is not used"));
        addNote(
            notes, losses[UnknownLines],
            marked("not used: %1 line that begins with a word unknown to the format, \"%2\" in line %3"),
            marked("not used: %1 lines that begin with words unknown to the format, the first is \"%2\" in line %3"),
            unknown);
        addNote(notes, losses[LostTexcoords],
                marked("%1 face refers to texture coordinates that the file does not have: shown without an image"),
                marked("%1 faces refer to texture coordinates that the file does not have: shown without an image"));
        addNote(notes, losses[LostNormals],
                marked("%1 face refers to normals that the file does not have: they are computed instead"),
                marked("%1 faces refer to normals that the file does not have: they are computed instead"));
        for (const auto &[keyword, count] : notShown)
            noteParts(notes, count, keyword);
    }

    /// Makes one part for each material and set of attributes, in the order of the file.
    void sortIntoParts()
    {
        std::set<std::string> libraries;
        for (const ObjChunk &chunk : m_chunks) {
            for (const std::string &names : chunk.libraries) {
                if (libraries.insert(names).second)
                    m_materials.readLibraries(names);
            }
        }
        std::map<std::string, std::size_t> numbers; // index by name in `materials`; first: no material
        std::vector<Material> materials(1);
        std::vector<std::string> unknown;
        std::map<std::tuple<std::size_t, bool, bool>, std::size_t> partNumbers;
        std::size_t current = 0;
        for (std::size_t c = 0; c < m_chunks.size(); ++c) {
            const ObjChunk &chunk = m_chunks[c];
            std::vector<std::size_t> materialOfName{current};
            for (std::size_t name = 1; name < chunk.materials.size(); ++name) {
                const auto [known, isNew] = numbers.try_emplace(chunk.materials[name], 0);
                if (isNew) {
                    if (const std::optional<Material> material = m_materials.find(known->first)) {
                        known->second = materials.size();
                        materials.push_back(*material);
                    } else {
                        unknown.push_back(known->first);
                    }
                }
                materialOfName.push_back(known->second);
            }
            current = materialOfName.back();
            std::size_t corner = 0;
            for (const ObjRun &run : chunk.runs) {
                const std::size_t number = materialOfName[run.material];
                const bool hasTexcoords = run.hasTexcoords && materials[number].texture >= 0;
                const auto [known, isNew] =
                    partNumbers.try_emplace({number, hasTexcoords, run.hasNormals}, m_parts.size());
                if (isNew)
                    m_parts.push_back({materials[number], hasTexcoords, run.hasNormals, {}, 0});
                Part &part = m_parts[known->second];
                const std::size_t end = corner + std::size_t{3} * run.faces;
                part.corners.push_back({c, corner, end});
                part.cornerCount += end - corner;
                corner = end;
            }
        }
        // A missing library already has a note.
        if (const std::size_t others = unknown.size() - 1; !unknown.empty() && !m_materials.isAnyMissing())
            m_model.notes.push_back(
                {marked(others == 0 ? "no material is called \"%1\": its surfaces are shown in grey"
                        : others == 1
                            ? "no material is called \"%1\" or by %2 other name of the file: its surfaces are "
                              "shown in grey"
                            : "no material is called \"%1\" or by %2 other names of the file: its surfaces are "
                              "shown in grey"),
                 {unknown.front(), std::to_string(others)}});
    }

    void makeMeshes()
    {
        sortIntoParts();
        for (const Part &part : m_parts)
            m_cornerCount += part.cornerCount;
        const bool isOnly = m_parts.size() == 1;
        for (const Part &part : m_parts) {
            Mesh mesh = isOnly && !part.hasNormals && !part.hasTexcoords ? plainMesh() : splitMesh(part, isOnly);
            mesh.origin = m_vertices.origin;
            mesh.texture = part.hasTexcoords ? part.material.texture : -1;
            mesh.baseColor = part.material.baseColorOf(mesh.kind, !mesh.colors.empty());
            m_model.meshes.push_back(std::move(mesh));
        }
    }

    /// The whole file as one mesh, without splitting vertices.
    Mesh plainMesh()
    {
        Mesh mesh;
        mesh.indices.reserve(m_parts.front().cornerCount);
        for (std::size_t i = 0; i < m_chunks.size(); ++i) {
            m_source.progress.part(0.85, 1.0)(static_cast<double>(i) / static_cast<double>(m_chunks.size()));
            std::vector<std::int32_t> &vertices = m_chunks[i].corners[ObjVertex];
            mesh.indices.insert(mesh.indices.end(), vertices.begin(), vertices.end());
            vertices = {};
        }
        mesh.positions = std::move(m_vertices.positions);
        mesh.remainders = std::move(m_vertices.remainders);
        mesh.colors = std::move(m_vertices.colors);
        return mesh;
    }

    /// Makes a vertex for each combination of position, texture coordinate and normal in the corners.
    /// @param isOnly  then the file's vertices keep their numbers, and split ones are appended; else
    ///         vertices are in the order of use
    Mesh splitMesh(const Part &part, bool isOnly)
    {
        ObjVertices vertices(isOnly ? m_vertices.positions.size() : 0);
        Mesh mesh;
        mesh.indices.reserve(part.cornerCount);
        for (const Corners &corners : part.corners) {
            const ObjChunk &chunk = m_chunks[corners.chunk];
            for (std::size_t corner = corners.begin; corner < corners.end; ++corner) {
                if (++m_cornersDone % kCornersBetweenReports == 0)
                    m_source.progress.part(0.85, 1.0)(static_cast<double>(m_cornersDone)
                                                      / static_cast<double>(m_cornerCount));
                mesh.indices.push_back(vertices.add({chunk.corners[ObjVertex][corner],
                                                     part.hasTexcoords ? chunk.corners[ObjTexcoord][corner] : -1,
                                                     part.hasNormals ? chunk.corners[ObjNormal][corner] : -1}));
            }
        }
        for (std::size_t number = 0; number < vertices.count(); ++number) {
            const ObjVertices::Vertex &of = vertices[number];
            mesh.vertexNumbers.push_back(static_cast<std::uint32_t>(of[ObjVertex]));
            if (part.hasTexcoords)
                mesh.texcoords.push_back(of[ObjTexcoord] >= 0 ? m_texcoords[static_cast<std::size_t>(of[ObjTexcoord])]
                                                              : glm::vec2(0.0f));
            if (part.hasNormals)
                mesh.normals.push_back(of[ObjNormal] >= 0 ? m_normals[static_cast<std::size_t>(of[ObjNormal])]
                                                          : glm::vec3(0.0f, 0.0f, 1.0f));
        }
        mesh.positions = gathered(m_vertices.positions, mesh.vertexNumbers);
        mesh.remainders = gathered(m_vertices.remainders, mesh.vertexNumbers);
        mesh.colors = gathered(m_vertices.colors, mesh.vertexNumbers);
        if (isOnly && vertices.count() == m_vertices.positions.size())
            mesh.vertexNumbers = {};
        return mesh;
    }

    void makePoints()
    {
        Mesh mesh = std::move(m_vertices);
        mesh.kind = Mesh::Kind::Points;
        mesh.baseColor = Material{}.baseColorOf(mesh.kind, !mesh.colors.empty());
        m_model.meshes.push_back(std::move(mesh));
    }

    const Source &m_source;
    Model m_model;
    ObjMaterials m_materials;
    std::deque<ObjChunk> m_chunks;
    ObjCounts m_total{};
    std::vector<ObjCounts> m_before; ///< of each chunk
    Mesh m_vertices;                 ///< all positions and colours of the file
    std::vector<glm::vec2> m_texcoords;
    std::vector<glm::vec3> m_normals;
    bool m_hasFaces = false;
    std::vector<Part> m_parts;
    std::size_t m_cornerCount = 0, m_cornersDone = 0;
};

} // namespace

Model readObj(const Source &source)
{
    return ObjReader(source).read();
}

} // namespace unprojector::mesh::reader
