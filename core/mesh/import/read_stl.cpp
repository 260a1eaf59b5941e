#include "core/base/byte_order.h"
#include "core/base/parallel.h"
#include "core/base/text_scanner.h"
#include "core/base/translation.h"
#include "core/geometry/finite.h"
#include "core/mesh/import/line_ranges.h"
#include "core/mesh/import/mesh_normals.h"
#include "core/mesh/import/mesh_reader.h"
#include "core/mesh/soup_numbers.h"

#include <glm/common.hpp>

#include <algorithm>
#include <bit>
#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <mutex>
#include <optional>

namespace unprojector::mesh::reader {
using namespace base;
using namespace geometry;

namespace {

constexpr std::size_t kHeaderBytes = 80;
constexpr std::size_t kBytesBeforeTriangles = kHeaderBytes + 4;
constexpr std::size_t kTriangleBytes = 50;
constexpr std::size_t kTrianglesBetweenReports = 1 << 15;
/// A few milliseconds of work.
constexpr std::size_t kTrianglesInTask = 1 << 17;
constexpr std::size_t kAsciiBytesInTask = 1 << 20;
constexpr std::uint16_t kColorBit = 0x8000;

glm::vec3 vectorAt(const std::uint8_t *bytes)
{
    return {numberAt<float>(bytes), numberAt<float>(bytes + 4), numberAt<float>(bytes + 8)};
}

/// The limit for merging equal corners. More triangles stay without neighbours and are drawn flat:
/// merging would take longer than everything else.
constexpr std::size_t kMostTrianglesToWeld = 300000;

glm::u8vec4 colorFromBits(std::uint16_t bits, bool isMagics)
{
    const auto channel = [bits](int shift) { return static_cast<std::uint8_t>(((bits >> shift) & 31) * 255 / 31); };
    // Materialise Magics stores red in the low bits, VisCAM and SolidView store blue there.
    return isMagics ? glm::u8vec4(channel(0), channel(5), channel(10), 255)
                    : glm::u8vec4(channel(10), channel(5), channel(0), 255);
}

/// The triangles of a binary file, read in place.
class StlRecords {
public:
    explicit StlRecords(const Source &source) : m_source(source)
    {
        m_count = numberAt<std::uint32_t>(source.bytes.data() + kHeaderBytes);
        const std::size_t present = (source.bytes.size() - kBytesBeforeTriangles) / kTriangleBytes;
        if (m_count > present)
            failMalformed(tr("the header declares %1 triangles, the file ends after %2", m_count, present));
        m_bytesBehind = bytesThatMean(source.bytes.subspan(kBytesBeforeTriangles + m_count * kTriangleBytes));
        if (m_bytesBehind >= kTriangleBytes)
            failMalformed(tr("the header declares %1 triangles, the file is long enough for %2; correct the number in "
                             "bytes 80 to 83 of the file",
                             m_count, present));
    }

    std::size_t count() const { return m_count; }
    /// The number of bytes after the triangles.
    std::size_t bytesBehind() const { return m_bytesBehind; }
    glm::vec3 corner(std::size_t triangle, std::size_t corner) const
    {
        return vectorAt(record(triangle) + 12 + 12 * corner);
    }
    std::uint16_t attribute(std::size_t triangle) const { return numberAt<std::uint16_t>(record(triangle) + 48); }
    /// Materialise Magics' colour of the whole object.
    std::optional<glm::u8vec4> magicsColor() const
    {
        const std::string_view header = m_source.text().substr(0, kHeaderBytes);
        const std::size_t at = header.find("COLOR=");
        if (at == header.npos || at + 10 > header.size())
            return std::nullopt;
        const std::uint8_t *rgba = m_source.bytes.data() + at + 6;
        return glm::u8vec4(rgba[0], rgba[1], rgba[2], 255);
    }

private:
    const std::uint8_t *record(std::size_t triangle) const
    {
        return m_source.bytes.data() + kBytesBeforeTriangles + triangle * kTriangleBytes;
    }

