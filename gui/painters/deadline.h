#pragma once

#include <QDeadlineTimer>

#include <optional>

namespace unprojector::gui {

/// Until when something may be gone on with, or for ever.
class Deadline {
public:
    explicit Deadline(std::optional<int> milliseconds)
        : m_timer(milliseconds ? QDeadlineTimer(*milliseconds) : QDeadlineTimer(QDeadlineTimer::Forever))
    {
    }
    bool isOver() const { return m_timer.hasExpired(); }
    bool isNever() const { return m_timer.isForever(); }

private:
    QDeadlineTimer m_timer;
};

} // namespace unprojector::gui
