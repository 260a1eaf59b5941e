#include "core/ray/triangle_packets.h"

#include "core/base/parallel.h"
#include "core/ray/place_order.h"

#include <glm/common.hpp>

#if defined(__x86_64__) || defined(_M_X64)
#include <xmmintrin.h>
#endif

#include <algorithm>
#include <cmath>

namespace unprojector::ray {
using namespace mesh;

namespace {

/// Prefetches a value into the cache, on processors where this is implemented.
template <class T>
void prefetch([[maybe_unused]] const T &value)
{
#if defined(__x86_64__) || defined(_M_X64)
    constexpr std::size_t kCacheLine = 64;
    const char *bytes = reinterpret_cast<const char *>(&value);
    for (std::size_t i = 0; i < sizeof(T); i += kCacheLine)
        _mm_prefetch(bytes + i, _MM_HINT_T0);
#endif
}

} // namespace

PacketSearch::PacketSearch(const Model &model, const UnitSpace &space, const UnitRay &unit, NearestTriangle &nearest)
    : m_model(model), m_space(space), m_unit(unit), m_nearest(nearest), m_length(unit.length)
{
    const glm::vec3 size = glm::abs(unit.along);
    m_z = size.x > size.y ? (size.x > size.z ? 0 : 2) : (size.y > size.z ? 1 : 2);
    m_x = (m_z + 1) % 3;
    m_y = (m_z + 2) % 3;
    const auto along = [&unit](std::size_t axis) { return unit.along[static_cast<int>(axis)]; };
    m_shearX = along(m_x) / along(m_z);
    m_shearY = along(m_y) / along(m_z);
    enter(0);
}

void PacketSearch::enter(std::uint32_t mesh)
{
    m_mesh = mesh;
    const glm::dvec3 from = (m_space.center() - m_model.meshes[mesh].origin) + glm::dvec3(m_unit.from) * m_space.size();
    const glm::dvec3 size = glm::abs(from);
    m_from = {static_cast<float>(from.x), static_cast<float>(from.y), static_cast<float>(from.z)};
    m_margin =
        static_cast<float>(double(UnitSpace::kMargin) * m_space.size() + 0x1p-22 * std::max({size.x, size.y, size.z}));
}

TrianglePackets::TrianglePackets(const Model &model, const ElementNumbers &numbers, const UnitSpace &space)
    : m_model(model), m_space(space)
{
    for (std::uint32_t number = 0; number < model.meshes.size(); ++number) {
        const Mesh &mesh = model.meshes[number];
        const auto corner = [&mesh](std::size_t triangle, std::size_t k) -> const glm::vec3 & {
            return mesh.positions[mesh.vertexAt(3 * triangle + k)];
        };
        const std::size_t start = m_packets.size();
        m_starts.push_back(static_cast<std::uint32_t>(start));
        const std::vector<std::uint32_t> order =
            placeOrder(static_cast<std::uint32_t>(mesh.triangleCount()), kSize, [&](std::uint32_t triangle) {
                const glm::vec3 &a = corner(triangle, 0), &b = corner(triangle, 1), &c = corner(triangle, 2);
                return space.at(mesh.origin, glm::max(glm::max(a, b), c) * 0.5f + glm::min(glm::min(a, b), c) * 0.5f);
            });
        m_packets.resize(start + (order.size() + kSize - 1) / kSize);
        constexpr std::size_t kPacketsInTask = 1 << 11;
        const std::size_t count = m_packets.size() - start;
        auto &remainders = m_remainders.emplace_back(mesh.remainders.empty() ? 0 : count);
        base::inParallelRanges(count, kPacketsInTask, {}, [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) {
                Packet &packet = m_packets[start + i];
                for (std::size_t k = 0; k < kSize; ++k) {
                    const std::uint32_t triangle = order[std::min(kSize * i + k, order.size() - 1)];
                    packet.numbers[k] = numbers.of(number, triangle);
                    for (std::size_t c = 0; c < 3; ++c) {
                        for (std::size_t axis = 0; axis < 3; ++axis)
                            packet.corners[axis][c][k] = corner(triangle, c)[static_cast<int>(axis)];
                        if (!remainders.empty())
                            remainders[i][k][c] = mesh.remainders[mesh.vertexAt(std::size_t{3} * triangle + c)];
                    }
                }
            }
        });
    }
}

std::uint32_t TrianglePackets::meshOf(std::uint32_t packet) const
{
    if (m_starts.size() == 1)
        return 0;
    const auto after = std::upper_bound(m_starts.begin(), m_starts.end(), packet);
    return static_cast<std::uint32_t>(after - m_starts.begin()) - 1;
}