    const Source &m_source;
    std::size_t m_count = 0;
    std::size_t m_bytesBehind = 0;
};

/// The colours of the corners, three a triangle; none if no triangle has a colour.
std::vector<glm::u8vec4> cornerColors(const StlRecords &records, bool hasColorBits)
{
    const std::optional<glm::u8vec4> ofObject = records.magicsColor();
    std::vector<glm::u8vec4> colors;
    if (!ofObject && !hasColorBits)
        return colors;
    colors.reserve(3 * records.count());
    for (std::size_t t = 0; t < records.count(); ++t) {
        const std::uint16_t bits = records.attribute(t);
        // The bit means in Magics that the whole object's colour applies; in other programs, that
        // the triangle's does.
        const bool hasOwnColor = ((bits & kColorBit) != 0) != ofObject.has_value();
        colors.insert(colors.end(), 3,
                      hasOwnColor ? colorFromBits(bits, ofObject.has_value())
                                  : ofObject.value_or(glm::u8vec4(204, 204, 204, 255)));
    }
    return colors;
}

Mesh readBinary(const Source &source, std::vector<base::Note> &notes)
{
    const StlRecords records(source);
    noteBytesBehind(notes, records.bytesBehind());
    Box box;
    bool hasColorBits = false;
    std::mutex mutex;
    inParallelRanges(records.count(), kTrianglesInTask, source.progress.part(0.0, 0.4),
                     [&](std::size_t begin, std::size_t end) {
                         constexpr float kMost = std::numeric_limits<float>::max();
                         glm::vec3 lowest(kMost), highest(-kMost);
                         std::uint16_t bits = 0;
                         for (std::size_t t = begin; t < end; ++t) {
                             for (std::size_t c = 0; c < 3; ++c) {
                                 const glm::vec3 position = records.corner(t, c);
                                 lowest = glm::min(lowest, position);
                                 highest = glm::max(highest, position);
                                 if (!std::isfinite(position.x + position.y + position.z) && !isFinite(position))
                                     failNotFinite(3 * t + c);
                             }
                             bits |= records.attribute(t);
                         }
                         const std::lock_guard lock(mutex);
                         box.add(glm::dvec3(lowest));
                         box.add(glm::dvec3(highest));
                         hasColorBits = hasColorBits || (bits & kColorBit) != 0;
                     });

    Mesh mesh;
    mesh.origin = originFor(box);
    fillInParallel(
        mesh.positions, 3 * records.count(), source.progress.part(0.4, 0.8), [&](std::size_t begin, std::size_t end) {
            for (std::size_t corner = begin; corner < end; ++corner)
                mesh.positions[corner] = glm::vec3(glm::dvec3(records.corner(corner / 3, corner % 3)) - mesh.origin);
        });
    mesh.colors = cornerColors(records, hasColorBits);
    if (!mesh.colors.empty())
        mesh.baseColor = glm::vec4(1.0f);
    return mesh;
}

bool equalsIgnoringCase(std::string_view word, std::string_view lowerCase)
{
    return word.size() == lowerCase.size()
           && std::equal(word.begin(), word.end(), lowerCase.begin(),
                         [](char a, char b) { return a == b || (a >= 'A' && a <= 'Z' && a - 'A' + 'a' == b); });
}

[[noreturn]] void failUnended(std::size_t line)
{
    failMalformed(tr("the file ends in line %1 without \"endsolid\"", line));
}

/// The contents of a text, or of some whole facets of it.
struct AsciiPart {
    std::vector<glm::dvec3> positions;
    Box box;
    std::optional<bool> isInSolid; ///< the state at its end; nothing: unchanged from its beginning
};

/// @param report  called with the position in the text; may be empty
AsciiPart readAscii(TextScanner scanner, std::size_t bytes, const std::function<void(std::size_t)> &report)
{
    AsciiPart part;
    // A facet takes about 250 bytes in the output of most programs.
    part.positions.reserve(bytes / 80);
    std::size_t cornersOfFacet = 0;
    std::size_t words = 0;
    for (std::string_view word = scanner.nextWord(); !word.empty(); word = scanner.nextWord()) {
        if (++words % (kTrianglesBetweenReports * 4) == 0 && report)
            report(scanner.offset());
        if (equalsIgnoringCase(word, "vertex")) {
            glm::dvec3 position;
            for (int axis = 0; axis < 3; ++axis) {
                const std::string_view number = scanner.nextWordInLine();
                const std::optional<double> value = doubleFromWord(number);
                if (!value)
                    failAtLine(scanner.line(), number.empty()
                                                   ? tr("a vertex needs three numbers")
                                                   : tr("a vertex needs three numbers, not %1", quoted(number)));
                position[axis] = *value;
            }
            if (!isFinite(position))
                failNotFinite(part.positions.size());
            part.positions.push_back(position);
            part.box.add(position);
            ++cornersOfFacet;
        } else if (equalsIgnoringCase(word, "endfacet")) {
            if (cornersOfFacet != 3)
                failAtLine(scanner.line(), tr("a facet has %1 vertices instead of 3", cornersOfFacet));
            cornersOfFacet = 0;
        } else if (equalsIgnoringCase(word, "solid")) {
            part.isInSolid = true;
            scanner.skipLine();
        } else if (equalsIgnoringCase(word, "endsolid")) {
            part.isInSolid = false;
            scanner.skipLine();
        } else if (equalsIgnoringCase(word, "normal")) {
            // The numbers are unused, and some programs write "nan" for a thin triangle.
            for (int axis = 0; axis < 3; ++axis)
                scanner.nextWordInLine();
        } else if (word.starts_with('#')) {
            scanner.skipLine();
        } else if (!equalsIgnoringCase(word, "facet") && !equalsIgnoringCase(word, "outer")
                   && !equalsIgnoringCase(word, "loop") && !equalsIgnoringCase(word, "endloop")) {
            failAtLine(scanner.line(), tr("%1 does not belong in an STL file", quoted(word)));
        }
    }
    if (cornersOfFacet != 0)
        failUnended(scanner.line());
    return part;
}

/// The start of the next line whose first word is "facet"; the end of the text if there is none.
std::size_t nextFacet(std::string_view text, std::size_t from)
{
    for (std::size_t at = from; at < text.size();) {
        at = std::min(text.find_first_of("\n\r", at), text.size());
        const std::size_t word = std::min(text.find_first_not_of(" \t\r\n", at), text.size());
        if (equalsIgnoringCase(text.substr(word, 5), "facet"))
            return word;
        at = std::max(word, at + 1);
    }
    return text.size();
}

/// Reads a text on all cores. Nothing for a short text or on an error: sequential reading then
/// reports it.
std::optional<AsciiPart> readAsciiParts(const Source &source)
{
    const std::string_view text = source.unpaddedText();
    std::vector<std::size_t> starts{0};
    while (starts.back() < text.size())
        starts.push_back(nextFacet(text, std::min(text.size(), starts.back() + kAsciiBytesInTask)));
    const std::size_t count = starts.size() - 1;
    if (count < 2)
        return std::nullopt;
    std::vector<AsciiPart> parts(count);
    try {
        inParallel(count, source.progress.part(), [&](std::size_t i) {
            const std::string_view own = text.substr(starts[i], starts[i + 1] - starts[i]);
            parts[i] = readAscii(TextScanner(own), own.size(), {});
        });
    } catch (const base::Error &) {
        return std::nullopt;
    }
    AsciiPart whole = std::move(parts.front());
    std::size_t size = 0;
    for (const AsciiPart &part : parts)
        size += part.positions.size();
    whole.positions.reserve(whole.positions.size() + size);
    for (std::size_t i = 1; i < count; ++i) {
        whole.positions.insert(whole.positions.end(), parts[i].positions.begin(), parts[i].positions.end());
        whole.box.add(parts[i].box);
        whole.isInSolid = parts[i].isInSolid ? parts[i].isInSolid : whole.isInSolid;
        parts[i] = {};
    }
    return whole;
}

Mesh readAscii(const Source &source)
{
    std::optional<AsciiPart> whole = readAsciiParts(source);
    if (!whole) {
        const auto report = [&source](std::size_t offset) {
            source.progress.report(static_cast<double>(offset) / static_cast<double>(source.bytes.size()));
        };
        whole = readAscii(TextScanner(source.unpaddedText()), source.bytes.size(), report);
    }
    if (whole->isInSolid.value_or(false)) {
        const std::string_view text = source.text();
        LineRange all;
        all.end = text.size();
        countLines(text, all);
        failUnended(all.lines + 1);
    }
    Mesh mesh;
    setPositions(mesh, originFor(whole->box), whole->positions);
    return mesh;
}

/// Returns whether the file is text: by the size, which a binary file's count determines, else by
/// the contents. A binary header may begin with "solid", and a text with a comment.
bool isAscii(const Source &source)
{
    if (source.bytes.size() >= kBytesBeforeTriangles) {
        const std::size_t declared = numberAt<std::uint32_t>(source.bytes.data() + kHeaderBytes);
        if (source.bytes.size() == kBytesBeforeTriangles + declared * kTriangleBytes)
            return false;
    }
    constexpr std::size_t kLookedAt = 1 << 16;
    const std::string_view start = source.unpaddedText().substr(0, kLookedAt);
    const bool hasControls = std::any_of(start.begin(), start.end(), [](char c) {
        return (c >= 0 && c < ' ' && c != '\t' && c != '\n' && c != '\v' && c != '\f' && c != '\r');
    });
    TextScanner scanner(start);
    const std::string_view first = scanner.nextWord();
    if (hasControls) {
        // The keywords decide for text; the message then names the line.
        scanner.skipLine();
        return equalsIgnoringCase(first, "solid") && equalsIgnoringCase(scanner.nextWord(), "facet");
    }
    for (TextScanner words(start); !words.isAtEnd();) {
        const std::string_view word = words.nextWord();
        if (equalsIgnoringCase(word, "facet") || equalsIgnoringCase(word, "endsolid"))
            return true;
    }
    return equalsIgnoringCase(first, "solid");
}

} // namespace

Model readStl(const Source &source)
{
    Model model;
    Mesh mesh;
    if (isAscii(source)) {
        mesh = readAscii(source);
    } else {
        if (source.bytes.size() < kBytesBeforeTriangles)
            failMalformed(tr("the file ends within the header"));
        mesh = readBinary(source, model.notes);
    }
    // The facets' normals are ignored: the corners determine them. STL repeats each vertex in every
    // triangle around it.
    if (mesh.triangleCount() <= kMostTrianglesToWeld) {
        // A vertex between two colours is two here, but one in the file.
        if (!mesh.colors.empty())
            model.fileVertices = numberPlaces(mesh, mesh.vertexNumbers);
        mergeEqualVertices(mesh);
    } else {
        model.soupNumbers = std::make_shared<SoupNumbers>();
    }
    model.meshes.push_back(std::move(mesh));
    return model;
}

} // namespace unprojector::mesh::reader
