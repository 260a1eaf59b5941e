#include "core/mesh/curvature.h"

#include "core/base/parallel.h"
#include "core/mesh/numbering.h"
#include "core/mesh/soup_numbers.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>

namespace unprojector::mesh {
namespace {

/// The size of a cell: a share of the surface's radius, and of the distance of vertices.
constexpr double kCellOfRadius = 0.015, kCellOfSpacing = 1.0;
/// The weight of a cluster ends at this many cells. With fewer, the grid would show.
constexpr double kReachCells = 2.5;
constexpr std::size_t kTrianglesBetweenReports = 500'000, kPlacesAtOnce = 20'000;

struct Triangle {
    std::array<std::uint32_t, 3> corners; ///< places
    std::array<glm::dvec3, 3> at;
    glm::dvec3 normal{0.0}; ///< of length 1
    double area = 0.0;
};

/// The surface of all meshes: vertices at equal positions are one place.
class Surface {
public:
    explicit Surface(const Model &model)
    {
        Mesh joined; // of positions alone
        std::optional<glm::dvec3> origin;
        std::size_t cornerCount = 0;
        for (const Mesh &mesh : model.meshes) {
            m_begins.push_back(joined.positions.size());
            if (mesh.kind != Mesh::Kind::Triangles || mesh.positions.empty())
                continue;
            cornerCount += mesh.elementCount();
            const glm::dvec3 way = mesh.origin - origin.value_or(mesh.origin);
            origin = origin.value_or(mesh.origin);
            if (way == glm::dvec3(0.0))
                joined.positions.insert(joined.positions.end(), mesh.positions.begin(), mesh.positions.end());
            else
                for (const glm::vec3 &position : mesh.positions)
                    joined.positions.emplace_back(glm::dvec3(position) + way);
        }
        m_places.resize(numberPlaces(joined, m_numbers));
        for (std::size_t vertex = 0; vertex < m_numbers.size(); ++vertex)
            m_places[m_numbers[vertex]] = joined.positions[vertex];
        if (!model.bounds.isEmpty()) {
            const glm::dvec3 sides = model.bounds.highest - model.bounds.lowest;
            const double longest = std::max({sides.x, sides.y, sides.z});
            m_unit = longest > 0.0 && std::isfinite(longest) ? longest : 1.0;
        }
        m_corners.reserve(cornerCount);
        for (std::size_t number = 0; number < model.meshes.size(); ++number) {
            const Mesh &mesh = model.meshes[number];
            for (std::size_t corner = 0; corner < 3 * mesh.triangleCount(); ++corner)
                m_corners.push_back(m_numbers[m_begins[number] + mesh.vertexAt(corner)]);
        }
    }

    /// The model's size: all lengths here are shares of it, so that areas stay in single precision.
    double unit() const { return m_unit; }
    std::size_t placeCount() const { return m_places.size(); }
    glm::dvec3 place(std::size_t number) const { return glm::dvec3(m_places[number]) / m_unit; }
    /// The place of a vertex.
    std::uint32_t placeOf(std::size_t mesh, std::size_t vertex) const { return m_numbers[m_begins[mesh] + vertex]; }

