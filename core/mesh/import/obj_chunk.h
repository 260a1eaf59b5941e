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

/// What a corner of a face refers to, in the order of "1/2/3"; also where that is counted or kept by kind.
enum ObjKind : std::size_t { ObjVertex, ObjTexcoord, ObjNormal };
inline constexpr std::size_t kObjKinds = 3;
using ObjCounts = std::array<std::int64_t, kObjKinds>;

/// Faces that follow each other and are alike.
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

/// Some whole statements of an OBJ file, read without knowing the others; what depends on those is left to resolve().
class ObjChunk {
public:
    /// Throws no Failure: the chunks before have a say, see failure().
    void parse(std::string_view text);
    /// Numbers the corners from the file's beginning. Faces that name texture coordinates or normals which the file does
    /// not have lose them.
    /// @param before  what all chunks before hold
    /// @param linesBefore  theirs, for messages
    /// Throws Failure (Malformed) for a face with a vertex that the file does not have.
    void resolve(const ObjCounts &before, const ObjCounts &total, std::size_t linesBefore);

    /// The first statement that cannot be used.
    struct StatementFailure {
        std::size_t line; ///< of the chunk, counted from 0
        ImportErrorCode code;
        std::string message; ///< without the line
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
    /// By ObjKind: what the corners of all faces refer to, counted from 0 once resolved. Of texture coordinates and
    /// normals all corners, −1 where there is none, or no corner.
    std::array<std::vector<std::int32_t>, kObjKinds> corners;
    /// The names after "usemtl". The first stands for the last name before this chunk.
    std::vector<std::string> materials{std::string()};
    std::vector<std::string> libraries; ///< the rests of the lines after "mtllib"

    // What is left out.
    std::size_t lines = 0;
    std::size_t points = 0;
    std::size_t verticesWithMore = 0;            ///< words than mean something there
    std::size_t verticesWithWeight = 0;          ///< of rational curves
    std::size_t unknownLines = 0;                ///< that begin with a word which the format does not have
    std::size_t firstUnknownLine = 0;            ///< lines of the chunk before it
    std::string firstUnknown;                    ///< its first word, quoted
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
    void fail(ObjCursor &cursor, std::string message, ImportErrorCode code = ImportErrorCode::Malformed);
    [[noreturn]] void failAtFace(std::size_t face, const ObjCounts &before, const ObjCounts &total,
                                 std::size_t linesBefore) const;
    void checkParts(const ObjCounts &total);

    std::string_view m_text;
    std::size_t m_lineCount = 0;
    std::optional<StatementFailure> m_failure;
    std::uint32_t m_material = 0;
    /// Corners with a number that counts back from their own line: from what it does is known when all chunks are.
    std::array<std::vector<std::size_t>, kObjKinds> m_countedBack;
};

} // namespace unprojector::mesh::reader
