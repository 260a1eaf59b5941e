#include "core/geometry/finite.h"
#include "core/mesh_import/mesh_normals.h"
#include "core/mesh_import/mesh_reader.h"
#include "core/mesh_import/text_scanner.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <optional>

namespace unprojector::mesh_import::mesh_reader {

namespace {

constexpr std::size_t kHeaderBytes = 80;
constexpr std::size_t kBytesBeforeTriangles = kHeaderBytes + 4;
constexpr std::size_t kTriangleBytes = 50;
constexpr std::size_t kTrianglesBetweenReports = 1 << 15;
constexpr std::uint16_t kColorBit = 0x8000;

std::uint32_t littleEndian32(const std::uint8_t *bytes)
{
    return std::uint32_t{bytes[0]} | std::uint32_t{bytes[1]} << 8 | std::uint32_t{bytes[2]} << 16
           | std::uint32_t{bytes[3]} << 24;
}

glm::vec3 vectorAt(const std::uint8_t *bytes)
{
    return {std::bit_cast<float>(littleEndian32(bytes)), std::bit_cast<float>(littleEndian32(bytes + 4)),
            std::bit_cast<float>(littleEndian32(bytes + 8))};
}

/// STL repeats each vertex in every triangle around it: equal positions become one vertex. The facet normals are
/// left out, they say nothing that the corners don't.
class StlMesh {
public:
    explicit StlMesh(std::size_t expectedTriangles) : m_positions(expectedTriangles / 2)
    {
        m_mesh.indices.reserve(3 * expectedTriangles);
    }
    void add(const glm::vec3 &position)
    {
        if (!isFinite(position))
            throw Failure(ImportErrorCode::NotFinite, {}, m_mesh.indices.size());
        m_mesh.indices.push_back(m_positions.add(position));
    }
    std::size_t cornerCount() const { return m_mesh.indices.size(); }
    Mesh take()
    {
        m_mesh.positions = m_positions.takePositions();
        return std::move(m_mesh);
    }

private:
    PositionIndex m_positions;
    Mesh m_mesh;
};

glm::u8vec4 colorFromBits(std::uint16_t bits, bool isMagics)
{
    const auto channel = [bits](int shift) { return static_cast<std::uint8_t>(((bits >> shift) & 31) * 255 / 31); };
    // Materialise Magics stores red in the low bits, VisCAM and SolidView store blue there.
    return isMagics ? glm::u8vec4(channel(0), channel(5), channel(10), 255)
                    : glm::u8vec4(channel(10), channel(5), channel(0), 255);
}

/// Gives each triangle its colour: a vertex with several colours around it is split.
void colorTriangles(Mesh &mesh, const Source &source, const std::optional<glm::u8vec4> &magicsDefault)
{
    Mesh colored;
    for (std::size_t corner = 0; corner < mesh.indices.size(); ++corner) {
        const std::uint8_t *triangle = source.bytes.data() + kBytesBeforeTriangles + corner / 3 * kTriangleBytes;
        const auto bits = static_cast<std::uint16_t>(triangle[48] | triangle[49] << 8);
        // Magics sets the bit where the whole object's colour applies, the others where the triangle's does.
        const bool hasOwnColor = ((bits & kColorBit) != 0) != magicsDefault.has_value();
        colored.positions.push_back(mesh.positions[mesh.indices[corner]]);
        colored.colors.push_back(hasOwnColor ? colorFromBits(bits, magicsDefault.has_value())
                                             : magicsDefault.value_or(glm::u8vec4(204, 204, 204, 255)));
        colored.indices.push_back(static_cast<std::uint32_t>(corner));
    }
    colored.baseColor = glm::vec4(1.0f);
    mesh = std::move(colored);
    mergeEqualVertices(mesh);
}

Mesh readBinary(const Source &source)
{
    const std::size_t declared = littleEndian32(source.bytes.data() + kHeaderBytes);
    const std::size_t present = (source.bytes.size() - kBytesBeforeTriangles) / kTriangleBytes;
    if (declared > present)
        failMalformed("the header declares " + std::to_string(declared) + " triangles, the file ends after "
                      + std::to_string(present));

    StlMesh stl(declared);
    bool hasColorBits = false;
    for (std::size_t t = 0; t < declared; ++t) {
        if (t % kTrianglesBetweenReports == 0)
            source.progress.report(static_cast<double>(t) / static_cast<double>(declared));
        const std::uint8_t *triangle = source.bytes.data() + kBytesBeforeTriangles + t * kTriangleBytes;
        for (std::size_t corner = 0; corner < 3; ++corner)
            stl.add(vectorAt(triangle + 12 + 12 * corner));
        hasColorBits = hasColorBits || (triangle[49] & 0x80) != 0;
    }

    Mesh mesh = stl.take();
    const std::string_view header = source.text().substr(0, kHeaderBytes);
    const std::size_t colorAt = header.find("COLOR=");
    if (colorAt != header.npos && colorAt + 10 <= header.size()) {
        const std::uint8_t *rgba = source.bytes.data() + colorAt + 6;
        colorTriangles(mesh, source, glm::u8vec4(rgba[0], rgba[1], rgba[2], 255));
    } else if (hasColorBits) {
        colorTriangles(mesh, source, std::nullopt);
    }
    return mesh;
}

bool equalsIgnoringCase(std::string_view word, std::string_view lowerCase)
{
    return word.size() == lowerCase.size()
           && std::equal(word.begin(), word.end(), lowerCase.begin(),
                         [](char a, char b) { return a == b || (a >= 'A' && a <= 'Z' && a - 'A' + 'a' == b); });
}

[[noreturn]] void failAtLine(std::size_t line, const std::string &what)
{
    failMalformed("line " + std::to_string(line) + ": " + what);
}

Mesh readAscii(const Source &source)
{
    // A facet takes about 250 bytes as most programs write it.
    StlMesh stl(source.bytes.size() / 250);
    TextScanner scanner(source.text());
    bool isInSolid = false;
    std::size_t cornersOfFacet = 0;
    std::size_t words = 0;
    for (std::string_view word = scanner.nextWord(); !word.empty(); word = scanner.nextWord()) {
        if (++words % (kTrianglesBetweenReports * 4) == 0)
            source.progress.report(static_cast<double>(scanner.offset()) / static_cast<double>(source.bytes.size()));
        if (equalsIgnoringCase(word, "vertex")) {
            glm::vec3 position;
            for (int axis = 0; axis < 3; ++axis) {
                const std::string_view number = scanner.nextWordInLine();
                const std::optional<float> value = floatFromWord(number);
                if (!value)
                    failAtLine(scanner.line(), number.empty() ? "a vertex needs three numbers"
                                                              : "a vertex needs three numbers, not " + quoted(number));
                position[axis] = *value;
            }
            stl.add(position);
            ++cornersOfFacet;
        } else if (equalsIgnoringCase(word, "endfacet")) {
            if (cornersOfFacet != 3)
                failAtLine(scanner.line(), "a facet has " + std::to_string(cornersOfFacet) + " vertices instead of 3");
            cornersOfFacet = 0;
        } else if (equalsIgnoringCase(word, "solid")) {
            isInSolid = true;
            scanner.skipLine();
        } else if (equalsIgnoringCase(word, "endsolid")) {
            isInSolid = false;
            scanner.skipLine();
        } else if (equalsIgnoringCase(word, "normal")) {
            // The numbers are not needed, and some programs write "nan" for a thin triangle.
            for (int axis = 0; axis < 3; ++axis)
                scanner.nextWordInLine();
        } else if (!equalsIgnoringCase(word, "facet") && !equalsIgnoringCase(word, "outer")
                   && !equalsIgnoringCase(word, "loop") && !equalsIgnoringCase(word, "endloop")) {
            failAtLine(scanner.line(), quoted(word) + " does not belong in an STL file");
        }
    }
    if (cornersOfFacet != 0 || isInSolid)
        failMalformed("the file ends in line " + std::to_string(scanner.line()) + " without \"endsolid\"");
    return stl.take();
}

bool isAscii(const Source &source)
{
    TextScanner scanner(source.text().substr(0, std::min<std::size_t>(source.bytes.size(), 4096)));
    if (!equalsIgnoringCase(scanner.nextWord(), "solid"))
        return false;
    // Binary files may begin with "solid" too; then their size fits the count.
    if (source.bytes.size() >= kBytesBeforeTriangles) {
        const std::size_t declared = littleEndian32(source.bytes.data() + kHeaderBytes);
        if (source.bytes.size() == kBytesBeforeTriangles + declared * kTriangleBytes)
            return false;
    }
    scanner.skipLine();
    const std::string_view word = scanner.nextWord();
    return word.empty() || equalsIgnoringCase(word, "facet") || equalsIgnoringCase(word, "endsolid")
           || source.text().substr(0, 4096).find('\0') == std::string_view::npos;
}

} // namespace

Model readStl(const Source &source)
{
    Model model;
    if (isAscii(source)) {
        model.meshes.push_back(readAscii(source));
    } else {
        if (source.bytes.size() < kBytesBeforeTriangles)
            failMalformed("the file ends within the header");
        model.meshes.push_back(readBinary(source));
    }
    return model;
}

} // namespace unprojector::mesh_import::mesh_reader
