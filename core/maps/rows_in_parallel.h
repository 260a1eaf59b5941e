#pragma once

#include "core/ray/box_tree.h"
#include "core/threads/parallel.h"

#include <algorithm>
#include <cstddef>
#include <functional>
#include <span>

namespace unprojector::maps {

/// Rows of a picture on all cores, some of them at a time.
/// @param widthPixels  of a row
/// @param progress     with the share done, on the calling thread; may be empty
/// @return false when progress says stop
inline bool rowsInParallel(std::span<const int> rows, int widthPixels, const ray::Progress &progress,
                           const std::function<void(std::span<const int>)> &some)
{
    constexpr int kPixels = 1 << 14; // some milliseconds
    const auto atATime = static_cast<std::size_t>(std::max(1, kPixels / std::max(1, widthPixels)));
    struct Stopped {};
    try {
        threads::inParallelRanges(
            rows.size(), atATime,
            [&progress](double share) {
                if (progress && !progress(share))
                    throw Stopped{};
            },
            [&](std::size_t begin, std::size_t end) { some(rows.subspan(begin, end - begin)); });
    } catch (const Stopped &) {
        return false;
    }
    return true;
}

} // namespace unprojector::maps
