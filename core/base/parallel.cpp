#include "core/base/parallel.h"

#include "core/base/translation.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <future>
#include <memory>
#include <mutex>
#include <thread>
#include <vector>

namespace unprojector::base {
namespace {

/// The tasks of one call, handed out in order.
class TaskQueue {
public:
    TaskQueue(std::size_t count, const std::function<void(std::size_t)> &task) : m_count(count), m_task(task) {}

    /// Runs the next task; returns false if there is none left.
    bool runNext()
    {
        if (m_isStopped)
            return false;
        const std::size_t number = m_next.fetch_add(1);
        if (number >= m_count)
            return false;
        try {
            m_task(number);
        } catch (...) {
            stop(number, std::current_exception());
        }
        m_done.fetch_add(1);
        return true;
    }

    void stop(std::size_t number, std::exception_ptr exception)
    {
        m_isStopped = true;
        const std::lock_guard lock(m_mutex);
        // All tasks before this one were handed out and will end, so the first failing task is
        // always found.
        if (!m_exception || number < m_failed) {
            m_failed = number;
            m_exception = std::move(exception);
        }
    }

    double share() const { return static_cast<double>(m_done.load()) / static_cast<double>(m_count); }
    const std::exception_ptr &exception() const { return m_exception; }

private:
    std::size_t m_count;
    const std::function<void(std::size_t)> &m_task;
    std::atomic<std::size_t> m_next{0};
    std::atomic<std::size_t> m_done{0};
    std::atomic<bool> m_isStopped{false};
    std::mutex m_mutex;
    std::size_t m_failed = 0;
    std::exception_ptr m_exception;
};

} // namespace

unsigned coreCount() noexcept
{
    static const unsigned count = std::max(1u, std::thread::hardware_concurrency());
    return count;
}

void inParallel(std::size_t count, const std::function<void(double)> &report,
                const std::function<void(std::size_t)> &task, std::size_t most)
{
    if (count == 0)
        return;
    if (most == 0)
        most = coreCount();
    TaskQueue queue(count, task);
    std::vector<std::thread> helpers;
    const std::size_t helperCount = std::min(count, most) - 1;
    helpers.reserve(helperCount);
    try {
        while (helpers.size() < helperCount) {
            helpers.emplace_back([&queue, isEnglish = language() == Language::English] {
                const auto english = isEnglish ? std::make_unique<InEnglish>() : nullptr;
                while (queue.runNext()) {
                }
            });
        }
    } catch (const std::exception &) {
        // The system has no more threads, or no memory for one: the existing ones do the work.
    }
    try {
        while (queue.runNext()) {
            if (report)
                report(queue.share());
        }
    } catch (...) {
        queue.stop(0, std::current_exception());
    }
    for (std::thread &helper : helpers)
        helper.join();
    if (queue.exception())
        std::rethrow_exception(queue.exception());
}

bool canStartThreads(std::size_t count) noexcept
{
    std::vector<std::thread> threads;
    std::promise<void> end;
    bool areStarted = true;
    try {
        const std::shared_future<void> ended = end.get_future().share();
        threads.reserve(count);
        while (threads.size() < count)
            threads.emplace_back([ended] { ended.wait(); });
    } catch (const std::exception &) {
        areStarted = false;
    }
    end.set_value();
    for (std::thread &thread : threads)
        thread.join();
    return areStarted;
}

void inParallelRanges(std::size_t count, std::size_t size, const std::function<void(double)> &report,
                      const std::function<void(std::size_t, std::size_t)> &range, std::size_t most)
{
    inParallel((count + size - 1) / size, report,
               [&](std::size_t number) { range(number * size, std::min(count, (number + 1) * size)); }, most);
}

} // namespace unprojector::base
