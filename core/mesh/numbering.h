#pragma once

#include <glm/vec3.hpp>

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
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
    static constexpr std::uint32_t kNone = 0xffffffffu;

    /// @param expected  number of different keys
    /// @param fixed  keys that have the first numbers, and that add() does not find
    explicit Numbering(std::size_t expected = 0, std::vector<Key> fixed = {})
        : m_keys(std::move(fixed)), m_fixed(m_keys.size()),
          m_slots(std::bit_ceil(std::max<std::size_t>(16, expected + expected / 2)), kNone)
    {
    }

    std::uint32_t add(const Key &key)
    {
        const std::size_t count = m_keys.size() - m_fixed;
        if (count + count / 2 > m_slots.size())
            grow();
        const std::size_t mask = m_slots.size() - 1;
        std::size_t slot = static_cast<std::size_t>(Hash()(key)) & mask;
        for (; m_slots[slot] != kNone; slot = (slot + 1) & mask) {
            if (m_keys[m_slots[slot]] == key)
                return m_slots[slot];
        }
        const auto number = static_cast<std::uint32_t>(m_keys.size());
        m_slots[slot] = number;
        m_keys.push_back(key);
        return number;
    }
    std::size_t size() const { return m_keys.size(); }
    /// By their numbers.
    std::vector<Key> &keys() { return m_keys; }
    const std::vector<Key> &keys() const { return m_keys; }

private:
    void grow()
    {
        m_slots.assign(2 * m_slots.size(), kNone);
        const std::size_t mask = m_slots.size() - 1;
        for (std::size_t number = m_fixed; number < m_keys.size(); ++number) {
            std::size_t slot = static_cast<std::size_t>(Hash()(m_keys[number])) & mask;
            while (m_slots[slot] != kNone)
                slot = (slot + 1) & mask;
            m_slots[slot] = static_cast<std::uint32_t>(number);
        }
    }

    std::vector<Key> m_keys;
    std::size_t m_fixed;
    std::vector<std::uint32_t> m_slots;
};

} // namespace unprojector::mesh
