#include "core/ray/place_order.h"

#include "core/base/parallel.h"

#include <glm/common.hpp>

#include <algorithm>
#include <array>
#include <limits>
#include <span>
#include <utility>

namespace unprojector::ray {
namespace {

struct Keyed {
    std::uint32_t key;
    std::uint32_t number;
};

constexpr int kBits = 10; ///< per axis
constexpr std::size_t kCrowd = 64;
constexpr int kMostLevels = 8;

/// Inserts two zeros between the lowest ten bits.
std::uint32_t spread(std::uint32_t bits)
{
    bits = (bits | (bits << 16)) & 0x030000FFu;
    bits = (bits | (bits << 8)) & 0x0300F00Fu;
    bits = (bits | (bits << 4)) & 0x030C30C3u;
    return (bits | (bits << 2)) & 0x09249249u;
}

/// @param place  in [0, 1]^3
std::uint32_t keyOf(const glm::vec3 &place)
{
    constexpr float kSteps = float(1 << kBits);
    const glm::vec3 step = glm::clamp(place * kSteps, 0.0f, kSteps - 1.0f);
    return (spread(static_cast<std::uint32_t>(step.z)) << 2) | (spread(static_cast<std::uint32_t>(step.y)) << 1)
           | spread(static_cast<std::uint32_t>(step.x));
}

/// A stable radix sort by key, from the lowest digit.
void sortByKey(std::vector<Keyed> &all)
{
    constexpr std::uint32_t kDigit = 10, kValues = 1u << kDigit;
    std::vector<Keyed> sorted(all.size());
    for (std::uint32_t shift = 0; shift < 3 * kBits; shift += kDigit) {
        std::array<std::size_t, kValues> starts{};
        for (const Keyed &one : all)
            ++starts[(one.key >> shift) % kValues];
        std::size_t start = 0;
        for (std::size_t &count : starts)
            start += std::exchange(count, start);
        for (const Keyed &one : all)
            sorted[starts[(one.key >> shift) % kValues]++] = one;
        all.swap(sorted);
    }
}

void sortCrowd(std::span<Keyed> crowd, const std::function<glm::vec3(std::uint32_t)> &place, int level)
{
    glm::vec3 lowest(std::numeric_limits<float>::infinity()), highest(-lowest);
    for (const Keyed &one : crowd) {
        const glm::vec3 p = place(one.number);
        lowest = glm::min(lowest, p);
        highest = glm::max(highest, p);
    }
    const glm::vec3 size = highest - lowest;
    const float widest = std::max({size.x, size.y, size.z});
    if (!(widest > 0.0f))
        return;
    for (Keyed &one : crowd)
        one.key = keyOf((place(one.number) - lowest) / widest);
    const auto isBefore = [](const Keyed &a, const Keyed &b) {
        return a.key != b.key ? a.key < b.key : a.number < b.number;
    };
    std::sort(crowd.begin(), crowd.end(), isBefore);
    for (std::size_t first = 0, end = 0; level < kMostLevels && first < crowd.size(); first = end) {
        for (end = first + 1; end < crowd.size() && crowd[end].key == crowd[first].key;)
            ++end;
        if (end - first > kCrowd)
            sortCrowd(crowd.subspan(first, end - first), place, level + 1);
    }
}

struct Placed {
    glm::vec3 place;
    std::uint32_t number;
};

/// Halves a list recursively across its longest side, down to groups of the given size.
void gather(std::span<Placed> all, std::size_t size)
{
    if (all.size() <= size)
        return;
    glm::vec3 lowest = all[0].place, highest = lowest;
    for (const Placed &one : all) {
        lowest = glm::min(lowest, one.place);
        highest = glm::max(highest, one.place);
    }
    const glm::vec3 extent = highest - lowest;
    const int axis = extent.x > extent.y ? (extent.x > extent.z ? 0 : 2) : (extent.y > extent.z ? 1 : 2);
    const std::size_t half = (all.size() / size + 1) / 2 * size;
    std::nth_element(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(half), all.end(),
                     [axis](const Placed &a, const Placed &b) { return a.place[axis] < b.place[axis]; });
    gather(all.first(half), size);
    gather(all.subspan(half), size);
}

} // namespace

std::vector<std::uint32_t> placeOrder(std::uint32_t count, std::size_t group,
                                      const std::function<glm::vec3(std::uint32_t)> &place)
{
    std::vector<Keyed> all(count);
    constexpr std::size_t kNumbersInTask = 1 << 14;
    base::inParallelRanges(count, kNumbersInTask, {}, [&](std::size_t first, std::size_t end) {
        for (std::size_t i = first; i < end; ++i) {
            const auto number = static_cast<std::uint32_t>(i);
            all[i] = {keyOf(place(number) * 0.5f + 0.5f), number};
        }
    });
    sortByKey(all);
    for (std::size_t first = 0, end = 0; first < all.size(); first = end) {
        for (end = first + 1; end < all.size() && all[end].key == all[first].key;)
            ++end;
        if (end - first > kCrowd)
            sortCrowd(std::span(all).subspan(first, end - first), place, 1);
    }
    std::vector<std::uint32_t> order(count);
    constexpr std::size_t kTogether = 256;
    static_assert(kNumbersInTask % kTogether == 0, "the order does not depend on the tasks");
    base::inParallelRanges(count, kNumbersInTask, {}, [&](std::size_t begin, std::size_t end) {
        std::vector<Placed> some;
        for (std::size_t first = begin; first < end; first += kTogether) {
            some.clear();
            for (std::size_t i = first; i < std::min(first + kTogether, end); ++i)
                some.push_back({place(all[i].number), all[i].number});
            gather(some, group);
            std::transform(some.begin(), some.end(), order.begin() + static_cast<std::ptrdiff_t>(first),
                           [](const Placed &one) { return one.number; });
        }
    });
    return order;
}

} // namespace unprojector::ray
