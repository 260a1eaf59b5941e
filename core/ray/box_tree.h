#pragma once

#include "core/base/progress.h"

#include <glm/vec3.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <mutex>
#include <vector>

namespace unprojector::ray {

using base::Progress;

/// Passes on progress that comes from several threads at once, in steps.
class SharedProgress {
public:
    /// @param step  the least increase of the share that is passed on; the end always is
    explicit SharedProgress(const Progress &progress, double step = 0.0) : m_progress(progress), m_step(step) {}

    /// @return whether the work goes on
    bool report(double share)
    {
        const std::lock_guard lock(m_mutex);
        share = std::min(share, 1.0);
        const bool isEnd = share == 1.0 && m_reported < 1.0;
        if (m_progress && !m_isStopped && (isEnd || share >= m_reported + m_step)) {
            m_reported = share;
            m_isStopped = !m_progress(m_reported);
        }
        return !m_isStopped;
    }
    bool isStopped() const { return m_isStopped; }

private:
    const Progress &m_progress;
    const double m_step;
    std::mutex m_mutex;
    double m_reported = -1.0;
    bool m_isStopped = false;
};

/// A bounding volume hierarchy: a binary tree of boxes by the surface area heuristic, built on all
/// cores. It is plain C++, for queries that Embree lacks and for builds without Embree.
class BoxTree {
public:
    struct Box {
        glm::vec3 lowest, highest;
    };

    /// @param boxes  finite
    /// @param mostInLeaf  at least 1
    /// Throws base::Stopped.
    static BoxTree build(const std::vector<Box> &boxes, std::size_t mostInLeaf, const Progress &progress);

    /// Calls `visit` with the indices of the input boxes, nearest first.
    /// @param entry  where a box (lowest, highest) begins, in any measure; infinity: the box is
    ///         skipped
    /// @param limit  boxes that begin beyond this measure are skipped; called again and again
    template <class Entry, class Limit, class Visit>
    void search(const Entry &entry, const Limit &limit, const Visit &visit) const;

private:
    /// A node. Two siblings are adjacent.
    struct Node {
        glm::vec3 lowest;
        std::uint32_t first; ///< the first child, or index into m_numbers
        glm::vec3 highest;
        std::uint32_t count; ///< the number of boxes in a leaf; 0: an inner node
    };
    class Builder;
    static constexpr std::size_t kMostLevels = 96;

    std::vector<Node> m_nodes;
    std::vector<std::uint32_t> m_numbers; ///< leaf by leaf
};

template <class Entry, class Limit, class Visit>
void BoxTree::search(const Entry &entry, const Limit &limit, const Visit &visit) const
{
    struct Waiting {
        std::uint32_t node;
        float begin;
    };
    std::array<Waiting, kMostLevels> waiting;
    std::size_t depth = 0;
    if (m_nodes.empty())
        return;
    constexpr float kNever = std::numeric_limits<float>::infinity();
    Waiting next{0, entry(m_nodes[0].lowest, m_nodes[0].highest)};
    for (;;) {
        if (next.begin < kNever && next.begin <= limit()) {
            const Node &node = m_nodes[next.node];
            if (node.count == 0) {
                const Node &a = m_nodes[node.first], &b = m_nodes[node.first + 1];
                const Waiting one{node.first, entry(a.lowest, a.highest)};
                const Waiting other{node.first + 1, entry(b.lowest, b.highest)};
                const bool isInOrder = one.begin <= other.begin;
                waiting[depth++] = isInOrder ? other : one;
                next = isInOrder ? one : other;
                continue;
            }
            for (std::uint32_t i = 0; i < node.count; ++i)
                visit(m_numbers[node.first + i]);
        }
        if (depth == 0)
            return;
        next = waiting[--depth];
    }
}

} // namespace unprojector::ray
