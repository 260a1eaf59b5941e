#pragma once

#include "core/ray/box_tree.h"
#include "core/threads/parallel.h"

#include <algorithm>
#include <functional>

namespace unprojector::maps {

/// Rows of a picture on all cores: rows(begin, end).
/// @param progress  with the share done, on the calling thread; may be empty
/// @return false when progress says stop
inline bool rowsInParallel(int count, const ray::Progress &progress, const std::function<void(int, int)> &rows)
{
    constexpr std::size_t kRows = 8; // some milliseconds
    struct Stopped {};
    try {
        threads::inParallelRanges(
            static_cast<std::size_t>(count), kRows,
            [&progress](double share) {
                if (progress && !progress(share))
                    throw Stopped{};
            },
            [&rows](std::size_t begin, std::size_t end) { rows(static_cast<int>(begin), static_cast<int>(end)); });
    } catch (const Stopped &) {
        return false;
    }
    return true;
}

} // namespace unprojector::maps
