#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

namespace unprojector::cli {

/// Where a progress bar is drawn, and by which clock. Tests bring their own.
struct ProgressScreen {
    using Time = std::chrono::steady_clock::time_point;

    bool isThere = false; ///< without one nothing is drawn
    std::size_t columns = 80;
    std::function<void(std::string_view)> write;
    std::function<Time()> now;
};

/// The terminal that stderr goes to; none where it goes to a file or a pipe, or where the terminal cannot go back to the
/// start of a line (TERM=dumb).
ProgressScreen errorTerminal();

/// One line on a terminal that says how far a long work has come and how long it will take:
///
///    42% [=========>            ] 420 MB of 1 GB, 0:12 left
///   420 MB, 35 MB/s                                             where the end is not known
///
/// It appears after a second of work, is drawn ten times a second at most, is never wider than the terminal, and is gone when
/// its life ends. What else goes to the terminal in between goes through `withoutProgressBar`.
///
///   ProgressBar bar(rows * columns, ProgressBar::Unit::Points);
///   for (…) { …; bar.advance(columns); }
class ProgressBar {
public:
    enum class Unit { Bytes, Points };

    /// @param total   how much there is to do; nothing or 0 where that is not known
    explicit ProgressBar(std::optional<std::uint64_t> total, Unit unit, ProgressScreen screen = errorTerminal());
    ~ProgressBar();
    ProgressBar(const ProgressBar &) = delete;
    ProgressBar &operator=(const ProgressBar &) = delete;

    /// So much more is done. Any thread may say so; without a screen it costs nothing.
    void advance(std::uint64_t amount);
    /// Takes the bar away for good, before results are written to the same terminal. Nobody advances any more.
    void finish();

private:
    friend void withoutProgressBar(const std::function<void()> &write);

    std::string line(ProgressScreen::Time now) const;
    void draw(ProgressScreen::Time now);
    void erase();

    const std::uint64_t m_total; ///< 0: not known
    const Unit m_unit;
    ProgressScreen m_screen;
    const ProgressScreen::Time m_start;
    ProgressScreen::Time m_next; ///< not drawn before
    std::uint64_t m_done = 0;
    std::size_t m_width = 0; ///< of what stands on the terminal
};

/// Writes something to the terminal while no bar stands there: first takes it away; it comes back as the work goes on.
void withoutProgressBar(const std::function<void()> &write);

} // namespace unprojector::cli
