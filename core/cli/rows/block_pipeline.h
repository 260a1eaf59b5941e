#pragma once

#include "core/cli/rows/line_blocks.h"
#include "core/cli/terminal/exit_code.h"

#include <functional>
#include <string>
#include <vector>

namespace unprojector::cli {

/// The result of a block of lines.
struct BlockResult {
    std::string output;                ///< for stdout
    std::vector<LineMessage> messages; ///< for stderr, in any order
    bool hasBadRows = false;
};

/// Processes one block. Only one thread calls it, so it may keep scratch memory.
using BlockWorker = std::function<void(const LineBlock &, BlockResult &)>;

/// Passes every block through a worker, several at a time, and writes the results in input order.
/// Each thread reads, works and writes in turn, so the memory is one block per thread. A progress
/// bar counts the bytes read. It is off when the results go to a terminal: there the results show
/// the progress, and the bar would mix with them.
///
/// An exception of a worker is rethrown when all threads have ended. Output written before stays.
/// @param worker  makes the worker of a thread
ExitCode runBlocks(LineBlocks &blocks, ByteSource &source, ByteSink &sink, unsigned threads,
                   const std::function<BlockWorker()> &worker);

} // namespace unprojector::cli
