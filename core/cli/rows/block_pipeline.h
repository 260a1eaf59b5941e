#pragma once

#include "core/cli/rows/line_blocks.h"
#include "core/cli/terminal/exit_code.h"

#include <functional>
#include <string>
#include <vector>

namespace unprojector::cli {

/// What became of a block of lines.
struct BlockResult {
    std::string output;                ///< for stdout
    std::vector<LineMessage> messages; ///< for stderr, in any order
    std::size_t badRows = 0;
};

/// Works on one block; called by one thread only, so it may keep scratch memory.
using BlockWorker = std::function<void(const LineBlock &, BlockResult &)>;

/// Takes every block through a worker, several at a time, and writes the results in the order of the input. A thread
/// reads, works and writes in turn, so that the memory is that of one block a thread. A progress bar counts the bytes read,
/// unless the results go to a terminal: there they show how far the work is, and the bar would stand among them.
/// What a worker throws is thrown on when all threads have ended; what was written before stays so.
/// @param worker  makes the worker of a thread
ExitCode runBlocks(LineBlocks &blocks, ByteSource &source, ByteSink &sink, unsigned threads,
                   const std::function<BlockWorker()> &worker);

} // namespace unprojector::cli
