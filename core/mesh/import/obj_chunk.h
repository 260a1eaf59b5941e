#pragma once

#include "core/geometry/box.h"
#include "core/mesh/import/mesh_reader.h"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace unprojector::mesh::reader {

class ObjCursor;

/// The kinds of references of a face corner, in the order of "1/2/3". Also indexes counts and
/// arrays by kind.
enum ObjKind : std::size_t { ObjVertex, ObjTexcoord, ObjNormal };
inline constexpr std::size_t kObjKinds = 3;
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

/// Some whole statements of an OBJ file, parsed independently of the others. resolve() does the
/// parts that depend on the others.
class ObjChunk {
public:
    /// Parses the statements. Throws no error, since an earlier chunk may have failed first, see
    /// failure().
    void parse(std::string_view text);
    /// Numbers the corners from the beginning of the file. References to missing texture
    /// coordinates or normals are removed from their faces.
    /// @param before  the counts of all chunks before
    /// @param linesBefore  theirs, for messages
    /// Throws Damage for a face with a vertex that the file does not have.
    void resolve(const ObjCounts &before, const ObjCounts &total, std::size_t linesBefore);

    /// The first statement that cannot be used.
    struct StatementFailure {
        std::size_t line;    ///< of the chunk, counted from 0
        std::string message; ///< without the line; empty: the next vertex is not finite
    };
    const std::optional<StatementFailure> &failure() const { return m_failure; }
    std::size_t lineCount() const { return m_lineCount; }
    ObjCounts counts() const;

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

    // Counts of dropped parts.
    std::size_t lines = 0;
    std::size_t points = 0;
    std::size_t verticesWithMore = 0;            ///< with surplus words
    std::size_t verticesWithWeight = 0;          ///< for rational curves
    std::size_t unknownLines = 0;                ///< lines that begin with an unknown word
    std::size_t firstUnknownLine = 0;            ///< number of lines of the chunk before it
    std::string firstUnknown;                    ///< its first word
    std::size_t facesWithoutTexcoords = 0;       ///< though they name some
    std::size_t facesWithoutNormals = 0;         ///< though they name some
    std::map<std::string, std::size_t> notShown; ///< free-form curves and the like, by keyword

private:
    struct Corner {
        std::array<std::int64_t, kObjKinds> numbers{}; ///< as written, 0: none
    };

    void readStatement(ObjCursor &cursor);
    void readVertex(ObjCursor &cursor);
    void readVector(ObjCursor &cursor, const char *what, int least, int most, double *values);
    void readFace(ObjCursor &cursor);
    void readOther(ObjCursor &cursor, std::string_view keyword);
    static bool readCorner(ObjCursor &cursor, Corner &corner);
    void addCorner(ObjKind kind, std::int64_t number, bool isNamed);
    void addFace(ObjRun face);
    void dropCornersFrom(std::size_t first);
    void fail(ObjCursor &cursor, std::string message);
    [[noreturn]] void failAtFace(std::size_t face, const ObjCounts &before, const ObjCounts &total,
                                 std::size_t linesBefore) const;
    void checkParts(const ObjCounts &total);

    std::string_view m_text;
    std::size_t m_lineCount = 0;
    std::optional<StatementFailure> m_failure;
    std::uint32_t m_material = 0;
    /// Indices of corners with a relative number, counted back from their line. They are resolved
    /// when all chunks are known.
    std::array<std::vector<std::size_t>, kObjKinds> m_countedBack;
};

} // namespace unprojector::mesh::reader
