#pragma once

#include <algorithm>
#include <functional>

namespace unprojector::base {

/// Called with the share done in [0, 1], which never decreases; returning false cancels. Called from
/// any thread, one at a time; throws nothing.
using Progress = std::function<bool(double share)>;

/// Thrown by a Reporter to cancel.
struct Stopped {};

/// Reports the stages of a work as shares of the whole, which never decrease.
class Reporter {
public:
    explicit Reporter(const Progress &progress) : m_progress(progress) {}

    /// Begins a stage: the range of the whole that the following reports fill from 0 to 1.
    void beginStage(double from, double to)
    {
        m_from = from;
        m_to = to;
        report(0.0);
    }
    /// @param share  of the stage, in [0, 1]
    /// Throws Stopped when the callback returns false, then and at every later call.
    void report(double share)
    {
        m_last = std::max(m_last, m_from + (m_to - m_from) * std::clamp(share, 0.0, 1.0));
        m_isStopped = m_isStopped || (m_progress && !m_progress(std::min(m_last, 1.0)));
        if (m_isStopped)
            throw Stopped{};
    }
    /// Reports a part of the stage, as the functions of parallel.h do.
    std::function<void(double)> part(double from = 0.0, double to = 1.0)
    {
        return [this, from, to](double share) { report(from + (to - from) * share); };
    }

private:
    const Progress &m_progress;
    double m_from = 0.0;
    double m_to = 1.0;
    double m_last = 0.0;
    bool m_isStopped = false;
};

} // namespace unprojector::base
