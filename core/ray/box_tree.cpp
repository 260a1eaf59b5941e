#include "core/ray/box_tree.h"

#include "core/base/parallel.h"

#include <glm/common.hpp>

#include <algorithm>
#include <atomic>
#include <cassert>
#include <numeric>
#include <span>

namespace unprojector::ray {
namespace {

struct Bounds {
    glm::vec3 lowest{std::numeric_limits<float>::infinity()};
    glm::vec3 highest{-std::numeric_limits<float>::infinity()};

    void add(const glm::vec3 &low, const glm::vec3 &high)
    {
        lowest = glm::min(lowest, low);
        highest = glm::max(highest, high);
    }
    /// Half of the surface area.
    float area() const
    {
        const glm::vec3 size = glm::max(highest - lowest, glm::vec3(0.0f));
        return size.x * size.y + size.y * size.z + size.z * size.x;
    }
};

struct Bin {
    Bounds bounds;
    std::size_t count = 0;

    void add(const Bin &other)
    {
        bounds.add(other.bounds.lowest, other.bounds.highest);
        count += other.count;
    }
};

constexpr std::size_t kBins = 16;
/// The depth from which parts are simply halved, so that no arrangement of boxes makes the tree too
/// deep to search.
constexpr std::size_t kLevelsByArea = 60;

/// A box and its index.
struct Item {
    glm::vec3 lowest;
    std::uint32_t number;
    glm::vec3 highest;
};

glm::vec3 twiceMiddle(const Item &item)
{
    return item.lowest + item.highest;
}

} // namespace

class BoxTree::Builder {
public:
    Builder(const std::vector<Box> &boxes, std::size_t mostInLeaf, const Progress &progress)
        : m_mostInLeaf(mostInLeaf), m_progress(progress)
    {
        m_items.reserve(boxes.size());
        for (const Box &box : boxes)
            m_items.push_back({box.lowest, static_cast<std::uint32_t>(m_items.size()), box.highest});
    }

    BoxTree build()
    {
        if (m_items.empty())
            return {};
        m_tree.m_nodes.resize(1);
        // Builds the upper levels here, and the parts below them on all cores.
        const std::size_t enough = std::max<std::size_t>(4096, m_items.size() / (8 * base::coreCount()));
        grow(m_tree.m_nodes, {0, 0, m_items.size(), 0}, enough);
        m_branches.resize(m_parts.size());
        base::inParallel(m_parts.size(), {}, [this](std::size_t i) {
            Part part = m_parts[i];
            part.node = 0;
            m_branches[i].resize(1);
            grow(m_branches[i], part, 0);
        });
        graft();
        m_tree.m_numbers.reserve(m_items.size());
        for (const Item &item : m_items)
            m_tree.m_numbers.push_back(item.number);
        return std::move(m_tree);
    }

private:
    /// The items of a node.
    struct Part {
        std::uint32_t node;
        std::size_t first, end;
        std::size_t level;

        std::size_t count() const { return end - first; }
    };
    struct Split {
        int axis = -1; ///< none
        float position = 0.0f;
    };

    std::span<Item> itemsOf(const Part &part) { return {m_items.data() + part.first, part.count()}; }

    /// Grows the tree below a node.
    /// @param enough  parts of this size are left to other tasks
    void grow(std::vector<Node> &nodes, const Part &root, std::size_t enough)
    {
        std::vector<Part> open{root};
        while (!open.empty()) {
            const Part part = open.back();
            open.pop_back();
            if (enough > 0 && part.count() <= enough) {
                m_parts.push_back(part);
                continue;
            }
            Bounds bounds, middles;
            for (const Item &item : itemsOf(part)) {
                bounds.add(item.lowest, item.highest);
                middles.add(twiceMiddle(item), twiceMiddle(item));
            }
            nodes[part.node].lowest = bounds.lowest;
            nodes[part.node].highest = bounds.highest;
            if (part.count() <= m_mostInLeaf) {
                nodes[part.node].first = static_cast<std::uint32_t>(part.first);
                nodes[part.node].count = static_cast<std::uint32_t>(part.count());
                advance(part.count());
                continue;
            }
            const std::size_t middle = divide(part, middles);
            const auto child = static_cast<std::uint32_t>(nodes.size());
            nodes[part.node].first = child;
            nodes[part.node].count = 0;
            nodes.resize(nodes.size() + 2);
            open.push_back({child + 1, middle, part.end, part.level + 1});
            open.push_back({child, part.first, middle, part.level + 1});
        }
    }

