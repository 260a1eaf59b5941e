#pragma once

#include <QDeadlineTimer>

#include <optional>
#include <utility>

namespace unprojector::gui {

/// The end of a time slice, or never. Each slice makes progress: the first answer is always "not
/// over".
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
