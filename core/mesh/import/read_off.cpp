#include "core/base/byte_order.h"
#include "core/base/text_scanner.h"
#include "core/base/translation.h"
#include "core/mesh/import/mesh_reader.h"
#include "core/mesh/import/polygon_mesh.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <optional>
#include <span>

namespace unprojector::mesh::reader {
using namespace geometry;
using base::doubleFromWord;
using base::floatFromWord;
using base::integerFromWord;
using base::marked;
using base::quoted;
using base::TextScanner;
using base::tr;

namespace {

constexpr std::size_t kElementsBetweenReports = 1 << 14;

/// The first word, [ST][C][N]OFF, and whether the file is binary.
struct OffKind {
    bool hasTexcoords = false;
    bool hasColors = false;
    bool hasNormals = false;
    bool isBinary = false;
    std::endian byteOrder = std::endian::big;
};

/// Reads the first word.
/// @return its length: in some files the vertex count follows without a blank. 0 if it is missing
std::size_t readOffWord(std::string_view word, OffKind &kind)
{
    std::string_view rest = word;
    const auto take = [&rest](std::string_view prefix) {
        const bool found = rest.starts_with(prefix);
        rest.remove_prefix(found ? prefix.size() : 0);
        return found;
    };
    for (std::size_t before = 0; before != rest.size();) { // MeshLab writes NCOFF
        before = rest.size();
        kind.hasTexcoords = take("ST") || kind.hasTexcoords;
        kind.hasColors = take("C") || kind.hasColors;
        kind.hasNormals = take("N") || kind.hasNormals;
    }
    if (take("OFF") && (rest.empty() || integerFromWord(rest)))
        return word.size() - rest.size();
    if (rest.starts_with("4OFF") || rest.starts_with("nOFF") || rest.starts_with("4nOFF"))
        failUnsupported(tr("its first word is %1, and only OFF with ST, C or N before it can be read", quoted(word)));
    if (!integerFromWord(word)) // the word is optional: the file may begin with the counts
        failMalformed(tr("the file does not begin with \"OFF\""));
    kind = {};
    return 0;
}

/// The file's numbers: words in text, or binary. In text each vertex and each face begins a line.
/// It may continue on the following lines, but must end with the last of them, so that a missing
/// number does not consume one of the next line.
class OffNumbers {
public:
    OffNumbers(const Source &source, std::size_t offset, std::size_t line, const OffKind &kind)
        : m_bytes(source.bytes), m_at(offset), m_scanner(source.unpaddedText(), offset, line),
          m_isBinary(kind.isBinary), m_byteOrder(kind.byteOrder)
    {
    }

    std::size_t offset() const { return m_isBinary ? m_at : m_scanner.offset(); }
    std::size_t bytesLeft() const { return m_bytes.size() - offset(); }
    std::size_t leastBytes() const { return m_isBinary ? 4 : 2; }

    /// Moves to the next line with more than a comment (text only).
    void beginLine(const char *what)
    {
        if (m_isBinary)
            return;
        skipComments();
        m_brokenLine = 0;
        if (m_scanner.isAtEnd())
            failTruncated(what);
    }

    std::int64_t integer(const char *what)
    {
        if (m_isBinary)
            return static_cast<std::int32_t>(bits(what));
        const std::string_view word = wordInLine(what);
        const std::optional<long long> value = integerFromWord(word);
        if (!value)
            failWord(word, what);
        return *value;
    }

    template <std::size_t count>
    std::array<double, count> reals(const char *what)
    {
        std::array<double, count> values;
        for (double &value : values)
            value = real(what);
        return values;
    }

    /// Skips the number of edges: it has no meaning, and some files omit it. In text it follows the
    /// number of faces, or is alone on the next line.
    void skipEdges()
    {
        if (m_isBinary) {
            integer(marked("number of edges"));
            return;
        }
        if (const std::string_view word = nextWordInLine(); !word.empty()) {
            if (!integerFromWord(word))
                failWord(word, marked("number of edges"));
            m_scanner.skipLine();
            return;
        }
        skipComments();
        const TextScanner before = m_scanner;
        const std::string_view word = nextWordInLine();
        if (!integerFromWord(word) || !nextWordInLine().empty())
            m_scanner = before;
    }

