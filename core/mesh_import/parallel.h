#pragma once

#include <cstddef>
#include <functional>

namespace unprojector::mesh_import {

/// Runs task(0) … task(count - 1) on all cores, in no order; returns when all have ended. A single task is run by the
/// calling thread.
///
/// The first exception in the order of the tasks goes on to the caller: then tasks that have not begun never do.
/// @param task    called from several threads at once; some milliseconds long, so that a cancel is obeyed at once
/// @param report  called by the calling thread only, with the share done in [0, 1], never falling; may throw to stop
void inParallel(std::size_t count, const std::function<void(double)> &report,
                const std::function<void(std::size_t)> &task);

/// The same over ranges of at most `size` of `count` elements: range(begin, end).
void inParallelRanges(std::size_t count, std::size_t size, const std::function<void(double)> &report,
                      const std::function<void(std::size_t, std::size_t)> &range);

} // namespace unprojector::mesh_import
