#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <vector>

namespace unprojector::base {

/// Runs task(0) … task(count - 1) on all cores, in no order; returns when all have ended. If there
/// is only one task, the calling thread runs it.
///
/// Rethrows the first exception, in the order of the tasks. After an exception, tasks that have not
/// begun are skipped.
/// @param task    called from several threads at once; a few milliseconds long, so that cancelling
///         takes effect at once
/// @param report  called by the calling thread only, with the share done in [0, 1], which never
///         decreases; may throw to cancel
/// @param most    the maximum number of threads; 0: all cores
void inParallel(std::size_t count, const std::function<void(double)> &report,
                const std::function<void(std::size_t)> &task, std::size_t most = 0);

/// The number of the computer's cores, at least 1. It asks the system only once: the answer takes as
/// long as a small mesh, since Linux reads it from a file.
unsigned coreCount() noexcept;

/// Returns whether the system can start this many more threads now.
bool canStartThreads(std::size_t count) noexcept;

/// The same for ranges of at most `size` of `count` elements: range(begin, end).
void inParallelRanges(std::size_t count, std::size_t size, const std::function<void(double)> &report,
                      const std::function<void(std::size_t, std::size_t)> &range, std::size_t most = 0);

/// Resizes an array to `count` and fills it in parallel: fill(begin, end) sets these elements. It
/// works in steps, since allocating the memory of a long array takes a long time. Capacity at least
/// doubles, so repeated calls do not copy the array each time.
template <class T>
void fillInParallel(std::vector<T> &values, std::size_t count, const std::function<void(double)> &report,
                    const std::function<void(std::size_t, std::size_t)> &fill)
{
    constexpr std::size_t kStep = 1 << 21;
    constexpr std::size_t kTask = 1 << 16;
    if (count > values.capacity())
        values.reserve(std::max(count, 2 * values.capacity()));
    while (values.size() < count) {
        const std::size_t begin = values.size();
        const std::size_t size = std::min(kStep, count - begin);
        values.resize(begin + size);
        inParallelRanges(size, kTask, {}, [&](std::size_t from, std::size_t to) { fill(begin + from, begin + to); });
        if (report)
            report(static_cast<double>(values.size()) / static_cast<double>(count));
    }
}

} // namespace unprojector::base
