#include "core/mesh_import/mesh_reader.h"
#include "core/mesh_import/polygon_mesh.h"
#include "core/mesh_import/text_scanner.h"
#include "core/text/translation.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <optional>

namespace unprojector::mesh_import::mesh_reader {
using namespace geometry;
using text::marked;
using text::tr;

namespace {

constexpr std::size_t kElementsBetweenReports = 1 << 14;

/// What stands before "OFF" in the first word: [ST][C][N][4][n]OFF.
struct OffKind {
    bool hasTexcoords = false;
    bool hasColors = false;
    bool hasNormals = false;
    bool hasW = false;
    bool isBinary = false;
};

std::optional<OffKind> kindFromWord(std::string_view word)
{
    OffKind kind;
    const auto take = [&word](std::string_view prefix) {
        const bool found = word.starts_with(prefix);
        word.remove_prefix(found ? prefix.size() : 0);
        return found;
    };
    kind.hasTexcoords = take("ST");
    kind.hasColors = take("C");
    kind.hasNormals = take("N");
    kind.hasW = take("4");
    if (word != "OFF")
        return std::nullopt;
    return kind;
}

/// The file's numbers, as words or as big-endian binary.
class OffNumbers {
public:
    OffNumbers(const Source &source, std::size_t offset, std::size_t line, bool isBinary)
        : m_bytes(source.bytes), m_at(offset), m_scanner(source.text(), offset, line), m_isBinary(isBinary)
    {
    }

    std::size_t offset() const { return m_isBinary ? m_at : m_scanner.offset(); }
    std::size_t bytesLeft() const { return m_bytes.size() - offset(); }
    std::size_t leastBytes() const { return m_isBinary ? 4 : 2; }

    std::int64_t integer(const char *what)
    {
        if (m_isBinary)
            return static_cast<std::int32_t>(bits(what));
        const std::string_view word = nextWord(what);
        const std::optional<long long> value = integerFromWord(word);
        if (!value)
            failWord(word, what);
        return *value;
    }

    double real(const char *what)
    {
        if (m_isBinary)
            return static_cast<double>(std::bit_cast<float>(bits(what)));
        const std::string_view word = nextWord(what);
        const std::optional<double> value = doubleFromWord(word);
        if (!value)
            failWord(word, what);
        return *value;
    }

    /// The numbers behind a face: up to four in the rest of the line, or as many as the binary count says. A word
    /// that is no number, and all after it, is left out.
    std::vector<float> faceColor()
    {
        std::vector<float> values;
        if (m_isBinary) {
            const std::int64_t count = integer(marked("face colour"));
            for (std::int64_t i = 0; i < count; ++i) {
                const auto value = static_cast<float>(real(marked("face colour")));
                if (values.size() < 4)
                    values.push_back(value);
            }
            return values;
        }
        m_areColorsIntegers = true;
        while (values.size() < 4) {
            const std::string_view word = m_scanner.nextWordInLine();
            const std::optional<float> value = word.empty() || word.front() == '#' ? std::nullopt : floatFromWord(word);
            if (!value)
                break;
            m_areColorsIntegers = m_areColorsIntegers && integerFromWord(word).has_value();
            values.push_back(*value);
        }
        m_scanner.skipLine();
        return values;
    }

    /// Vertex colours: four numbers in binary, the rest of the line in text.
    std::vector<float> vertexColor(bool isLastInLine)
    {
        if (!m_isBinary && isLastInLine)
            return faceColor();
        std::vector<float> values(4);
        for (float &value : values)
            value = static_cast<float>(real(marked("vertex colour")));
        m_areColorsIntegers = false;
        for (const float value : values)
            m_areColorsIntegers = m_areColorsIntegers || value > 1.0f;
        return values;
    }

    bool areColorsIntegers() const { return m_areColorsIntegers; }

    /// After the last face. In text only comments may follow.
    /// @return the bytes that follow in a binary file, 0 where they are blank
    std::size_t end()
    {
        if (m_isBinary)
            return bytesThatMean(m_bytes.subspan(m_at));
        std::string_view word = m_scanner.nextWord();
        while (!word.empty() && word.front() == '#') {
            m_scanner.skipLine();
            word = m_scanner.nextWord();
        }
        if (!word.empty())
            failMalformed(
                tr("line %1: %2 follows all that the header declares; correct its numbers of vertices and faces",
                   m_scanner.line(), quoted(word)));
        return 0;
    }

private:
    std::uint32_t bits(const char *what)
    {
        if (m_bytes.size() - m_at < 4)
            failTruncated(what);
        const std::uint8_t *b = m_bytes.data() + m_at;
        m_at += 4;
        return std::uint32_t{b[0]} << 24 | std::uint32_t{b[1]} << 16 | std::uint32_t{b[2]} << 8 | std::uint32_t{b[3]};
    }

    std::string_view nextWord(const char *what)
    {
        for (;;) {
            const std::string_view word = m_scanner.nextWord();
            if (word.empty())
                failTruncated(what);
            if (word.front() != '#')
                return word;
            m_scanner.skipLine();
        }
    }

    [[noreturn]] void failTruncated(const char *what) const
    {
        failMalformed(tr("the file ends where a %1 is expected", tr(what)));
    }
    [[noreturn]] void failWord(std::string_view word, const char *what) const
    {
        failMalformed(tr("line %1: %2 stands where a %3 is expected", m_scanner.line(), quoted(word), tr(what)));
    }