    /// Partitions the items into two halves.
    /// @return where the second half begins within the part
    std::size_t divide(const Part &part, const Bounds &middles)
    {
        const std::span<Item> items = itemsOf(part);
        if (part.level < kLevelsByArea) {
            const Split split = bestSplit(items, middles);
            if (split.axis >= 0) {
                const auto middle = std::partition(items.begin(), items.end(), [&](const Item &item) {
                    return twiceMiddle(item)[split.axis] < split.position;
                });
                if (middle != items.begin() && middle != items.end())
                    return part.first + static_cast<std::size_t>(middle - items.begin());
            }
        }
        const glm::vec3 size = middles.highest - middles.lowest;
        const int axis = size.x > size.y ? (size.x > size.z ? 0 : 2) : (size.y > size.z ? 1 : 2);
        const auto half = static_cast<std::ptrdiff_t>(items.size() / 2);
        std::nth_element(items.begin(), items.begin() + half, items.end(),
                         [axis](const Item &a, const Item &b) { return twiceMiddle(a)[axis] < twiceMiddle(b)[axis]; });
        return part.first + static_cast<std::size_t>(half);
    }

    /// The plane between bins with the minimum sum over both halves of area times count.
    static Split bestSplit(std::span<const Item> items, const Bounds &middles)
    {
        const glm::vec3 size = middles.highest - middles.lowest;
        std::array<std::array<Bin, kBins>, 3> bins;
        const glm::vec3 perUnit = float(kBins) * (1.0f - 1e-6f) / glm::max(size, glm::vec3(1e-30f));
        for (const Item &item : items) {
            const glm::vec3 place = (twiceMiddle(item) - middles.lowest) * perUnit;
            for (int axis = 0; axis < 3; ++axis) {
                Bin &bin = bins[std::size_t(axis)][std::min(static_cast<std::size_t>(place[axis]), kBins - 1)];
                bin.bounds.add(item.lowest, item.highest);
                ++bin.count;
            }
        }
        Split best;
        float least = std::numeric_limits<float>::infinity();
        for (int axis = 0; axis < 3; ++axis) {
            if (!(size[axis] > 0.0f))
                continue;
            const std::array<Bin, kBins> &row = bins[std::size_t(axis)];
            std::array<float, kBins> above{};
            Bin sum;
            for (std::size_t k = kBins - 1; k > 0; --k) {
                sum.add(row[k]);
                above[k] = sum.count == 0 ? 0.0f : sum.bounds.area() * static_cast<float>(sum.count);
            }
            sum = {};
            for (std::size_t k = 1; k < kBins; ++k) {
                sum.add(row[k - 1]);
                if (sum.count == 0 || sum.count == items.size())
                    continue;
                const float cost = sum.bounds.area() * static_cast<float>(sum.count) + above[k];
                if (cost < least) {
                    least = cost;
                    best = {axis, middles.lowest[axis] + static_cast<float>(k) / perUnit[axis]};
                }
            }
        }
        return best;
    }

    /// Inserts the branches into their reserved nodes.
    void graft()
    {
        std::vector<Node> &nodes = m_tree.m_nodes;
        std::size_t count = nodes.size();
        for (const auto &branch : m_branches)
            count += branch.size() - 1;
        nodes.reserve(count);
        for (std::size_t i = 0; i < m_branches.size(); ++i) {
            // The branch's root takes the reserved node; its node k gets the index shift + k.
            const auto shift = static_cast<std::uint32_t>(nodes.size()) - 1;
            for (Node &node : m_branches[i])
                node.first += node.count == 0 ? shift : 0;
            nodes[m_parts[i].node] = m_branches[i].front();
            nodes.insert(nodes.end(), m_branches[i].begin() + 1, m_branches[i].end());
            m_branches[i] = {};
        }
    }

    void advance(std::size_t count)
    {
        constexpr std::size_t kSteps = 100;
        const std::size_t before = m_done.fetch_add(count), after = before + count;
        if (before * kSteps / m_items.size() != after * kSteps / m_items.size()
            && !m_progress.report(static_cast<double>(after) / static_cast<double>(m_items.size())))
            throw base::Stopped{};
    }

    std::vector<Item> m_items;
    const std::size_t m_mostInLeaf;
    SharedProgress m_progress;
    BoxTree m_tree;
    std::vector<Part> m_parts;                 ///< left to other tasks, with their nodes in the tree
    std::vector<std::vector<Node>> m_branches; ///< of each part, with the root first
    std::atomic<std::size_t> m_done = 0;
};

BoxTree BoxTree::build(const std::vector<Box> &boxes, std::size_t mostInLeaf, const Progress &progress)
{
    return Builder(boxes, mostInLeaf, progress).build();
}

} // namespace unprojector::ray
