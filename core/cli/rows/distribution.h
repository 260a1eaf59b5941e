#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <vector>

namespace unprojector::cli {

/// The largest, the mean and one percentile of many numbers. Only the numbers above the percentile
/// are kept.
class Distribution {
public:
    /// @param share  of the numbers that lie below the percentile, in (0, 1): 0.9999 for the
    ///         99.99th
    /// @param most   how many numbers there can be
    Distribution(double share, std::size_t most) : m_share(share), m_kept(std::max<std::size_t>(above(most), 1)) {}

    void add(double value)
    {
        ++m_count;
        m_sum += value;
        // A heap whose front is the least of the kept numbers.
        if (m_top.size() == m_kept) {
            if (value <= m_top.front())
                return;
            std::pop_heap(m_top.begin(), m_top.end(), std::greater<>());
            m_top.pop_back();
        }
        m_top.push_back(value);
        std::push_heap(m_top.begin(), m_top.end(), std::greater<>());
    }

    bool isEmpty() const { return m_count == 0; }
    /// @pre not empty
    double largest() const { return *std::max_element(m_top.begin(), m_top.end()); }
    double mean() const { return m_sum / static_cast<double>(m_count); }
    double percentile() const
    {
        std::vector<double> descending = m_top;
        std::sort(descending.begin(), descending.end(), std::greater<>());
        return descending[std::max<std::size_t>(above(m_count), 1) - 1];
    }

private:
    /// The number of values, out of `count`, that are not below the percentile.
    std::size_t above(std::size_t count) const
    {
        return count - static_cast<std::size_t>(m_share * static_cast<double>(count));
    }

    double m_share;
    std::size_t m_kept;
    std::vector<double> m_top;
    std::size_t m_count = 0;
    double m_sum = 0.0;
};

} // namespace unprojector::cli
