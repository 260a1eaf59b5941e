#include "core/mesh/import/obj_chunk.h"

#include "core/base/printable.h"
#include "core/base/text_scanner.h"
#include "core/base/translation.h"
#include "core/geometry/finite.h"
#include "core/mesh/import/line_ranges.h"
#include "core/mesh/import/material.h"
#include "core/mesh/import/obj_cursor.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

namespace unprojector::mesh::reader {
using namespace geometry;
using base::marked;
using base::quoted;
using base::tr;

namespace {

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

} // namespace

ObjCounts ObjChunk::counts() const
{
    return {static_cast<std::int64_t>(positions.size()), static_cast<std::int64_t>(texcoords.size()),
            static_cast<std::int64_t>(normals.size())};
}

void ObjChunk::fail(ObjCursor &cursor, std::string message)
{
    if (!m_failure)
        m_failure = {cursor.linesBefore(), std::move(message)};
}

void ObjChunk::parse(std::string_view text)
{
    m_text = text;
    if (const std::size_t zero = text.find('\0'); zero != text.npos) {
        LineRange before;
        before.end = zero;
        countLines(text, before);
        m_failure = {before.lines, tr("the text has a byte 0; save the file as UTF-8 or ASCII text")};
        return;
    }
    ObjCursor cursor(text);
    while (!cursor.isAtEnd() && !m_failure) {
        readStatement(cursor);
        cursor.skipStatement();
    }
    m_lineCount = cursor.linesBefore();
}

void ObjChunk::readStatement(ObjCursor &cursor)
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

void ObjChunk::readVertex(ObjCursor &cursor)
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
    verticesWithMore += isKnown ? 0 : 1;
    // The format defines w as a weight in rational curves and surfaces. It has no meaning for
    // polygons.
    verticesWithWeight += isKnown && (count == 4 || count == 8) && values[3] != 1.0 ? 1 : 0;
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

void ObjChunk::readVector(ObjCursor &cursor, const char *what, int least, int most, double *values)
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
bool ObjChunk::readCorner(ObjCursor &cursor, Corner &corner)
{
    corner = {};
    if (!cursor.readInteger(corner.numbers[ObjVertex]))
        return false;
    for (std::size_t kind = ObjTexcoord; kind < kObjKinds && cursor.readIf('/'); ++kind)
        cursor.readInteger(corner.numbers[kind]);
    return cursor.isAtWordEnd();
}

void ObjChunk::addCorner(ObjKind kind, std::int64_t number, bool isNamed)
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

void ObjChunk::dropCornersFrom(std::size_t first)
{
    for (std::size_t kind = 0; kind < kObjKinds; ++kind) {
        if (corners[kind].size() > first)
            corners[kind].resize(first);
        while (!m_countedBack[kind].empty() && m_countedBack[kind].back() >= first)
            m_countedBack[kind].pop_back();
    }
}

void ObjChunk::addFace(ObjRun face)
{
    face.faces = 1;
    if (!runs.empty() && runs.back().isLike(face))
        ++runs.back().faces;
    else
        runs.push_back(face);
}

void ObjChunk::readFace(ObjCursor &cursor)
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
        addCorner(ObjVertex, corner.numbers[ObjVertex], true);
        addCorner(ObjTexcoord, corner.numbers[ObjTexcoord], corner.numbers[ObjTexcoord] != 0);
        addCorner(ObjNormal, corner.numbers[ObjNormal], corner.numbers[ObjNormal] != 0);
        namesTexcoords = namesTexcoords || corner.numbers[ObjTexcoord] != 0;
        face.hasTexcoords = face.hasTexcoords && corner.numbers[ObjTexcoord] != 0;
        face.hasNormals = face.hasNormals && corner.numbers[ObjNormal] != 0;
        ++face.cornersEach;
    }
    if (face.cornersEach < 3) {
        dropCornersFrom(first);
        ++lines;
        return;
    }
    facesWithoutTexcoords += namesTexcoords && !face.hasTexcoords ? 1 : 0;
    addFace(face);
}

void ObjChunk::readOther(ObjCursor &cursor, std::string_view keyword)
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
        ++lines;
    } else if (keyword == "p") {
        while (!cursor.word().empty())
            ++points;
    } else if (std::find(std::begin(kNotShown), std::end(kNotShown), keyword) != std::end(kNotShown)) {
        ++notShown[std::string(keyword)];
    } else if (std::find(std::begin(kWithoutGeometry), std::end(kWithoutGeometry), keyword)
               == std::end(kWithoutGeometry)) {
        if (unknownLines++ == 0) {
            firstUnknownLine = cursor.linesBefore();
            firstUnknown = base::printableBeginning(keyword, 40);
        }
    }
}

void ObjChunk::resolve(const ObjCounts &before, const ObjCounts &total, std::size_t linesBefore)
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

/// Removes the texture coordinates or normals from faces that name missing ones.
void ObjChunk::checkParts(const ObjCounts &total)
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
            facesWithoutTexcoords += run.hasTexcoords && !face.hasTexcoords ? 1 : 0;
            facesWithoutNormals += run.hasNormals && !face.hasNormals ? 1 : 0;
            addFace(face);
        }
    }
}

/// Reads the lines again: to save memory, the line of each face is not stored for the rare error.
void ObjChunk::failAtFace(std::size_t face, const ObjCounts &before, const ObjCounts &total,
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
            const std::int64_t number = corner.numbers[ObjVertex];
            const bool exists = number > 0 ? number <= total[ObjVertex] : number < 0 && number >= -soFar[ObjVertex];
            if (!exists)
                failMalformed(tr("line %1: a face refers to vertex %2, the file has %3",
                                 linesBefore + cursor.linesBefore() + 1, number, total[ObjVertex]));
        }
    }
    failMalformed(tr("a face refers to a vertex that the file does not have"));
}

} // namespace unprojector::mesh::reader
