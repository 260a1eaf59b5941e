// A* from point to point on the edges: finds the strip of triangles with which a geodesic starts.

#include "core/curves/triangle_strip.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <functional>
#include <limits>
#include <optional>
#include <queue>
#include <unordered_map>
#include <utility>

namespace unprojector::curves {

namespace {

constexpr std::uint32_t kNone = SurfaceMesh::kNone;

class Search {
public:
    Search(const PlacedMesh &mesh, const PathEnd &from, const PathEnd &to, const Report &report,
           const Corridor *corridor)
        : m_mesh(mesh), m_from(from), m_to(to), m_report(report), m_corridor(corridor)
    {
    }

    std::optional<TriangleStrip> run(std::size_t mostEdges)
    {
        for (const std::uint32_t triangle : m_from.triangles()) {
            if (m_to.isIn(triangle))
                return TriangleStrip{{triangle}, {}};
        }
        for (const std::uint32_t triangle : m_from.triangles())
            enter(triangle, kNone, m_from.place(), 0.0);
        for (std::size_t steps = 0; !m_open.empty(); ++steps) {
            if (steps % kStepsBetweenReports == 0)
                m_report(m_share);
            if (m_edges.size() > mostEdges)
                return std::nullopt;
            const std::uint32_t number = m_open.top().second;
            m_open.pop();
            if (number == kNone)
                return traced();
            Node &node = m_nodes[number];
            if (std::exchange(node.isDone, true))
                continue;
            const Node from = node; // a copy, because adding nodes moves them
            const TriangleStrip::Edge edge = m_edges[number / kPlaces];
            const glm::dvec3 place = placeOf(number);
            m_share = std::max(m_share, from.cost / (from.cost + glm::distance(place, m_to.place())));
            m_mesh->across(from.via, edge[0], edge[1],
                           [&](std::uint32_t triangle) { enter(triangle, number, place, from.cost); });
        }
        throw NotConnected{};
    }

private:
    static constexpr std::uint32_t kPlaces = 3; ///< per edge
    static constexpr std::size_t kStepsBetweenReports = 1 << 10;

    struct Node {
        double cost = std::numeric_limits<double>::infinity();
        std::uint32_t parent = kNone; ///< none: the start
        std::uint32_t via = kNone;    ///< the triangle that the step from the parent crosses
        bool isDone = false;
    };

    glm::dvec3 placeOf(std::uint32_t number) const
    {
        const TriangleStrip::Edge &edge = m_edges[number / kPlaces];
        return between(m_mesh[edge[0]], m_mesh[edge[1]], number % kPlaces);
    }
    static glm::dvec3 between(const glm::dvec3 &a, const glm::dvec3 &b, std::uint32_t i)
    {
        const double share = double(i + 1) / double(kPlaces + 1);
        return (1.0 - share) * a + share * b;
    }

    std::uint32_t firstOf(std::uint32_t a, std::uint32_t b)
    {
        const TriangleStrip::Edge edge{std::min(a, b), std::max(a, b)};
        const auto [found, isNew] =
            m_numbers.try_emplace((std::uint64_t{edge[0]} << 32) | edge[1], static_cast<std::uint32_t>(m_edges.size()));
        if (isNew) {
            m_edges.push_back(edge);
            m_nodes.resize(m_nodes.size() + kPlaces);
        }
        return kPlaces * found->second;
    }

    /// Relaxes the neighbours in a triangle, from a point of its boundary or inside.
    void enter(std::uint32_t triangle, std::uint32_t parent, const glm::dvec3 &place, double cost)
    {
        if (m_corridor && !std::binary_search(m_corridor->begin(), m_corridor->end(), triangle))
            return;
        if (m_to.isIn(triangle)) {
            const double whole = cost + glm::distance(place, m_to.place());
            if (whole < m_end.cost) {
                m_end = {whole, parent, triangle, false};
                m_open.emplace(whole, kNone);
            }
        }
        const std::array<std::uint32_t, 3> &corners = m_mesh->corners(triangle);
        const std::array places{m_mesh[corners[0]], m_mesh[corners[1]], m_mesh[corners[2]]};
        for (std::size_t side = 0; side < 3; ++side) {
            const std::size_t next = (side + 1) % 3;
            const std::uint32_t first = firstOf(corners[side], corners[next]);
            if (parent != kNone && first == parent - parent % kPlaces)
                continue;
            const bool isAscending = corners[side] < corners[next];
            for (std::uint32_t i = 0; i < kPlaces; ++i) {
                const glm::dvec3 there =
                    between(places[isAscending ? side : next], places[isAscending ? next : side], i);
                const double sum = cost + glm::distance(place, there);
                Node &node = m_nodes[first + i];
                if (node.isDone || !(sum < node.cost))
                    continue;
                node = {sum, parent, triangle, false};
                m_open.emplace(sum + glm::distance(there, m_to.place()), first + i);
            }
        }
    }

    TriangleStrip traced() const
    {
        TriangleStrip strip;
        strip.triangles.push_back(m_end.via);
        for (std::uint32_t number = m_end.parent; number != kNone; number = m_nodes[number].parent) {
            strip.edges.push_back(m_edges[number / kPlaces]);
            strip.triangles.push_back(m_nodes[number].via);
        }
        std::reverse(strip.triangles.begin(), strip.triangles.end());
        std::reverse(strip.edges.begin(), strip.edges.end());
        return strip;
    }

    const PlacedMesh &m_mesh;
    const PathEnd &m_from, &m_to;
    const Report &m_report;
    const Corridor *m_corridor; ///< null: the whole surface
    double m_share = 0.0;       ///< done, if only the goal's distance in a straight line were left
    std::vector<Node> m_nodes;  ///< kPlaces per edge
    std::vector<TriangleStrip::Edge> m_edges;
    std::unordered_map<std::uint64_t, std::uint32_t> m_numbers; ///< edge indices
    Node m_end;
    using Open = std::pair<double, std::uint32_t>; ///< lower bound of a whole path through the node; kNone: the end
    std::priority_queue<Open, std::vector<Open>, std::greater<>> m_open;
};

} // namespace

std::optional<TriangleStrip> stripBetween(const PlacedMesh &mesh, const PathEnd &from, const PathEnd &to,
                                          const Report &report, const Corridor *corridor, std::size_t mostEdges)
{
    return Search(mesh, from, to, report, corridor).run(mostEdges);
}

} // namespace unprojector::curves