    /// Reads the numbers in the rest of the line. Stops at a word that is no number.
    /// @return whether all words were read
    bool restOfLine(std::vector<float> &values)
    {
        values.clear();
        m_areIntegers = true;
        std::string_view word = nextWordInLine();
        if (m_brokenLine > 0 && !word.empty())
            failBroken();
        for (; !word.empty(); word = nextWordInLine()) {
            const std::optional<float> value = floatFromWord(word);
            if (!value)
                break;
            m_areIntegers = m_areIntegers && integerFromWord(word).has_value();
            values.push_back(*value);
        }
        m_scanner.skipLine();
        return word.empty();
    }

    /// Determines, before the faces of a binary file, whether each is followed by its colour count,
    /// as the format demands. Some programs omit it; then the file would end too early.
    void findFaceColors(std::size_t count)
    {
        if (!m_isBinary)
            return;
        const std::size_t begin = m_at;
        const auto skip = [&](std::uint64_t words) {
            const bool isThere = words <= bytesLeft() / 4;
            m_at += isThere ? 4 * static_cast<std::size_t>(words) : 0;
            return isThere;
        };
        bool areThere = true;
        for (std::size_t face = 0; face < count && areThere; ++face) {
            for (int part = 0; part < 2 && areThere; ++part) // corners, colours
                areThere = bytesLeft() >= 4 && skip(bits(""));
        }
        m_at = begin;
        m_hasFaceColors = areThere;
    }

    /// The numbers after a face: up to four of the line, or as many as the binary count says.
    std::vector<float> faceColor()
    {
        std::vector<float> values;
        if (m_isBinary) {
            const std::int64_t count = m_hasFaceColors ? integer(marked("face colour")) : 0;
            for (std::int64_t i = 0; i < count; ++i)
                values.push_back(static_cast<float>(real(marked("face colour"))));
        } else {
            restOfLine(values);
        }
        values.resize(std::min<std::size_t>(values.size(), 4));
        return values;
    }

    /// True if restOfLine() read only integers.
    bool areIntegers() const { return m_areIntegers; }

    /// Ends the file after the last face. In text only comments may follow.
    /// @return the number of bytes that follow in a binary file, 0 if they are blank
    std::size_t end()
    {
        if (m_isBinary)
            return bytesThatMean(m_bytes.subspan(m_at));
        skipComments();
        if (const std::string_view word = m_scanner.nextWord(); !word.empty())
            failMalformed(
                tr("line %1: %2 follows all that the header declares; correct its numbers of vertices and faces",
                   m_scanner.line(), quoted(word)));
        return 0;
    }

private:
    double real(const char *what)
    {
        if (m_isBinary)
            return static_cast<double>(std::bit_cast<float>(bits(what)));
        const std::string_view word = wordInLine(what);
        const std::optional<double> value = doubleFromWord(word);
        if (!value)
            failWord(word, what);
        return *value;
    }

    std::uint32_t bits(const char *what)
    {
        if (m_bytes.size() - m_at < 4)
            failTruncated(what);
        m_at += 4;
        return base::numberAt<std::uint32_t>(m_bytes.data() + m_at - 4, m_byteOrder);
    }

    /// Moves to the first word outside comments, or to the end.
    void skipComments()
    {
        m_scanner.skipBlankLines();
        for (TextScanner ahead = m_scanner; ahead.nextWordInLine().starts_with('#'); ahead = m_scanner) {
            m_scanner.skipLine();
            m_scanner.skipBlankLines();
        }
    }

    /// The next word; empty at the end of the line and before a comment.
    std::string_view nextWordInLine()
    {
        const TextScanner before = m_scanner;
        const std::string_view word = m_scanner.nextWordInLine();
        if (!word.starts_with('#'))
            return word;
        m_scanner = before;
        return {};
    }

    std::string_view wordInLine(const char *what)
    {
        std::string_view word = nextWordInLine();
        if (!word.empty())
            return word;
        if (m_brokenLine == 0) {
            m_brokenLine = m_scanner.line();
            m_brokenIn = what;
        }
        skipComments();
        word = nextWordInLine();
        if (word.empty())
            failBroken();
        return word;
    }

    [[noreturn]] void failBroken() const
    {
        failMalformed(tr("line %1: the line ends where a %2 is expected", m_brokenLine, tr(m_brokenIn)));
    }
    [[noreturn]] void failTruncated(const char *what) const
    {
        failMalformed(tr("the file ends where a %1 is expected", tr(what)));
    }
    [[noreturn]] void failWord(std::string_view word, const char *what) const
    {
        failMalformed(tr("line %1: %2 found where a %3 is expected", m_scanner.line(), quoted(word), tr(what)));
    }

