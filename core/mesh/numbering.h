#pragma once

#include <glm/vec3.hpp>

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

namespace unprojector::mesh {

inline constexpr std::uint64_t kHashStart = 0x2545f4914f6cdd1dull;

inline std::uint64_t mixed(std::uint64_t hash, std::uint32_t word)
{
    hash = (hash ^ word) * 0x9e3779b97f4a7c15ull;
    return hash ^ (hash >> 29);
}

template <std::size_t n>
std::uint64_t hashOf(const std::array<std::uint32_t, n> &words, std::uint64_t hash = kHashStart)
{
    for (const std::uint32_t word : words)
        hash = mixed(hash, word);
    return hash;
}

template <class Number>
std::uint64_t hashOf(const glm::vec<3, Number> &v, std::uint64_t hash = kHashStart)
{
    const auto words = [](Number number) {
        // Adding 0 turns -0 into 0: equal numbers must hash alike.
        return std::bit_cast<std::array<std::uint32_t, sizeof(Number) / 4>>(number + Number(0));
    };
    return hashOf(words(v.z), hashOf(words(v.y), hashOf(words(v.x), hash)));
}

/// Finds the first of equal things among those asked for so far. Their indices stand for them.
class FirstEqual {
public:
    /// @param expected  number of different ones
    explicit FirstEqual(std::size_t expected)
        : m_slots(std::bit_ceil(std::max<std::size_t>(16, expected + expected / 2)), kNone)
    {
    }

    template <class HashAt, class AreEqual>
    std::uint32_t of(std::uint32_t index, const HashAt &hashAt, const AreEqual &areEqual)
    {
        if (m_count + m_count / 4 >= m_slots.size()) {
            const std::vector<std::uint32_t> before =
                std::exchange(m_slots, std::vector<std::uint32_t>(2 * m_slots.size(), kNone));
            for (const std::uint32_t known : before) {
                if (known != kNone)
                    slotOf(known, hashAt, areEqual) = known;
            }
        }
        std::uint32_t &slot = slotOf(index, hashAt, areEqual);
        if (slot == kNone) {
            slot = index;
            ++m_count;
        }
        return slot;
    }

private:
    static constexpr std::uint32_t kNone = 0xffffffffu;

    template <class HashAt, class AreEqual>
    std::uint32_t &slotOf(std::uint32_t index, const HashAt &hashAt, const AreEqual &areEqual)
    {
        const std::size_t mask = m_slots.size() - 1;
        std::size_t slot = static_cast<std::size_t>(hashAt(index)) & mask;
        while (m_slots[slot] != kNone && !areEqual(m_slots[slot], index))
            slot = (slot + 1) & mask;
        return m_slots[slot];
    }

    std::vector<std::uint32_t> m_slots;
    std::size_t m_count = 0;
};

struct HashOf {
    template <class Key>
    std::uint64_t operator()(const Key &key) const
    {
        return hashOf(key);
    }
};

/// Numbers keys in the order of first use; equal ones share a number.
template <class Key, class Hash = HashOf>
class Numbering {
public:
    /// @param expected  number of different keys
    explicit Numbering(std::size_t expected = 0) : m_first(expected) {}

    std::uint32_t add(const Key &key)
    {
        m_keys.push_back(key);
        const auto last = static_cast<std::uint32_t>(m_keys.size() - 1);
        const std::uint32_t number = m_first.of(
            last, [this](std::uint32_t at) { return Hash()(m_keys[at]); },
            [this](std::uint32_t a, std::uint32_t b) { return m_keys[a] == m_keys[b]; });
        if (number != last)
            m_keys.pop_back();
        return number;
    }
    std::size_t size() const { return m_keys.size(); }
    /// By their numbers.
    const std::vector<Key> &keys() const { return m_keys; }

private:
    std::vector<Key> m_keys;
    FirstEqual m_first;
};

/// Groups of things that are joined in pairs.
class JoinedGroups {
public:
    explicit JoinedGroups(std::size_t count = 0) { reset(count); }
    /// Makes each member a group of its own.
    void reset(std::size_t count)
    {
        m_parents.resize(count);
        std::iota(m_parents.begin(), m_parents.end(), std::uint32_t{0});
    }
    /// The member that represents the group of another.
    std::uint32_t of(std::uint32_t member)
    {
        while (m_parents[member] != member)
            member = m_parents[member] = m_parents[m_parents[member]];
        return member;
    }
    void join(std::uint32_t a, std::uint32_t b) { m_parents[of(a)] = of(b); }

private:
    std::vector<std::uint32_t> m_parents;
};

} // namespace unprojector::mesh
