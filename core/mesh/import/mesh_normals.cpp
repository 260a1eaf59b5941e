#include "core/mesh/import/mesh_normals.h"

#include "core/base/parallel.h"
#include "core/mesh/numbering.h"
#include "core/mesh/soup_numbers.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <mutex>
#include <numeric>
#include <utility>

namespace unprojector::mesh {
using namespace geometry;
using namespace base;

namespace {

constexpr std::uint32_t kEmpty = 0xffffffffu;
constexpr float kCosineOfCrease = 0.5f;
constexpr std::size_t kTrianglesBetweenReports = 1 << 16;
/// A few milliseconds of work.
constexpr std::size_t kTrianglesInTask = 1 << 15;

/// A triangle's unit normal, and its area in units that keep the sums far from overflow.
struct FaceNormal {
    glm::vec3 direction{0.0f};
    float weight = 0.0f;
};

glm::vec3 normalizedOrUp(const glm::vec3 &sum)
{
    // The square of a tiny area's normal underflows in single precision.
    const double length = glm::length(glm::dvec3(sum));
    return length > 0.0 ? glm::vec3(glm::dvec3(sum) / length) : glm::vec3(0.0f, 0.0f, 1.0f);
}

std::vector<FaceNormal> faceNormalsOf(const Mesh &mesh, const std::function<void(double)> &report)
{
    Box box;
    for (const glm::vec3 &position : mesh.positions)
        box.add(glm::dvec3(position));
    const double scale = box.diagonal() > 0.0 ? 1.0 / box.diagonal() : 1.0;

    std::vector<FaceNormal> faces(mesh.triangleCount());
    const auto reportPart = [&report](double share) { report(0.4 * share); };
    inParallelRanges(faces.size(), kTrianglesInTask, reportPart, [&](std::size_t begin, std::size_t end) {
        for (std::size_t t = begin; t < end; ++t) {
            const glm::dvec3 a(mesh.positions[mesh.indices[3 * t]]);
            const glm::dvec3 b(mesh.positions[mesh.indices[3 * t + 1]]);
            const glm::dvec3 c(mesh.positions[mesh.indices[3 * t + 2]]);
            const glm::dvec3 normal = glm::cross((b - a) * scale, (c - a) * scale);
            const double area = glm::length(normal);
            if (area > 0.0)
                faces[t] = {glm::vec3(normal / area), static_cast<float>(area)};
        }
    });
    return faces;
}

/// The sum of the faces' normals around each position. The faces are added in their order for any
/// number of cores: each task adds to its own positions.
std::vector<glm::vec3> normalSums(const Mesh &mesh, const std::vector<FaceNormal> &faces,
                                  const std::vector<std::uint32_t> &positionOfVertex, std::size_t positionCount)
{
    std::vector<glm::vec3> sums(positionCount, glm::vec3(0.0f));
    // Each task scans all corners, so more tasks would gain little.
    constexpr std::size_t kMostTasks = 4;
    const std::size_t cores = coreCount();
    const std::size_t tasks = mesh.indices.size() < 3 * kTrianglesInTask ? 1 : std::min(cores, kMostTasks);
    inParallel(tasks, {}, [&](std::size_t task) {
        const std::size_t begin = positionCount * task / tasks, end = positionCount * (task + 1) / tasks;
        for (std::size_t c = 0; c < mesh.indices.size(); ++c) {
            const std::size_t position = positionOfVertex[mesh.indices[c]];
            if (position >= begin && position < end)
                sums[position] += faces[c / 3].direction * faces[c / 3].weight;
        }
    });
    inParallelRanges(positionCount, kTrianglesInTask, {}, [&](std::size_t begin, std::size_t end) {
        for (std::size_t position = begin; position < end; ++position)
            sums[position] = normalizedOrUp(sums[position]);
    });
    return sums;
}

/// The positions around which a face deviates from the mean by more than an angle.
std::vector<std::uint32_t> creasedPositions(const Mesh &mesh, const std::vector<FaceNormal> &faces,
                                            const std::vector<std::uint32_t> &positionOfVertex,
                                            const std::vector<glm::vec3> &means, float cosine)
{
    std::vector<std::uint32_t> creased;
    std::mutex mutex;
    inParallelRanges(mesh.indices.size(), 3 * kTrianglesInTask, {}, [&](std::size_t begin, std::size_t end) {
        std::vector<std::uint32_t> own;
        for (std::size_t c = begin; c < end; ++c) {
            const FaceNormal &face = faces[c / 3];
            const std::uint32_t position = positionOfVertex[mesh.indices[c]];
            if (face.weight > 0.0f && !(glm::dot(face.direction, means[position]) >= cosine))
                own.push_back(position);
        }
        const std::lock_guard lock(mutex);
        creased.insert(creased.end(), own.begin(), own.end());
    });
    return creased;
}

/// The corners around each creased position, sorted by position, in compressed rows.
struct CornerRows {
    std::vector<std::uint32_t> begin; ///< indexed by creased position; one more entry than positions
    std::vector<std::uint32_t> corners;
};

/// Groups the faces around one position: faces that share an edge there and differ by less than the
/// crease angle.
class CreaseGroups {
public:
    CreaseGroups(const std::vector<FaceNormal> &faces, const std::vector<std::uint32_t> &positionOfCorner)
        : m_faces(faces), m_positionOfCorner(positionOfCorner)
    {
    }