BoxTree::Box TrianglePackets::boxOf(std::uint32_t packet) const
{
    glm::vec3 lowest(0.0f), highest(0.0f);
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto &c = m_packets[packet].corners[axis];
        float low = c[0][0], high = c[0][0];
        for (const auto &corner : c) {
            for (const float value : corner) {
                low = std::min(low, value);
                high = std::max(high, value);
            }
        }
        lowest[static_cast<int>(axis)] = low;
        highest[static_cast<int>(axis)] = high;
    }
    const glm::dvec3 &origin = m_model.meshes[meshOf(packet)].origin;
    return {m_space.at(origin, lowest) - UnitSpace::kMargin, m_space.at(origin, highest) + UnitSpace::kMargin};
}

bool TrianglePackets::take(std::uint32_t packet, PacketSearch &search) const
{
    const PacketSearch::Waiting taken{packet, meshOf(packet)};
    prefetch(m_packets[packet]);
    if (const Remainders *remainders = remaindersOf(taken))
        prefetch(*remainders);
    const PacketSearch::Waiting next = search.m_waiting[0];
    search.m_waiting = {search.m_waiting[1], taken};
    return next.packet != PacketSearch::kNone && test(next, search);
}

void TrianglePackets::finish(PacketSearch &search) const
{
    for (PacketSearch::Waiting &waiting : search.m_waiting) {
        if (waiting.packet != PacketSearch::kNone)
            test(waiting, search);
        waiting = {};
    }
}

bool TrianglePackets::test(const PacketSearch::Waiting &waiting, PacketSearch &search) const
{
    const std::uint32_t mesh = waiting.mesh;
    if (mesh != search.m_mesh)
        search.enter(mesh);
    // The test of LineCrossing, but an edge within the margin of the ray counts as passed on either
    // side.
    using Lanes = std::array<float, kSize>;
    const Packet &p = m_packets[waiting.packet];
    const float fromX = search.m_from[search.m_x], fromY = search.m_from[search.m_y], fromZ = search.m_from[search.m_z];
    const float shearX = search.m_shearX, shearY = search.m_shearY, margin = search.m_margin;
    std::array<Lanes, 3> x, y;
    for (std::size_t corner = 0; corner < 3; ++corner) {
        const Lanes &cx = p.corners[search.m_x][corner], &cy = p.corners[search.m_y][corner],
                    &cz = p.corners[search.m_z][corner];
        for (std::size_t k = 0; k < kSize; ++k) {
            const float z = cz[k] - fromZ;
            x[corner][k] = (cx[k] - fromX) - shearX * z;
            y[corner][k] = (cy[k] - fromY) - shearY * z;
        }
    }
    std::array<int, kSize> isMissed;
    for (std::size_t k = 0; k < kSize; ++k) {
        const float u = x[2][k] * y[1][k] - y[2][k] * x[1][k];
        const float v = x[0][k] * y[2][k] - y[0][k] * x[2][k];
        const float w = x[1][k] * y[0][k] - y[1][k] * x[0][k];
        const float reach = std::abs(x[0][k]) + std::abs(y[0][k]) + std::abs(x[1][k]) + std::abs(y[1][k])
                            + std::abs(x[2][k]) + std::abs(y[2][k]);
        const float unsure = margin * (2.0f * reach + margin);
        const float most = std::max(std::max(u, v), w), least = std::min(std::min(u, v), w);
        isMissed[k] = static_cast<int>(most > unsure) & static_cast<int>(least < -unsure);
    }
    const Remainders *remainders = remaindersOf(waiting);
    bool isNearer = false;
    for (std::size_t k = 0; k < kSize; ++k) {
        if (isMissed[k] != 0)
            continue;
        const auto corner = [&](std::size_t c) {
            const glm::vec3 rounded(p.corners[0][c][k], p.corners[1][c][k], p.corners[2][c][k]);
            if (remainders == nullptr)
                return glm::dvec3(rounded);
            const glm::ivec3 &r = (*remainders)[k][c];
            return glm::dvec3(withRemainder(rounded.x, r.x), withRemainder(rounded.y, r.y),
                              withRemainder(rounded.z, r.z));
        };
        isNearer = search.m_nearest.test(mesh, p.numbers[k], {corner(0), corner(1), corner(2)}) || isNearer;
    }
    if (isNearer)
        search.m_length = search.m_unit.lengthTo(search.m_nearest.high());
    return isNearer;
}

} // namespace unprojector::ray
