#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

namespace unprojector::cli {

/// The screen and the clock of a progress bar. Tests pass their own.
struct ProgressScreen {
    using Time = std::chrono::steady_clock::time_point;

    std::size_t columns = 80;
    std::function<void(std::string_view)> write = {}; ///< empty: nothing is drawn
    std::function<Time()> now = {};
};

/// The terminal that stderr goes to. None where it goes to a file or a pipe, or where the terminal
/// cannot return to the start of a line (TERM=dumb).
ProgressScreen errorTerminal();

/// One line on a terminal with the progress of a long task and the remaining time:
///
///    42% [=========>            ] 420 MB of 1 GB, 0:12 left
///   420 MB, 35 MB/s                                             where the total is not known
///
/// It appears after a second of work, is drawn at most ten times a second, is never wider than the
/// terminal, and is erased on destruction. Other output to the terminal meanwhile must use
/// `withoutProgressBar`.
///
///   ProgressBar bar(rows * columns, ProgressBar::Unit::Points);
///   for (…) { …; bar.advance(columns); }
class ProgressBar {
public:
    enum class Unit { Bytes, Points };

    /// @param total   the amount of work; empty or 0 where unknown
    explicit ProgressBar(std::optional<std::uint64_t> total, Unit unit, ProgressScreen screen = errorTerminal());
    ~ProgressBar();
    ProgressBar(const ProgressBar &) = delete;
    ProgressBar &operator=(const ProgressBar &) = delete;

    /// Adds to the amount done. Any thread may call it; without a screen it costs nothing.
    void advance(std::uint64_t amount);
    /// Erases the bar for good, before results are written to the same terminal. No thread may call
    /// `advance` any more.
    void finish();

private:
    friend void withoutProgressBar(const std::function<void()> &write);

    std::string line(ProgressScreen::Time now) const;
    void draw(ProgressScreen::Time now);
    void erase();

    const std::uint64_t m_total; ///< 0: unknown
    const Unit m_unit;
    ProgressScreen m_screen;
    const ProgressScreen::Time m_start;
    ProgressScreen::Time m_next; ///< the earliest time of the next drawing
    std::uint64_t m_done = 0;
    std::size_t m_width = 0; ///< width of the text on the terminal
};

/// Calls `write` while no bar is on the terminal: erases it first; the bar returns as the work goes
/// on.
void withoutProgressBar(const std::function<void()> &write);

} // namespace unprojector::cli
