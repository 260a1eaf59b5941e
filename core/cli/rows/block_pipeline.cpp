#include "core/cli/rows/block_pipeline.h"

#include "core/base/translation.h"
#include "core/cli/terminal/progress_bar.h"

#include <algorithm>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <thread>
#include <utility>
#include <vector>

namespace unprojector::cli {
using base::tr;
namespace {

class Pipeline {
public:
    Pipeline(LineBlocks &blocks, const ByteSource &source, ByteSink &sink)
        : m_blocks(blocks), m_sink(sink),
          m_progress(source.size(), ProgressBar::Unit::Bytes, sink.isTerminal() ? ProgressScreen{} : errorTerminal())
    {
    }

    /// Works until the end. An exception of a worker, such as out of memory, ends the work of all
    /// threads.
    void work(const std::function<BlockWorker()> &makeWorker) noexcept
    {
        try {
            workThrough(makeWorker());
        } catch (...) {
            fail(std::current_exception());
        }
    }

    /// Ends the progress bar after all work. Rethrows a worker's exception.
    void finish()
    {
        m_progress.finish();
        if (m_failure)
            std::rethrow_exception(m_failure);
    }
    bool hasBadRows() const { return m_badRows > 0; }

private:
    void workThrough(const BlockWorker &worker)
    {
        LineBlock block;
        BlockResult result;
        for (std::size_t ticket = 0; read(block, ticket);) {
            result.output.clear();
            result.messages.clear();
            result.badRows = 0;
            worker(block, result);
            std::stable_sort(result.messages.begin(), result.messages.end(),
                             [](const LineMessage &a, const LineMessage &b) { return a.line < b.line; });
            write(result, ticket);
        }
    }

    /// Records the failure and wakes the other threads. They stop waiting for the missing block and
    /// write no later one.
    void fail(std::exception_ptr failure)
    {
        stopReading();
        {
            const std::lock_guard lock(m_writing);
            if (!m_failure)
                m_failure = std::move(failure);
        }
        m_turn.notify_all();
    }

    void stopReading()
    {
        const std::lock_guard lock(m_reading);
        m_isDone = true;
    }

    bool read(LineBlock &block, std::size_t &ticket)
    {
        const std::lock_guard lock(m_reading);
        if (m_isDone || !m_blocks.next(block)) {
            m_isDone = true;
            return false;
        }
        m_progress.advance(m_blocks.bytesRead() - m_bytesKnown);
        m_bytesKnown = m_blocks.bytesRead();
        ticket = m_nextRead++;
        return true;
    }

    void write(const BlockResult &result, std::size_t ticket)
    {
        std::unique_lock lock(m_writing);
        m_turn.wait(lock, [&] { return m_nextWritten == ticket || m_failure; });
        if (m_failure)
            return;
        m_badRows += result.badRows;
        m_sink.write(result.output);
        m_sink.flush(); // a reader need not wait for a full buffer, and a closed pipe is noticed at once
        const bool isOver = m_sink.state() != ByteSink::State::Open;
        for (std::size_t i = 0; i < result.messages.size() && !isOver; ++i)
            complain(result.messages[i].text);
        ++m_nextWritten;
        lock.unlock();
        m_turn.notify_all();
        if (isOver)
            stopReading();
    }

    LineBlocks &m_blocks;
    ByteSink &m_sink;
    ProgressBar m_progress;
    std::mutex m_reading, m_writing;
    std::condition_variable m_turn;
    std::size_t m_nextRead = 0, m_nextWritten = 0, m_badRows = 0;
    std::exception_ptr m_failure;   ///< the first one; m_writing guards it
    std::uint64_t m_bytesKnown = 0; ///< bytes reported to the progress bar
    bool m_isDone = false;
};

} // namespace

ExitCode runBlocks(LineBlocks &blocks, ByteSource &source, ByteSink &sink, unsigned threads,
                   const std::function<BlockWorker()> &worker)
{
    Pipeline pipeline(blocks, source, sink);
    std::vector<std::thread> others;
    try {
        for (unsigned i = 1; i < threads; ++i)
            others.emplace_back([&] { pipeline.work(worker); });
    } catch (const std::exception &) { // the system provides no more threads; fewer suffice
    }
    pipeline.work(worker);
    for (std::thread &thread : others)
        thread.join();
    pipeline.finish();
    const ExitCode written = sink.finish();
    if (source.hasFailed()) {
        complain(tr("%1: reading stopped at an error; the results are not complete", source.name()));
        return ExitCode::UnusableInput;
    }
    if (written != ExitCode::Done)
        return written;
    return pipeline.hasBadRows() ? ExitCode::SomeRowsBad : ExitCode::Done;
}

} // namespace unprojector::cli
