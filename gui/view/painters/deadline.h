#pragma once

#include <QDeadlineTimer>

#include <optional>
#include <utility>

namespace unprojector::gui {

/// Until when something may be gone on with, or for ever. Whoever asks gets something done: the first answer is that it is
/// not over.
class Deadline {
public:
    explicit Deadline(std::optional<int> milliseconds)
        : m_timer(milliseconds ? QDeadlineTimer(*milliseconds) : QDeadlineTimer(QDeadlineTimer::Forever))
    {
    }
    bool isOver() const { return std::exchange(m_hasBegun, true) && m_timer.hasExpired(); }
    bool isNever() const { return m_timer.isForever(); }

private:
    QDeadlineTimer m_timer;
    mutable bool m_hasBegun = false;
};

} // namespace unprojector::gui
