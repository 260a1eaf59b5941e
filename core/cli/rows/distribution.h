#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <queue>
#include <vector>

namespace unprojector::cli {

/// The largest, the mean and one percentile of many numbers. Only the numbers above the percentile
/// are kept.
class Distribution {
public:
    /// @param share  of the numbers that lie below the percentile, in (0, 1): 0.9999 for the
    ///         99.99th
    /// @param most   how many numbers there can be
    Distribution(double share, std::size_t most) : m_share(share), m_kept(above(most)) {}

    void add(double value)
    {
        ++m_count;
        m_sum += value;
        m_largest = m_count == 1 ? value : std::max(m_largest, value);
        m_top.push(value);
        if (m_top.size() > m_kept)
            m_top.pop();
    }

    bool isEmpty() const { return m_count == 0; }
    double largest() const { return m_largest; }
    double mean() const { return m_sum / static_cast<double>(m_count); }
    double percentile() const
    {
        auto top = m_top;
        while (top.size() > above(m_count))
            top.pop();
        return top.top();
    }

private:
    /// The number of values, out of `count`, that are not below the percentile; at least one.
    std::size_t above(std::size_t count) const
    {
        return std::max<std::size_t>(count - static_cast<std::size_t>(m_share * static_cast<double>(count)), 1);
    }

    double m_share;
    std::size_t m_kept;
    std::priority_queue<double, std::vector<double>, std::greater<>> m_top; ///< the least first
    std::size_t m_count = 0;
    double m_sum = 0.0, m_largest = 0.0;
};

} // namespace unprojector::cli
