#pragma once

#include "core/ray/box_tree.h"
#include "core/ray/element_numbers.h"
#include "core/ray/large_pages.h"
#include "core/ray/nearest_triangle.h"
#include "core/ray/unit_space.h"

#include <glm/vec3.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace unprojector::ray {

/// The traversal of a model's packets by a ray: first filtered in single precision, then tested
/// exactly.
class PacketSearch {
public:
    /// @param model  outlives this
    PacketSearch(const mesh::Model &model, const UnitSpace &space, const UnitRay &unit, NearestTriangle &nearest);

    /// The length in unit space up to which boxes still matter.
    float length() const { return m_length; }

private:
    friend class TrianglePackets;
    static constexpr std::uint32_t kNone = 0xffffffffu;
    struct Waiting {
        std::uint32_t packet = kNone, mesh = 0;
    };
    void enter(std::uint32_t mesh);

    const mesh::Model &m_model;
    const UnitSpace &m_space;
    const UnitRay &m_unit;
    NearestTriangle &m_nearest;
    float m_length;
    std::size_t m_x, m_y, m_z; ///< the largest component of the ray's direction is along axis m_z
    float m_shearX, m_shearY;
    std::uint32_t m_mesh = 0;
    std::array<float, 3> m_from{};      ///< relative to the mesh's origin
    float m_margin = 0.0f;              ///< the error of single precision there
    std::array<Waiting, 2> m_waiting{}; ///< packets being fetched from memory, the earlier first
};

/// The leaves of a tree: a model's triangles in single precision, in packets of eight neighbours of
/// a mesh. A test of all eight at once selects the ones that a ray may hit; an exact test follows.
/// A triangle takes 40 bytes. In a mesh with remainders (see Mesh) it takes 36 more: a copy of its
/// corners' remainders, so that no test waits for the mesh's own arrays.
class TrianglePackets {
public:
    static constexpr std::size_t kSize = 8;

    /// @param numbers  of the model's triangles
    /// The model and the space outlive this.
    TrianglePackets(const mesh::Model &model, const ElementNumbers &numbers, const UnitSpace &space);

    std::uint32_t count() const { return static_cast<std::uint32_t>(m_packets.size()); }
    /// The box of a packet in unit space, widened by its margin.
    BoxTree::Box boxOf(std::uint32_t packet) const;
    /// The triangles of a packet; the last one repeats if there are fewer.
    const std::array<std::uint32_t, kSize> &trianglesOf(std::uint32_t packet) const
    {
        return m_packets[packet].numbers;
    }
    /// Queues a packet for testing. The queue holds two, because fetching one from memory takes as
    /// long as the tree takes to find the next ones.
    /// @return whether a triangle tested during this call is the nearest so far
    bool take(std::uint32_t packet, PacketSearch &search) const;
    /// Tests the queued packets, after the tree has found all.
    void finish(PacketSearch &search) const;

private:
    struct alignas(64) Packet {                                         // whole cache lines
        std::array<std::array<std::array<float, kSize>, 3>, 3> corners; ///< by axis, corner, triangle
        std::array<std::uint32_t, kSize> numbers;                       ///< the last one repeats if there are fewer
    };
    /// The remainders of a packet's corners. The three of one triangle are adjacent, because mostly
    /// one triangle is tested.
    using Remainders = std::array<std::array<glm::ivec3, 3>, kSize>;
    std::uint32_t meshOf(std::uint32_t packet) const;
    /// The remainders of a packet; null if the mesh has none.
    const Remainders *remaindersOf(const PacketSearch::Waiting &waiting) const
    {
        const auto &all = m_remainders[waiting.mesh];
        return all.empty() ? nullptr : &all[waiting.packet - m_starts[waiting.mesh]];
    }
    bool test(const PacketSearch::Waiting &waiting, PacketSearch &search) const;

    const mesh::Model &m_model;
    const UnitSpace &m_space;
    std::vector<Packet, InLargePages<Packet>> m_packets;
    std::vector<std::vector<Remainders, InLargePages<Remainders>>> m_remainders; ///< of each mesh, packet by packet
    std::vector<std::uint32_t> m_starts;                                         ///< of each mesh: its first packet
};

} // namespace unprojector::ray