    /// Calls a function with every triangle that has an area.
    template <class Function>
    void forEach(base::Reporter &reporter, const Function &function) const
    {
        const std::size_t count = m_corners.size() / 3;
        for (std::size_t number = 0; number < count; ++number) {
            if (number % kTrianglesBetweenReports == 0)
                reporter.report(static_cast<double>(number) / static_cast<double>(count));
            Triangle triangle;
            for (std::size_t k = 0; k < 3; ++k) {
                triangle.corners[k] = m_corners[3 * number + k];
                triangle.at[k] = place(triangle.corners[k]);
            }
            const glm::dvec3 across = glm::cross(triangle.at[1] - triangle.at[0], triangle.at[2] - triangle.at[0]);
            const double length = glm::length(across);
            if (!(static_cast<float>(length / 6.0) > 0.0f && std::isfinite(length)))
                continue;
            triangle.normal = across / length;
            triangle.area = 0.5 * length;
            function(triangle);
        }
    }

private:
    double m_unit = 1.0;
    std::vector<std::size_t> m_begins;    ///< of each mesh in the numbers
    std::vector<std::uint32_t> m_numbers; ///< the place of each vertex
    std::vector<glm::vec3> m_places;
    std::vector<std::uint32_t> m_corners; ///< three places a triangle
};

/// Sums over the places: a third of each triangle around them.
struct PlaceSums {
    std::vector<glm::vec3> normals; ///< sums of area times normal
    std::vector<float> areas;
    double area = 0.0;
    double radius = 0.0; ///< root of the mean squared distance from the middle
};

PlaceSums placeSums(const Surface &surface, base::Reporter &reporter)
{
    PlaceSums sums{std::vector<glm::vec3>(surface.placeCount()), std::vector<float>(surface.placeCount())};
    const glm::dvec3 zero = surface.placeCount() > 0 ? surface.place(0) : glm::dvec3(0.0);
    glm::dvec3 moment(0.0);
    double squares = 0.0;
    surface.forEach(reporter, [&](const Triangle &triangle) {
        const double third = triangle.area / 3.0;
        for (std::size_t k = 0; k < 3; ++k) {
            sums.normals[triangle.corners[k]] += glm::vec3(third * triangle.normal);
            sums.areas[triangle.corners[k]] += static_cast<float>(third);
            const glm::dvec3 way = triangle.at[k] - zero;
            moment += third * way;
            squares += third * glm::dot(way, way);
        }
        sums.area += triangle.area;
    });
    if (sums.area > 0.0) {
        const glm::dvec3 middle = moment / sums.area;
        sums.radius = std::sqrt(std::max(0.0, squares / sums.area - glm::dot(middle, middle)));
    }
    return sums;
}

/// A group of places in one cell whose normals point in about the same direction.
struct Cluster {
    glm::dvec3 center{0.0};
    glm::dvec3 normal{0.0}; ///< sum of area times normal
    double area = 0.0;
    double bend = 0.0; ///< integral of the mean curvature
};

class Clusters {
public:
    Clusters(const Surface &surface, const PlaceSums &sums, double cell, base::Reporter &reporter)
        : m_surface(surface), m_reach(kReachCells * cell), m_ofPlaces(surface.placeCount())
    {
        gather(sums, cell);
        reporter.beginStage(0.2, 0.35);
        connect(reporter);
        reporter.beginStage(0.35, 0.6);
        const std::vector<glm::vec3> normals = smoothNormals(reporter);
        reporter.beginStage(0.6, 0.75);
        // Over a triangle, normals are interpolated linearly; the divergence of each corner's part
        // is its normal times the gradient of its weight, which is across the opposite edge.
        surface.forEach(reporter, [&](const Triangle &triangle) {
            double bend = 0.0;
            for (std::size_t k = 0; k < 3; ++k) {
                const glm::dvec3 edge = triangle.at[(k + 2) % 3] - triangle.at[(k + 1) % 3];
                bend += 0.25 * glm::dot(glm::dvec3(normals[triangle.corners[k]]), glm::cross(triangle.normal, edge));
            }
            for (const std::uint32_t corner : triangle.corners)
                m_clusters[m_ofPlaces[corner]].bend += bend / 3.0;
        });
    }

    std::vector<float> curvatures(base::Reporter &reporter) const
    {
        std::vector<float> values(m_surface.placeCount());
        reporter.beginStage(0.75, 1.0);
        forEachPlace(reporter, [&](std::size_t place) {
            double bend = 0.0, area = 0.0;
            forEachWeight(place, [&](const Cluster &cluster, double weight) {
                bend += weight * cluster.bend;
                area += weight * cluster.area;
            });
            values[place] = area > 0.0 ? static_cast<float>(bend / area) : 0.0f;
        });
        return values;
    }

private:
    /// One of the six directions along the axes.
    static std::uint32_t directionOf(const glm::vec3 &normal)
    {
        const glm::vec3 size = glm::abs(normal);
        const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
        return static_cast<std::uint32_t>(normal[axis] < 0.0f ? axis + 3 : axis);
    }

