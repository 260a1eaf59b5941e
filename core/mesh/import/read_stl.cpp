#include "core/base/byte_order.h"
#include "core/base/parallel.h"
#include "core/base/text_scanner.h"
#include "core/base/translation.h"
#include "core/geometry/finite.h"
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
constexpr std::uint16_t kColorBit = 0x8000;

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

/// Materialise Magics' colour of the whole object.
std::optional<glm::u8vec4> magicsColor(const Source &source)
{
    const std::size_t at = source.text().substr(0, kHeaderBytes).find("COLOR=");
    if (at == std::string_view::npos || at + 10 > kHeaderBytes)
        return std::nullopt;
    const std::uint8_t *rgba = source.bytes.data() + at + 6;
    return glm::u8vec4(rgba[0], rgba[1], rgba[2], 255);
}

Mesh readBinary(const Source &source, std::vector<base::Note> &notes)
{
    if (source.bytes.size() < kBytesBeforeTriangles)
        failMalformed(tr("the file ends within the header"));
    const std::size_t count = numberAt<std::uint32_t>(source.bytes.data() + kHeaderBytes);
    const std::size_t present = (source.bytes.size() - kBytesBeforeTriangles) / kTriangleBytes;
    if (count > present)
        failMalformed(tr("the header declares %1 triangles, the file ends after %2", count, present));
    const std::size_t bytesBehind = bytesThatMean(source.bytes.subspan(kBytesBeforeTriangles + count * kTriangleBytes));
    if (bytesBehind >= kTriangleBytes)
        failMalformed(tr("the header declares %1 triangles, the file is long enough for %2; correct the number in "
                         "bytes 80 to 83 of the file",
                         count, present));
    noteBytesBehind(notes, bytesBehind);

    const std::uint8_t *records = source.bytes.data() + kBytesBeforeTriangles;
    const auto positionAt = [records](std::size_t corner) {
        const std::uint8_t *bytes = records + corner / 3 * kTriangleBytes + 12 + corner % 3 * 12;
        return glm::vec3(numberAt<float>(bytes), numberAt<float>(bytes + 4), numberAt<float>(bytes + 8));
    };
    const auto attributeOf = [records](std::size_t triangle) {
        return numberAt<std::uint16_t>(records + triangle * kTriangleBytes + 48);
    };
    Box box;
    bool hasColorBits = false;
    std::mutex mutex;
    inParallelRanges(count, kTrianglesInTask, source.progress.part(0.0, 0.4), [&](std::size_t begin, std::size_t end) {
        constexpr float kMost = std::numeric_limits<float>::max();
        glm::vec3 lowest(kMost), highest(-kMost);
        std::uint16_t bits = 0;
        for (std::size_t corner = 3 * begin; corner < 3 * end; ++corner) {
            const glm::vec3 position = positionAt(corner);
            lowest = glm::min(lowest, position);
            highest = glm::max(highest, position);
            if (!std::isfinite(position.x + position.y + position.z) && !isFinite(position))
                failNotFinite(corner);
        }
        for (std::size_t t = begin; t < end; ++t)
            bits |= attributeOf(t);
        const std::lock_guard lock(mutex);
        box.add(glm::dvec3(lowest));
        box.add(glm::dvec3(highest));
        hasColorBits = hasColorBits || (bits & kColorBit) != 0;
    });

    Mesh mesh;
    mesh.origin = originFor(box);
    fillInParallel(mesh.positions, 3 * count, source.progress.part(0.4, 0.8), [&](std::size_t begin, std::size_t end) {
        for (std::size_t corner = begin; corner < end; ++corner)
            mesh.positions[corner] = glm::vec3(glm::dvec3(positionAt(corner)) - mesh.origin);
    });
    const std::optional<glm::u8vec4> ofObject = magicsColor(source);
    if (!ofObject && !hasColorBits)
        return mesh;
    mesh.baseColor = glm::vec4(1.0f);
    mesh.colors.reserve(3 * count);
    for (std::size_t t = 0; t < count; ++t) {
        const std::uint16_t bits = attributeOf(t);
        // The bit means in Magics that the whole object's colour applies; in other programs, that
        // the triangle's does.
        const bool hasOwnColor = ((bits & kColorBit) != 0) != ofObject.has_value();
        mesh.colors.insert(mesh.colors.end(), 3,
                           hasOwnColor ? colorFromBits(bits, ofObject.has_value())
                                       : ofObject.value_or(glm::u8vec4(204, 204, 204, 255)));
    }
    return mesh;
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
        const std::string keyword = lowerCase(word);
        if (++words % (kTrianglesBetweenReports * 4) == 0 && report)
            report(scanner.offset());
        if (keyword == "vertex") {
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
        } else if (keyword == "endfacet") {
            if (cornersOfFacet != 3)
                failAtLine(scanner.line(), tr("a facet has %1 vertices instead of 3", cornersOfFacet));
            cornersOfFacet = 0;
        } else if (keyword == "solid") {
            part.isInSolid = true;
            scanner.skipLine();
        } else if (keyword == "endsolid") {
            part.isInSolid = false;
            scanner.skipLine();
        } else if (keyword == "normal") {
            // The numbers are unused, and some programs write "nan" for a thin triangle.
            for (int axis = 0; axis < 3; ++axis)
                scanner.nextWordInLine();
        } else if (word.starts_with('#')) {
            scanner.skipLine();
        } else if (keyword != "facet" && keyword != "outer" && keyword != "loop" && keyword != "endloop") {
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
        if (lowerCase(text.substr(word, 5)) == "facet")
            return word;
        at = std::max(word, at + 1);
    }
    return text.size();
}

/// Reads a text on all cores. Nothing for a short text or on an error: sequential reading then
/// reports it.
std::optional<AsciiPart> readAsciiParts(const Source &source)
{
    const std::vector<std::string_view> pieces = textPieces(source.unpaddedText(), nextFacet);
    if (pieces.size() < 2)
        return std::nullopt;
    std::vector<AsciiPart> parts(pieces.size());
    try {
        inParallel(pieces.size(), source.progress.part(),
                   [&](std::size_t i) { parts[i] = readAscii(TextScanner(pieces[i]), pieces[i].size(), {}); });
    } catch (const base::Error &) {
        return std::nullopt;
    }
    AsciiPart whole = std::move(parts.front());
    std::size_t size = 0;
    for (const AsciiPart &part : parts)
        size += part.positions.size();
    whole.positions.reserve(whole.positions.size() + size);
    for (std::size_t i = 1; i < parts.size(); ++i) {
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
        TextScanner all(source.text());
        while (!all.isAtEnd())
            all.skipLine();
        failUnended(all.line());
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
        return lowerCase(first) == "solid" && lowerCase(scanner.nextWord()) == "facet";
    }
    for (TextScanner words(start); !words.isAtEnd();) {
        const std::string word = lowerCase(words.nextWord());
        if (word == "facet" || word == "endsolid")
            return true;
    }
    return lowerCase(first) == "solid";
}

} // namespace

Model readStl(const Source &source)
{
    Model model;
    Mesh mesh = isAscii(source) ? readAscii(source) : readBinary(source, model.notes);
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