    std::span<const std::uint8_t> m_bytes;
    std::size_t m_at;
    TextScanner m_scanner;
    bool m_isBinary;
    bool m_hasFaceColors = true;
    std::endian m_byteOrder;
    bool m_areIntegers = false;
    std::size_t m_brokenLine = 0; ///< line on which a vertex or face continues, or 0
    const char *m_brokenIn = "";  ///< what was expected there
};

/// @param mostOfAll  255 or 1
glm::u8vec4 colorFromNumbers(std::span<const float> values, float mostOfAll)
{
    glm::u8vec4 color(255);
    for (std::size_t c = 0; c < values.size(); ++c) {
        const float value = values[c] * (255.0f / mostOfAll);
        // NaN becomes 0.
        color[static_cast<int>(c)] =
            value > 0.0f ? static_cast<std::uint8_t>(std::lround(std::min(value, 255.0f))) : std::uint8_t{0};
    }
    return color;
}

/// The colours of vertices: in [0, 1], or in [0, 255] if any number exceeds 1.
class VertexColors {
public:
    /// @param values  3 or 4; any other number is no colour
    /// @return whether they are a colour
    bool add(std::span<const float> values)
    {
        std::array<float, 4> &color = m_colors.emplace_back(std::array{1.0f, 1.0f, 1.0f, kNoOpacity});
        if (values.size() != 3 && values.size() != 4)
            return false;
        std::ranges::copy(values, color.begin());
        for (const float value : values)
            m_most = std::max(m_most, value);
        return true;
    }
    std::vector<glm::u8vec4> take() const
    {
        std::vector<glm::u8vec4> colors;
        colors.reserve(m_colors.size());
        for (const std::array<float, 4> &color : m_colors)
            colors.push_back(colorFromNumbers(std::span(color).first(color[3] == kNoOpacity ? 3 : 4),
                                              m_most > 1.0f ? 255.0f : 1.0f));
        return colors;
    }

private:
    static constexpr float kNoOpacity = -1.0f;
    std::vector<std::array<float, 4>> m_colors;
    float m_most = 0.0f;
};

std::size_t checkedCount(std::int64_t count, std::size_t numbersEach, const OffNumbers &numbers, const char *what)
{
    if (count < 0)
        failMalformed(tr("the header declares %1 %2", count, tr(what)));
    if (static_cast<std::uint64_t>(count) > (numbers.bytesLeft() + 1) / (numbersEach * numbers.leastBytes()))
        failMalformed(tr("the header declares %1 %2, the file is too short for them", count, tr(what)));
    return static_cast<std::size_t>(count);
}

void readVertices(const OffKind &kind, std::size_t count, OffNumbers &numbers, Model &model, Mesh &mesh,
                  base::Reporter &progress)
{
    std::vector<glm::dvec3> positions;
    positions.reserve(count);
    Box box;
    VertexColors colors;
    std::vector<float> rest;
    std::size_t verticesWithMore = 0;
    for (std::size_t v = 0; v < count; ++v) {
        if (v % kElementsBetweenReports == 0)
            progress.report(0.5 * static_cast<double>(v) / static_cast<double>(count));
        numbers.beginLine(marked("vertex|of a mesh"));
        const auto [x, y, z] = numbers.reals<3>(marked("vertex|of a mesh"));
        positions.emplace_back(x, y, z);
        box.add(positions.back());
        if (kind.hasNormals) {
            const auto [nx, ny, nz] = numbers.reals<3>(marked("normal|of a mesh"));
            mesh.normals.emplace_back(nx, ny, nz);
        }
        // In text the colour ends the line, so its opacity may be missing.
        const bool isColorLast = kind.hasColors && !kind.isBinary && !kind.hasTexcoords;
        if (kind.hasColors && !isColorLast) {
            const auto [r, g, b, a] = numbers.reals<4>(marked("vertex colour"));
            colors.add(
                std::array{static_cast<float>(r), static_cast<float>(g), static_cast<float>(b), static_cast<float>(a)});
        }
        if (kind.hasTexcoords) {
            const auto [s, t] = numbers.reals<2>(marked("texture coordinate"));
            mesh.texcoords.emplace_back(s, t);
        }
        if (kind.isBinary)
            continue;
        const bool areNumbers = numbers.restOfLine(rest);
        const bool areUsed = isColorLast ? colors.add(rest) || rest.empty() : rest.empty();
        verticesWithMore += !areNumbers || !areUsed ? 1U : 0U;
    }
    setPositions(mesh, originFor(box), positions);
    if (kind.hasColors)
        mesh.colors = colors.take();
    noteVerticesWithMore(model.notes, verticesWithMore);
}

/// The byte order of the counts. Some programs write the binary form in little endian; in the wrong
/// order the counts are far too large.
std::endian byteOrderOf(const Source &source, std::size_t offset)
{
    const std::span<const std::uint8_t> bytes = source.bytes.subspan(offset);
    if (bytes.size() < 4)
        return std::endian::big;
    const auto big = base::numberAt<std::uint32_t>(bytes.data(), std::endian::big);
    const auto little = base::numberAt<std::uint32_t>(bytes.data());
    constexpr std::size_t kVertexBytes = 12;
    return big > bytes.size() / kVertexBytes && little <= bytes.size() / kVertexBytes ? std::endian::little
                                                                                      : std::endian::big;
}

/// Returns whether the bytes after the first line are text: as the counts of a binary file, each
/// would exceed 500 million.
bool isText(std::string_view start)
{
    constexpr std::size_t kBytesOfCounts = 12;
    const std::string_view counts = start.substr(0, kBytesOfCounts);
    return counts.find_first_not_of(" \t\r\n") != counts.npos && std::all_of(counts.begin(), counts.end(), [](char c) {
               return (c >= ' ' && c <= '~') || c == '\t' || c == '\n' || c == '\r';
           });
}

} // namespace

Model readOff(const Source &source)
{
    TextScanner scanner(source.unpaddedText());
    std::string_view word = scanner.nextWord();
    while (!word.empty() && word.front() == '#') {
        scanner.skipLine();
        word = scanner.nextWord();
    }
    OffKind kind;
    std::size_t offset = 0;
    std::size_t line = 1;
    if (const std::size_t length = readOffWord(word, kind); length > 0) {
        offset = scanner.offset() - word.size() + length;
        line = scanner.line();
        if (TextScanner ahead = scanner; ahead.nextWordInLine() == "BINARY") {
            ahead.skipLine();
            offset = ahead.offset();
            line = ahead.line();
            kind.isBinary = true;
            kind.byteOrder = byteOrderOf(source, offset);
            if (isText(source.text().substr(offset)))
                failMalformed(tr("the first line says BINARY and text follows; remove the word BINARY"));
        }
    }

    OffNumbers numbers(source, offset, line, kind);
    numbers.beginLine(marked("number of vertices"));
    const std::int64_t declaredVertices = numbers.integer(marked("number of vertices"));
    numbers.beginLine(marked("number of faces"));
    const std::int64_t declaredFaces = numbers.integer(marked("number of faces"));
    numbers.skipEdges();
    const std::size_t vertexCount = checkedCount(declaredVertices, 3, numbers, marked("vertices|of a mesh"));
    const std::size_t faceCount = checkedCount(declaredFaces, 1, numbers, marked("faces|of a mesh"));

    Model model;
    PolygonMesh polygons(vertexCount);
    readVertices(kind, vertexCount, numbers, model, polygons.mesh, source.progress);
    numbers.findFaceColors(faceCount);
    std::vector<std::int64_t> corners;
    for (std::size_t f = 0; f < faceCount; ++f) {
        if (f % kElementsBetweenReports == 0)
            source.progress.report(0.5 + 0.5 * static_cast<double>(f) / static_cast<double>(faceCount));
        numbers.beginLine(marked("face|of a mesh"));
        const std::int64_t count = numbers.integer(marked("face|of a mesh"));
        if (count < 0 || static_cast<std::uint64_t>(count) > (numbers.bytesLeft() + 1) / numbers.leastBytes())
            failMalformed(tr("face %1 declares %2 corners, which the file does not have", f, count));
        corners.resize(static_cast<std::size_t>(count));
        for (std::int64_t &corner : corners)
            corner = numbers.integer(marked("face|of a mesh"));
        polygons.checkPolygon(corners, f);
        polygons.addPolygon(corners);
        const std::vector<float> color = numbers.faceColor();
        // A single number is an index into a table outside the file.
        if (color.size() >= 3 && polygons.mesh.colors.empty())
            polygons.setFaceColor(colorFromNumbers(color, numbers.areIntegers() ? 255.0f : 1.0f));
    }

    noteBytesBehind(model.notes, numbers.end());
    noteLines(model.notes, polygons.lineCount());
    model.fileVertices = vertexCount;
    model.meshes.push_back(polygons.take());
    if (!model.meshes.back().colors.empty())
        model.meshes.back().baseColor = glm::vec4(1.0f);
    return model;
}

} // namespace unprojector::mesh::reader
