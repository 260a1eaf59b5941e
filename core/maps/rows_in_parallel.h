#pragma once

#include "core/base/parallel.h"
#include "core/base/progress.h"

#include <algorithm>
#include <cstddef>
#include <functional>
#include <span>

namespace unprojector::maps {

/// Processes rows of pixels on all cores, some at a time.
/// @param widthPixels  width of a row
/// @param progress     called with the share done, on the calling thread; may be empty
/// @return false if progress requests a stop
inline bool rowsInParallel(std::span<const int> rows, int widthPixels, const base::Progress &progress,
                           const std::function<void(std::span<const int>)> &some)
{
    constexpr int kPixels = 1 << 14; // takes some milliseconds
    const auto atATime = static_cast<std::size_t>(std::max(1, kPixels / std::max(1, widthPixels)));
    try {
        base::inParallelRanges(
            rows.size(), atATime,
            [&progress](double share) {
                if (progress && !progress(share))
                    throw base::Stopped{};
            },
            [&](std::size_t begin, std::size_t end) { some(rows.subspan(begin, end - begin)); });
    } catch (const base::Stopped &) {
        return false;
    }
    return true;
}

} // namespace unprojector::maps