    void gather(const PlaceSums &sums, double cell)
    {
        Numbering<std::array<std::uint32_t, 4>> known; // cells and directions
        for (std::size_t place = 0; place < m_ofPlaces.size(); ++place) {
            if (!(sums.areas[place] > 0.0f))
                continue; // of no triangle
            const glm::dvec3 at = m_surface.place(place);
            const auto cellAt = [&](int axis) {
                return static_cast<std::uint32_t>(static_cast<std::int64_t>(std::floor(at[axis] / cell)));
            };
            const std::uint32_t number = known.add({cellAt(0), cellAt(1), cellAt(2), directionOf(sums.normals[place])});
            if (number == m_clusters.size())
                m_clusters.emplace_back();
            m_ofPlaces[place] = number;
            Cluster &cluster = m_clusters[number];
            const double area = static_cast<double>(sums.areas[place]);
            cluster.center += area * at;
            cluster.normal += glm::dvec3(sums.normals[place]);
            cluster.area += area;
        }
        for (Cluster &cluster : m_clusters)
            cluster.center /= cluster.area;
    }

    void connect(base::Reporter &reporter)
    {
        std::vector<std::uint64_t> pairs; // both ways round
        m_surface.forEach(reporter, [&](const Triangle &triangle) {
            for (std::size_t k = 0; k < 3; ++k) {
                const std::uint64_t a = m_ofPlaces[triangle.corners[k]];
                const std::uint64_t b = m_ofPlaces[triangle.corners[(k + 1) % 3]];
                if (a != b)
                    pairs.insert(pairs.end(), {a << 32 | b, b << 32 | a});
            }
        });
        std::sort(pairs.begin(), pairs.end());
        pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
        std::vector<std::size_t> begins(m_clusters.size() + 1, 0);
        for (const std::uint64_t pair : pairs)
            ++begins[static_cast<std::size_t>(pair >> 32) + 1];
        for (std::size_t i = 1; i < begins.size(); ++i)
            begins[i] += begins[i - 1];
        // With the neighbours' neighbours, as far as a place of the cluster may reach.
        const double most = m_reach + std::sqrt(3.0) * m_reach / kReachCells;
        m_begins.assign(1, 0);
        std::vector<std::uint32_t> around;
        for (std::uint32_t own = 0; own < m_clusters.size(); ++own) {
            around.assign(1, own);
            for (std::size_t i = begins[own]; i < begins[own + 1]; ++i) {
                const auto next = static_cast<std::uint32_t>(pairs[i]);
                around.push_back(next);
                for (std::size_t k = begins[next]; k < begins[next + 1]; ++k)
                    around.push_back(static_cast<std::uint32_t>(pairs[k]));
            }
            std::sort(around.begin(), around.end());
            around.erase(std::unique(around.begin(), around.end()), around.end());
            for (const std::uint32_t number : around) {
                if (number != own && glm::distance(m_clusters[number].center, m_clusters[own].center) < most)
                    m_neighbors.push_back(number);
            }
            m_begins.push_back(m_neighbors.size());
        }
    }

    template <class Function>
    void forEachPlace(base::Reporter &reporter, const Function &function) const
    {
        base::inParallelRanges(m_surface.placeCount(), kPlacesAtOnce, reporter.part(),
                               [&](std::size_t begin, std::size_t end) {
                                   for (std::size_t place = begin; place < end; ++place)
                                       function(place);
                               });
    }

