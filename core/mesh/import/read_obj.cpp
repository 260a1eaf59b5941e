#include "core/base/parallel.h"
#include "core/base/translation.h"
#include "core/geometry/finite.h"
#include "core/mesh/import/mesh_reader.h"
#include "core/mesh/import/obj_chunk.h"
#include "core/mesh/import/obj_materials.h"
#include "core/mesh/import/obj_vertices.h"
#include "core/mesh/import/polygon_triangulation.h"

#include <algorithm>
#include <deque>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <tuple>
#include <utility>

namespace unprojector::mesh::reader {
using namespace geometry;
using namespace base;

namespace {

/// A few milliseconds of work.
constexpr std::size_t kChunkBytes = 1 << 20;
constexpr std::size_t kCornersBetweenReports = 1 << 18;

bool isLineEnd(char c)
{
    return c == '\n' || c == '\r';
}

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

    void parse();
    void throwFirstFailure();
    void placePositions();
    void resolveFaces();
    void triangulate(ObjChunk &chunk) const;
    void addNotes();
    void sortIntoParts();
    void makeMeshes();
    Mesh plainMesh();
    Mesh splitMesh(const Part &part, bool isOnly);
    void makePoints();

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

void ObjReader::parse()
{
    std::string_view text = m_source.unpaddedText();
    std::vector<std::string_view> pieces;
    while (!text.empty()) {
        const std::size_t size = text.size() <= kChunkBytes ? text.size() : statementEnd(text, kChunkBytes);
        pieces.push_back(text.substr(0, size));
        text.remove_prefix(size);
    }
    m_chunks.resize(pieces.size());
    inParallel(pieces.size(), m_source.progress.part(0.0, 0.6), [&](std::size_t i) { m_chunks[i].parse(pieces[i]); });
}

void ObjReader::throwFirstFailure()
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

void ObjReader::placePositions()
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

void ObjReader::resolveFaces()
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
void ObjReader::triangulate(ObjChunk &chunk) const
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

void ObjReader::addNotes()
{
    std::size_t lines = 0, points = 0, more = 0, weights = 0, texcoords = 0, normals = 0, unknownCount = 0;
    std::vector<std::string> unknown; // the first: its word and line
    std::size_t linesBefore = 0;
    std::map<std::string, std::size_t> notShown;
    for (const ObjChunk &chunk : m_chunks) {
        lines += chunk.lines;
        points += chunk.points;
        more += chunk.verticesWithMore;
        weights += chunk.verticesWithWeight;
        if (unknown.empty() && chunk.unknownLines > 0)
            unknown = {chunk.firstUnknown, std::to_string(linesBefore + chunk.firstUnknownLine + 1)};
        unknownCount += chunk.unknownLines;
        linesBefore += chunk.lineCount();
        texcoords += chunk.facesWithoutTexcoords;
        normals += chunk.facesWithoutNormals;
        for (const auto &[keyword, count] : chunk.notShown)
            notShown[keyword] += count;
    }
    std::vector<Note> &notes = m_model.notes;
    noteLines(notes, m_hasFaces ? lines + points : lines);
    noteVerticesWithMore(notes, more);
    addNote(notes, weights, marked("%1 vertex has a fourth number, the weight of rational curves: it is not used"),
            marked("%1 vertices have a fourth number, the weight of rational curves: it is not used"));
    addNote(notes, unknownCount,
            marked("not used: %1 line that begins with a word unknown to the format, \"%2\" in line %3"),
            marked("not used: %1 lines that begin with words unknown to the format, the first is \"%2\" in line %3"),
            unknown);
    addNote(notes, texcoords,
            marked("%1 face refers to texture coordinates that the file does not have: shown without an image"),
            marked("%1 faces refer to texture coordinates that the file does not have: shown without an image"));
    addNote(notes, normals, marked("%1 face refers to normals that the file does not have: they are computed instead"),
            marked("%1 faces refer to normals that the file does not have: they are computed instead"));
    for (const auto &[keyword, count] : notShown)
        noteParts(notes, count, keyword);
}

/// Makes one part for each material and set of attributes, in the order of the file.
void ObjReader::sortIntoParts()
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
            const auto [known, isNew] = partNumbers.try_emplace({number, hasTexcoords, run.hasNormals}, m_parts.size());
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
            {marked(others == 0   ? "no material is called \"%1\": its surfaces are shown in grey"
                    : others == 1 ? "no material is called \"%1\" or by %2 other name of the file: its surfaces are "
                                    "shown in grey"
                                  : "no material is called \"%1\" or by %2 other names of the file: its surfaces are "
                                    "shown in grey"),
             {unknown.front(), std::to_string(others)}});
}

void ObjReader::makeMeshes()
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
Mesh ObjReader::plainMesh()
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
Mesh ObjReader::splitMesh(const Part &part, bool isOnly)
{
    ObjVertices vertices(isOnly ? m_vertices.positions.size() : 0);
    Mesh mesh;
    mesh.indices.reserve(part.cornerCount);
    for (const Corners &corners : part.corners) {
        const ObjChunk &chunk = m_chunks[corners.chunk];
        for (std::size_t corner = corners.begin; corner < corners.end; ++corner) {
            if (++m_cornersDone % kCornersBetweenReports == 0)
                m_source.progress.part(0.85,
                                       1.0)(static_cast<double>(m_cornersDone) / static_cast<double>(m_cornerCount));
            mesh.indices.push_back(vertices.add({chunk.corners[ObjVertex][corner],
                                                 part.hasTexcoords ? chunk.corners[ObjTexcoord][corner] : -1,
                                                 part.hasNormals ? chunk.corners[ObjNormal][corner] : -1}));
        }
    }
    mesh.positions.reserve(vertices.all().size());
    const bool isSplit = !isOnly || vertices.all().size() > m_vertices.positions.size();
    for (const ObjVertices::Vertex &of : vertices.all()) {
        const auto vertex = static_cast<std::size_t>(of[ObjVertex]);
        mesh.positions.push_back(glm::vec3(m_vertices.positions[vertex]));
        if (isSplit)
            mesh.vertexNumbers.push_back(static_cast<std::uint32_t>(vertex));
        if (!m_vertices.remainders.empty())
            mesh.remainders.push_back(glm::ivec3(m_vertices.remainders[vertex]));
        if (!m_vertices.colors.empty())
            mesh.colors.push_back(glm::u8vec4(m_vertices.colors[vertex]));
        if (part.hasTexcoords)
            mesh.texcoords.push_back(of[ObjTexcoord] >= 0 ? m_texcoords[static_cast<std::size_t>(of[ObjTexcoord])]
                                                          : glm::vec2(0.0f));
        if (part.hasNormals)
            mesh.normals.push_back(of[ObjNormal] >= 0 ? m_normals[static_cast<std::size_t>(of[ObjNormal])]
                                                      : glm::vec3(0.0f, 0.0f, 1.0f));
    }
    return mesh;
}

void ObjReader::makePoints()
{
    Mesh mesh = std::move(m_vertices);
    mesh.kind = Mesh::Kind::Points;
    mesh.baseColor = Material{}.baseColorOf(mesh.kind, !mesh.colors.empty());
    m_model.meshes.push_back(std::move(mesh));
}

} // namespace

Model readObj(const Source &source)
{
    return ObjReader(source).read();
}

} // namespace unprojector::mesh::reader
