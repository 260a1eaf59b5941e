#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <vector>

namespace unprojector::threads {

/// Runs task(0) … task(count - 1) on all cores, in no order; returns when all have ended. A single task is run by the
/// calling thread.
///
/// The first exception in the order of the tasks goes on to the caller: then tasks that have not begun never do.
/// @param task    called from several threads at once; some milliseconds long, so that a cancel is obeyed at once
/// @param report  called by the calling thread only, with the share done in [0, 1], never falling; may throw to stop
void inParallel(std::size_t count, const std::function<void(double)> &report,
                const std::function<void(std::size_t)> &task);

/// Whether the system lets so many more threads run at once now.
bool canStartThreads(std::size_t count) noexcept;

/// The same over ranges of at most `size` of `count` elements: range(begin, end).
void inParallelRanges(std::size_t count, std::size_t size, const std::function<void(double)> &report,
                      const std::function<void(std::size_t, std::size_t)> &range);

/// Makes an array as long as `count` and fills it: fill(begin, end) sets these elements. In steps, since the memory of a
/// long array takes a long time to come. One that grows by many calls is not copied at each.
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

} // namespace unprojector::threads