    std::span<const std::uint8_t> m_bytes;
    std::size_t m_at;
    TextScanner m_scanner;
    bool m_isBinary;
    bool m_areColorsIntegers = false;
};

glm::u8vec4 colorFromNumbers(const std::vector<float> &values, bool areIntegers)
{
    glm::u8vec4 color(255);
    for (std::size_t c = 0; c < values.size(); ++c) {
        const float value = areIntegers ? values[c] : values[c] * 255.0f;
        // Written so that NaN becomes 0.
        color[static_cast<int>(c)] =
            value > 0.0f ? static_cast<std::uint8_t>(std::lround(std::min(value, 255.0f))) : std::uint8_t{0};
    }
    return color;
}

std::size_t checkedCount(std::int64_t count, std::size_t numbersEach, const OffNumbers &numbers, const char *what)
{
    if (count < 0)
        failMalformed(tr("the header declares %1 %2", count, tr(what)));
    if (static_cast<std::uint64_t>(count) > (numbers.bytesLeft() + 1) / (numbersEach * numbers.leastBytes()))
        failMalformed(tr("the header declares %1 %2, the file is too short for them", count, tr(what)));
    return static_cast<std::size_t>(count);
}

void readVertices(const OffKind &kind, std::size_t count, OffNumbers &numbers, Mesh &mesh, ProgressReporter &progress)
{
    std::vector<glm::dvec3> positions;
    positions.reserve(count);
    Box box;
    for (std::size_t v = 0; v < count; ++v) {
        if (v % kElementsBetweenReports == 0)
            progress.report(0.5 * static_cast<double>(v) / static_cast<double>(count));
        const double x = numbers.real(marked("vertex|of a mesh"));
        const double y = numbers.real(marked("vertex|of a mesh"));
        const double z = numbers.real(marked("vertex|of a mesh"));
        const double w = kind.hasW ? numbers.real(marked("vertex|of a mesh")) : 1.0;
        positions.push_back(glm::dvec3(x, y, z) / w);
        box.add(positions.back());
        if (kind.hasNormals) {
            const double nx = numbers.real(marked("normal|of a mesh"));
            const double ny = numbers.real(marked("normal|of a mesh"));
            mesh.normals.emplace_back(nx, ny, numbers.real(marked("normal|of a mesh")));
        }
        if (kind.hasColors) {
            const std::vector<float> values = numbers.vertexColor(!kind.hasTexcoords);
            mesh.colors.push_back(colorFromNumbers(values, numbers.areColorsIntegers()));
        }
        if (kind.hasTexcoords) {
            const double u = numbers.real(marked("texture coordinate"));
            mesh.texcoords.emplace_back(u, numbers.real(marked("texture coordinate")));
        }
    }
    setPositions(mesh, originFor(box), positions);
}

} // namespace

Model readOff(const Source &source)
{
    TextScanner scanner(source.text());
    std::string_view word = scanner.nextWord();
    while (!word.empty() && word.front() == '#') {
        scanner.skipLine();
        word = scanner.nextWord();
    }
    std::optional<OffKind> kind = kindFromWord(word);
    std::size_t offset = scanner.offset();
    if (!kind) {
        // The word is optional: the file may begin with the counts.
        if (!integerFromWord(word))
            failMalformed(tr("the file does not begin with \"OFF\""));
        kind = OffKind{};
        offset = 0;
    }
    std::size_t line = scanner.line();
    if (TextScanner ahead = scanner; offset > 0 && ahead.nextWordInLine() == "BINARY") {
        kind->isBinary = true;
        ahead.skipLine();
        offset = ahead.offset();
        line = ahead.line();
    }
    if (offset == 0)
        line = 1;

    OffNumbers numbers(source, offset, line, kind->isBinary);
    const std::int64_t declaredVertices = numbers.integer(marked("number of vertices"));
    const std::int64_t declaredFaces = numbers.integer(marked("number of faces"));
    numbers.integer(marked("number of edges"));
    const std::size_t vertexCount = checkedCount(declaredVertices, 3, numbers, marked("vertices|of a mesh"));
    const std::size_t faceCount = checkedCount(declaredFaces, 1, numbers, marked("faces|of a mesh"));

    PolygonMesh polygons(vertexCount);
    readVertices(*kind, vertexCount, numbers, polygons.mesh, source.progress);
    std::vector<std::int64_t> corners;
    for (std::size_t f = 0; f < faceCount; ++f) {
        if (f % kElementsBetweenReports == 0)
            source.progress.report(0.5 + 0.5 * static_cast<double>(f) / static_cast<double>(faceCount));
        corners.resize(
            checkedCount(numbers.integer(marked("face|of a mesh")), 1, numbers, marked("corners of a face")));
        for (std::int64_t &corner : corners)
            corner = numbers.integer(marked("face|of a mesh"));
        polygons.addPolygon(corners, f);
        const std::vector<float> color = numbers.faceColor();
        // One number is an index into a table that the file does not hold.
        if (color.size() >= 3 && polygons.mesh.colors.empty())
            polygons.setFaceColor(colorFromNumbers(color, numbers.areColorsIntegers()));
    }

    Model model;
    if (const std::size_t more = numbers.end(); more > 0)
        model.notes.push_back({ModelNote::Kind::BytesLeftOut, more, {}});
    if (polygons.lineCount() > 0)
        model.notes.push_back({ModelNote::Kind::LinesLeftOut, polygons.lineCount(), {}});
    model.meshes.push_back(polygons.take());
    if (!model.meshes.back().colors.empty())
        model.meshes.back().baseColor = glm::vec4(1.0f);
    return model;
}

} // namespace unprojector::mesh_import::mesh_reader
