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

/// A ray's way through a model's packets: first seen in single precision, then met exactly.
class PacketSearch {
public:
    /// @param model  outlives this
    PacketSearch(const mesh::Model &model, const UnitSpace &space, const UnitRay &unit, NearestTriangle &nearest);

    /// How far in unit space something may begin that is of interest yet.
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
    std::size_t m_x, m_y, m_z; ///< the ray goes farthest along axis m_z
    float m_shearX, m_shearY;
    std::uint32_t m_mesh = 0;
    std::array<float, 3> m_from{};      ///< relative to the mesh's origin
    float m_margin = 0.0f;              ///< what single precision may be off there
    std::array<Waiting, 2> m_waiting{}; ///< packets on their way from memory, the earlier first
};

/// A model's triangles, eight neighbours of a mesh together, in single precision: what a tree has for leaves. With all eight
/// at once it is seen which of them a ray may meet; that is then tested exactly. A triangle takes 40 bytes. In a mesh with
/// remainders (see Mesh) it takes 36 more: a copy of its corners' remainders, so that no test waits for the mesh's own arrays.
class TrianglePackets {
public:
    static constexpr std::size_t kSize = 8;

    /// @param numbers  of the model's triangles
    /// The model and the space outlive this.
    TrianglePackets(const mesh::Model &model, const ElementNumbers &numbers, const UnitSpace &space);

    std::uint32_t count() const { return static_cast<std::uint32_t>(m_packets.size()); }
    /// The box of a packet in unit space, widened by its margin.
    BoxTree::Box boxOf(std::uint32_t packet) const;
    /// Its triangles, the last one again where there are fewer.
    const std::array<std::uint32_t, kSize> &trianglesOf(std::uint32_t packet) const
    {
        return m_packets[packet].numbers;
    }
    /// Has a packet tested. It takes as long to come from memory as the tree takes to name the next ones, so it waits for two of them.
    /// @return whether a triangle of those tested meanwhile is the nearest so far
    bool take(std::uint32_t packet, PacketSearch &search) const;
    /// Tests those that wait, when the tree has named all.
    void finish(PacketSearch &search) const;

private:
    struct alignas(64) Packet {                                         // whole lines of the cache
        std::array<std::array<std::array<float, kSize>, 3>, 3> corners; ///< by axis, corner, triangle
        std::array<std::uint32_t, kSize> numbers;                       ///< the last one again, where there are fewer
    };
    /// The remainders of a packet's corners. Those of one triangle lie together, because mostly one is asked for.
    using Remainders = std::array<std::array<glm::ivec3, 3>, kSize>;
    std::uint32_t meshOf(std::uint32_t packet) const;
    /// Null where the mesh has no remainders.
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
    std::vector<std::uint32_t> m_starts;                                         ///< of each mesh, its first packet
};

} // namespace unprojector::ray
