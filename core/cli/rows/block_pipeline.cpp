#include "core/cli/rows/block_pipeline.h"

#include "core/base/translation.h"
#include "core/cli/terminal/progress_bar.h"

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <exception>
#include <mutex>
#include <thread>
#include <utility>
#include <vector>

namespace unprojector::cli {
using base::tr;

ExitCode runBlocks(LineBlocks &blocks, ByteSource &source, ByteSink &sink, unsigned threads,
                   const std::function<BlockWorker()> &worker)
{
    ProgressBar progress(source.size(), ProgressBar::Unit::Bytes,
                         sink.isTerminal() ? ProgressScreen{} : errorTerminal());
    std::mutex reading, writing;
    std::condition_variable turn;
    std::size_t nextRead = 0, nextWritten = 0;
    std::uint64_t bytesKnown = 0; // to the progress bar
    bool hasBadRows = false;
    std::exception_ptr failure; // the first one; `writing` guards it
    std::atomic<bool> isDone = false;
    const auto read = [&](LineBlock &block, std::size_t &ticket) {
        const std::lock_guard lock(reading);
        if (isDone || !blocks.next(block)) {
            isDone = true;
            return false;
        }
        progress.advance(blocks.bytesRead() - bytesKnown);
        bytesKnown = blocks.bytesRead();
        ticket = nextRead++;
        return true;
    };
    const auto write = [&](const BlockResult &result, std::size_t ticket) {
        std::unique_lock lock(writing);
        turn.wait(lock, [&] { return nextWritten == ticket || failure; });
        if (failure)
            return;
        hasBadRows = hasBadRows || result.hasBadRows;
        sink.write(result.output);
        sink.flush(); // a reader need not wait for a full buffer, and a closed pipe is noticed at once
        if (sink.state() != ByteSink::State::Open)
            isDone = true;
        else
            std::for_each(result.messages.begin(), result.messages.end(),
                          [](const LineMessage &message) { complain(message.text); });
        ++nextWritten;
        lock.unlock();
        turn.notify_all();
    };
    // An exception of a worker, such as out of memory, ends the work of all threads: they stop waiting
    // for the missing block and write no later one.
    const auto work = [&]() noexcept {
        try {
            const BlockWorker ours = worker();
            LineBlock block;
            BlockResult result;
            for (std::size_t ticket = 0; read(block, ticket);) {
                result.output.clear();
                result.messages.clear();
                result.hasBadRows = false;
                ours(block, result);
                std::stable_sort(result.messages.begin(), result.messages.end(),
                                 [](const LineMessage &a, const LineMessage &b) { return a.line < b.line; });
                write(result, ticket);
            }
        } catch (...) {
            isDone = true;
            {
                const std::lock_guard lock(writing);
                if (!failure)
                    failure = std::current_exception();
            }
            turn.notify_all();
        }
    };
    std::vector<std::thread> others;
    try {
        for (unsigned i = 1; i < threads; ++i)
            others.emplace_back(work);
    } catch (const std::exception &) { // the system provides no more threads; fewer suffice
    }
    work();
    for (std::thread &thread : others)
        thread.join();
    progress.finish();
    if (failure)
        std::rethrow_exception(failure);
    const ExitCode written = sink.finish();
    if (source.hasFailed()) {
        complain(tr("%1: reading stopped at an error; the results are not complete", source.name()));
        return ExitCode::UnusableInput;
    }
    if (written != ExitCode::Done)
        return written;
    return hasBadRows ? ExitCode::SomeRowsBad : ExitCode::Done;
}

} // namespace unprojector::cli