    /// Calls a function with the clusters around a place and their weights: its own, and the
    /// neighbours within reach.
    template <class Function>
    void forEachWeight(std::size_t place, const Function &function) const
    {
        if (m_clusters.empty())
            return;
        const glm::dvec3 at = m_surface.place(place);
        const auto add = [&](const Cluster &cluster, double least) {
            const glm::dvec3 way = at - cluster.center;
            const double rest = std::max(least, 1.0 - glm::dot(way, way) / (m_reach * m_reach));
            if (rest > 0.0)
                function(cluster, rest * rest);
        };
        const std::uint32_t own = m_ofPlaces[place];
        constexpr double kLeastOfOwn = 0.05; // in a corner of its cell, a place may be far from the middle
        add(m_clusters[own], kLeastOfOwn);
        for (std::size_t i = m_begins[own]; i < m_begins[own + 1]; ++i)
            add(m_clusters[m_neighbors[i]], 0.0);
    }

    std::vector<glm::vec3> smoothNormals(base::Reporter &reporter) const
    {
        std::vector<glm::vec3> normals(m_surface.placeCount());
        forEachPlace(reporter, [&](std::size_t place) {
            glm::dvec3 sum(0.0);
            forEachWeight(place, [&](const Cluster &cluster, double weight) { sum += weight * cluster.normal; });
            const double length = glm::length(sum);
            normals[place] = length > 0.0 ? glm::vec3(sum / length) : glm::vec3(0.0f);
        });
        return normals;
    }

    const Surface &m_surface;
    double m_reach;
    std::vector<std::uint32_t> m_ofPlaces; ///< the cluster of each place
    std::vector<Cluster> m_clusters;
    std::vector<std::size_t> m_begins; ///< of each cluster in the neighbours
    std::vector<std::uint32_t> m_neighbors;
};

/// The absolute value that a share of the surface stays below.
double quantile(const std::vector<float> &values, const std::vector<float> &areas, double share)
{
    constexpr std::size_t kMostSamples = 200'000;
    const std::size_t step = values.size() / kMostSamples + 1;
    std::vector<std::pair<float, float>> samples; // absolute value, area
    double all = 0.0;
    for (std::size_t place = 0; place < values.size(); place += step) {
        if (!(areas[place] > 0.0f))
            continue;
        samples.emplace_back(std::abs(values[place]), areas[place]);
        all += static_cast<double>(areas[place]);
    }
    std::sort(samples.begin(), samples.end());
    double below = 0.0;
    for (const auto &[value, area] : samples) {
        below += static_cast<double>(area);
        if (below >= share * all)
            return static_cast<double>(value);
    }
    return 0.0;
}

Curvature computed(const Model &model, base::Reporter &reporter)
{
    reporter.report(0.0);
    const Surface surface(model);
    reporter.beginStage(0.1, 0.2);
    const PlaceSums sums = placeSums(surface, reporter);
    Curvature curvature;
    std::vector<float> values(surface.placeCount());
    if (sums.radius > 0.0) {
        const double spacing = std::sqrt(sums.area / static_cast<double>(surface.placeCount()));
        const double cell = std::max(kCellOfRadius * sums.radius, kCellOfSpacing * spacing);
        values = Clusters(surface, sums, cell, reporter).curvatures(reporter);
        for (float &value : values)
            value = static_cast<float>(static_cast<double>(value) / surface.unit());
        curvature.usual = quantile(values, sums.areas, 0.9);
        curvature.smoothingDistance = kReachCells * cell * surface.unit();
    }
    for (std::size_t number = 0; number < model.meshes.size(); ++number) {
        const Mesh &mesh = model.meshes[number];
        std::vector<float> &ofMesh = curvature.meshes.emplace_back();
        if (mesh.kind != Mesh::Kind::Triangles)
            continue;
        ofMesh.resize(mesh.positions.size());
        for (std::size_t vertex = 0; vertex < ofMesh.size(); ++vertex)
            ofMesh[vertex] = values[surface.placeOf(number, vertex)];
    }
    return curvature;
}

} // namespace

Curvature curvatureOf(const Model &model, const base::Progress &progress)
try {
    base::Reporter reporter(progress);
    Curvature curvature = computed(model, reporter);
    reporter.beginStage(1.0, 1.0); // the other threads may have ended the work without a report
    return curvature;
} catch (const base::Stopped &) {
    return {};
}

} // namespace unprojector::mesh