    /// Sets `groups` to the group of each corner, numbered from 0. Returns the number of groups.
    std::uint32_t group(std::span<const std::uint32_t> corners, std::vector<std::uint32_t> &groups)
    {
        m_joined.reset(corners.size());
        m_edges.clear();
        for (std::uint32_t i = 0; i < corners.size(); ++i) {
            const std::uint32_t first = corners[i] - corners[i] % 3;
            m_edges.emplace_back(m_positionOfCorner[first + (corners[i] + 1 - first) % 3], i);
            m_edges.emplace_back(m_positionOfCorner[first + (corners[i] + 2 - first) % 3], i);
        }
        std::sort(m_edges.begin(), m_edges.end());
        for (std::size_t e = 1; e < m_edges.size(); ++e) {
            const auto &[from, one] = m_edges[e - 1];
            const auto &[to, other] = m_edges[e];
            const FaceNormal &a = m_faces[corners[one] / 3], &b = m_faces[corners[other] / 3];
            const bool isFlat = a.weight == 0.0f || b.weight == 0.0f;
            if (from == to && (isFlat || glm::dot(a.direction, b.direction) >= kCosineOfCrease))
                m_joined.join(one, other);
        }
        groups.assign(corners.size(), kEmpty);
        std::uint32_t groupCount = 0;
        for (std::uint32_t i = 0; i < corners.size(); ++i) {
            std::uint32_t &group = groups[m_joined.of(i)];
            if (group == kEmpty)
                group = groupCount++;
            groups[i] = group;
        }
        return groupCount;
    }

private:
    const std::vector<FaceNormal> &m_faces;
    const std::vector<std::uint32_t> &m_positionOfCorner;
    std::vector<std::pair<std::uint32_t, std::uint32_t>> m_edges;
    JoinedGroups m_joined;
};

std::uint32_t appendCopy(Mesh &mesh, std::uint32_t vertex)
{
    mesh.positions.push_back(glm::vec3(mesh.positions[vertex]));
    if (!mesh.remainders.empty())
        mesh.remainders.push_back(glm::ivec3(mesh.remainders[vertex]));
    if (mesh.vertexNumbers.empty()) {
        mesh.vertexNumbers.resize(mesh.positions.size() - 1);
        std::iota(mesh.vertexNumbers.begin(), mesh.vertexNumbers.end(), 0u);
    }
    mesh.vertexNumbers.push_back(std::uint32_t{mesh.vertexNumbers[vertex]});
    mesh.normals.push_back(glm::vec3(mesh.normals[vertex]));
    if (!mesh.colors.empty())
        mesh.colors.push_back(glm::u8vec4(mesh.colors[vertex]));
    if (!mesh.texcoords.empty())
        mesh.texcoords.push_back(glm::vec2(mesh.texcoords[vertex]));
    return static_cast<std::uint32_t>(mesh.positions.size() - 1);
}

} // namespace

void mergeEqualVertices(Mesh &mesh)
{
    const bool hasNormals = !mesh.normals.empty();
    const bool hasColors = !mesh.colors.empty();
    const bool hasTexcoords = !mesh.texcoords.empty();
    const bool hasNumbers = !mesh.vertexNumbers.empty();
    const auto areEqual = [&](std::uint32_t a, std::uint32_t b) {
        return mesh.fromOrigin(a) == mesh.fromOrigin(b)
               && (!hasNumbers || mesh.vertexNumbers[a] == mesh.vertexNumbers[b])
               && (!hasNormals || mesh.normals[a] == mesh.normals[b])
               && (!hasColors || mesh.colors[a] == mesh.colors[b])
               && (!hasTexcoords || mesh.texcoords[a] == mesh.texcoords[b]);
    };

    if (mesh.indices.empty()) {
        mesh.indices.resize(mesh.positions.size());
        std::iota(mesh.indices.begin(), mesh.indices.end(), 0u);
    }
    const auto hashAt = [&](std::uint32_t index) {
        std::uint64_t hash = placeHash(mesh, index);
        if (hasNumbers)
            hash = mixed(hash, mesh.vertexNumbers[index]);
        if (hasNormals)
            hash = hashOf(mesh.normals[index], hash);
        if (hasTexcoords)
            hash = hashOf(glm::vec3(mesh.texcoords[index], 0.0f), hash);
        return hash;
    };
    std::vector<std::uint32_t> mergedFromOld(mesh.positions.size(), kEmpty);
    FirstEqual firsts(mesh.positions.size());
    std::vector<std::uint32_t> oldFromMerged;
    for (std::uint32_t &index : mesh.indices) {
        if (mergedFromOld[index] == kEmpty) {
            const std::uint32_t first = firsts.of(index, hashAt, areEqual);
            if (first == index) {
                mergedFromOld[index] = static_cast<std::uint32_t>(oldFromMerged.size());
                oldFromMerged.push_back(index);
            }
            mergedFromOld[index] = mergedFromOld[first];
        }
        index = mergedFromOld[index];
    }
    gatherVertices(mesh, oldFromMerged);
}

void gatherVertices(Mesh &mesh, std::span<const std::uint32_t> vertices)
{
    mesh.positions = gathered(mesh.positions, vertices);
    mesh.remainders = gathered(mesh.remainders, vertices);
    mesh.vertexNumbers = gathered(mesh.vertexNumbers, vertices);
    mesh.normals = gathered(mesh.normals, vertices);
    mesh.colors = gathered(mesh.colors, vertices);
    mesh.texcoords = gathered(mesh.texcoords, vertices);
}

void makeNormals(Mesh &mesh, const std::function<void(double)> &report)
{
    const std::vector<FaceNormal> faces = faceNormalsOf(mesh, report);

    // By their positions in single precision, as drawn.
    std::vector<glm::ivec3> remainders = std::exchange(mesh.remainders, {});
    std::vector<std::uint32_t> positionOfVertex;
    const std::size_t positionCount = numberPlaces(mesh, positionOfVertex);
    mesh.remainders = std::move(remainders);
    const std::vector<glm::vec3> means = normalSums(mesh, faces, positionOfVertex, positionCount);
    report(0.6);

    mesh.normals.clear();
    fillInParallel(mesh.normals, mesh.positions.size(), {}, [&](std::size_t begin, std::size_t end) {
        for (std::size_t v = begin; v < end; ++v)
            mesh.normals[v] = means[positionOfVertex[v]];
    });

    // Faces within half the crease angle of their mean are within the crease angle of each other.
    // This settles nearly all positions of a scan; only the rest needs an edge-by-edge test.
    const float cosineOfHalfCrease = std::sqrt((1.0f + kCosineOfCrease) / 2.0f);
    std::vector<std::uint32_t> creasedNumber(positionCount, kEmpty);
    CornerRows rows;
    for (const std::uint32_t position : creasedPositions(mesh, faces, positionOfVertex, means, cosineOfHalfCrease))
        creasedNumber[position] = 0;
    std::uint32_t creasedCount = 0;
    for (std::uint32_t &number : creasedNumber) {
        if (number != kEmpty)
            number = creasedCount++;
    }
    report(0.8);
    if (creasedCount == 0)
        return;

    std::vector<std::uint32_t> positionOfCorner(mesh.indices.size());
    rows.begin.assign(creasedCount + 1, 0);
    for (std::size_t c = 0; c < mesh.indices.size(); ++c) {
        positionOfCorner[c] = positionOfVertex[mesh.indices[c]];
        if (const std::uint32_t number = creasedNumber[positionOfCorner[c]]; number != kEmpty)
            ++rows.begin[number + 1];
    }
    std::partial_sum(rows.begin.begin(), rows.begin.end(), rows.begin.begin());
    rows.corners.resize(rows.begin.back());
    std::vector<std::uint32_t> next(rows.begin.begin(), rows.begin.end() - 1);
    for (std::size_t c = 0; c < mesh.indices.size(); ++c) {
        if (const std::uint32_t number = creasedNumber[positionOfCorner[c]]; number != kEmpty)
            rows.corners[next[number]++] = static_cast<std::uint32_t>(c);
    }

    CreaseGroups creaseGroups(faces, positionOfCorner);
    std::vector<std::uint32_t> groups;
    std::vector<glm::vec3> groupNormals;
    // Maps (vertex, group) to its vertex; a vertex's first group keeps its number.
    std::vector<std::pair<std::uint64_t, std::uint32_t>> order;
    for (std::uint32_t number = 0; number < creasedCount; ++number) {
        if (number % kTrianglesBetweenReports == 0)
            report(0.8 + 0.2 * number / creasedCount);
        const std::uint32_t count = rows.begin[number + 1] - rows.begin[number];
        const auto corners = std::span<const std::uint32_t>(rows.corners).subspan(rows.begin[number], count);
        const std::uint32_t groupCount = creaseGroups.group(corners, groups);

        groupNormals.assign(groupCount, glm::vec3(0.0f));
        for (std::uint32_t i = 0; i < count; ++i)
            groupNormals[groups[i]] += faces[corners[i] / 3].direction * faces[corners[i] / 3].weight;
        order.clear();
        for (std::uint32_t i = 0; i < count; ++i)
            order.emplace_back(std::uint64_t{mesh.indices[corners[i]]} << 32 | groups[i], corners[i]);
        std::sort(order.begin(), order.end());
        std::uint32_t target = 0;
        for (std::size_t i = 0; i < order.size(); ++i) {
            const auto vertex = static_cast<std::uint32_t>(order[i].first >> 32);
            if (i == 0 || order[i].first != order[i - 1].first) {
                const bool isFirstGroup = i == 0 || vertex != order[i - 1].first >> 32;
                target = isFirstGroup ? vertex : appendCopy(mesh, vertex);
                mesh.normals[target] = normalizedOrUp(groupNormals[order[i].first & 0xffffffffu]);
            }
            mesh.indices[order[i].second] = target;
        }
    }
}

} // namespace unprojector::mesh
