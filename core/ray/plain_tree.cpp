// The tree without Embree.

#include "core/ray/triangle_tree.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace unprojector::ray {
namespace {

class PlainTree : public TriangleTree {
public:
    PlainTree(const TrianglePackets &packets, BoxTree tree) : m_packets(packets), m_tree(std::move(tree)) {}

    void search(const UnitRay &ray, PacketSearch &search) const override
    {
        // Avoids infinities: for a line in the plane of a box's side they would make NaN.
        glm::vec3 inverse;
        for (int axis = 0; axis < 3; ++axis) {
            constexpr float kLeast = 1e-18f;
            const float along = ray.along[axis];
            inverse[axis] = 1.0f / (std::abs(along) < kLeast ? std::copysign(kLeast, along) : along);
        }
        const auto entry = [&](const glm::vec3 &lowest, const glm::vec3 &highest) {
            const glm::vec3 one = (lowest - ray.from) * inverse, other = (highest - ray.from) * inverse;
            const glm::vec3 begin = glm::min(one, other), end = glm::max(one, other);
            const float first = std::max({begin.x, begin.y, begin.z, -UnitSpace::kMargin});
            const float last = std::min({end.x, end.y, end.z, search.length()});
            return first <= last ? first : std::numeric_limits<float>::infinity();
        };
        m_tree.search(
            entry, [&] { return search.length(); },
            [&](std::uint32_t packet) { static_cast<void>(m_packets.take(packet, search)); });
        m_packets.finish(search);
    }

    void within(const Ball &ball, const std::function<void(std::uint32_t)> &visit) const override
    {
        const auto entry = [&ball](const glm::vec3 &lowest, const glm::vec3 &highest) {
            const glm::vec3 off = ball.center - glm::clamp(ball.center, lowest, highest);
            return glm::dot(off, off) <= ball.radius * ball.radius ? 0.0f : std::numeric_limits<float>::infinity();
        };
        m_tree.search(
            entry, [] { return std::numeric_limits<float>::max(); }, visit);
    }

private:
    const TrianglePackets &m_packets;
    BoxTree m_tree;
};

} // namespace

std::unique_ptr<const TriangleTree> plainTriangleTree(const TrianglePackets &packets, const Progress &progress)
{
    std::vector<BoxTree::Box> boxes;
    boxes.reserve(packets.count());
    for (std::uint32_t packet = 0; packet < packets.count(); ++packet)
        boxes.push_back(packets.boxOf(packet));
    return std::make_unique<const PlainTree>(packets, BoxTree::build(boxes, 1, progress));
}

} // namespace unprojector::ray
