#pragma once

#include <glm/vec3.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

/// Measures whether boxes contain their points. Each error is in units of half its own box, on the
/// axis where it is largest: 1 is just inside.
class InsideShare {
public:
    /// @param off        from the box's middle
    /// @param halfSizes  of the box
    static double shareOf(const glm::dvec3 &off, const glm::dvec3 &halfSizes)
    {
        double share = 0.0;
        for (int axis = 0; axis < 3; ++axis)
            share = std::max(share, off[axis] == 0.0 ? 0.0 : std::abs(off[axis]) / halfSizes[axis]);
        return share;
    }
    void add(double share) { m_shares.push_back(share); }
    /// Adds an error far outside any box.
    void addMiss() { m_shares.push_back(1e300); }
    void add(const InsideShare &other)
    {
        m_shares.insert(m_shares.end(), other.m_shares.begin(), other.m_shares.end());
    }

    std::size_t count() const { return m_shares.size(); }
    double inside() const
    {
        const auto in = std::count_if(m_shares.begin(), m_shares.end(), [](double share) { return share <= 1.0; });
        return static_cast<double>(in) / static_cast<double>(m_shares.size());
    }
    /// The smallest scale at which boxes of the same shape would hold the share `held`: 0.5 means
    /// that all are twice as wide as needed.
    double neededScale(double held = 0.999) const
    {
        std::vector<double> sorted = m_shares;
        std::sort(sorted.begin(), sorted.end());
        return sorted.at(std::min(sorted.size() - 1, static_cast<std::size_t>(held * double(sorted.size()))));
    }

private:
    std::vector<double> m_shares;
};
