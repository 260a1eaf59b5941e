#pragma once

#include "core/geometry/result.h"

#include <QObject>
#include <QString>

#include <atomic>
#include <cstddef>
#include <deque>
#include <exception>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <thread>
#include <type_traits>
#include <utility>

namespace unprojector::gui {

/// The reason why a job has no result.
struct JobFailure {
    enum class Kind { NoThread, OutOfMemory, Exception };
    Kind kind = Kind::OutOfMemory;
    std::string detail = {}; ///< the exception's own text
};

template <class T>
using JobResult = geometry::Result<T, JobFailure>;

/// Converts an exception. @pre exception is not null
JobFailure failureOf(const std::exception_ptr &exception);
/// The reason in the user's language: a clause, in lower case and without a full stop.
QString failureText(const JobFailure &failure);

class Background;

/// A job, seen from its worker.
class Job : public std::enable_shared_from_this<Job> {
public:
    explicit Job(Background &background) : m_background(background) {}

    bool isCancelled() const { return m_isCancelled; }
    /// Reports progress to the owner, in at most a hundred steps: each is an event for the window.
    /// Call it from one thread at a time.
    /// @param share  done, in [0, 1]
    /// @return false once the job is cancelled: the work should then return soon, with any result
    bool report(double share);

private:
    friend class Background;

    Background &m_background;
    std::function<void(Job &)> m_work; ///< destroyed by the worker, which frees what it captures
    std::function<void(const std::exception_ptr &)> m_done;
    std::function<void(double)> m_progressed;
    std::atomic<bool> m_isCancelled{false};
    bool m_isStarted = false;
    double m_reported = 0.0;
    std::exception_ptr m_exception; ///< written by the worker, read once the thread is joined
    std::thread m_thread;
};

/// The jobs of an owner, each on its own thread. They report to the thread that this object lives
/// in, through its event loop. Nothing that goes wrong on a worker leaves it: every failure becomes
/// a JobFailure.
///
/// Make it the owner's last member: its destructor cancels all jobs and waits for their threads,
/// which may use the other members. Call all functions on the thread that it lives in.
class Background : public QObject {
public:
    /// @param most  threads that run at once; further jobs wait. A cancelled job keeps its thread
    /// until it ends
    explicit Background(std::size_t most = 1) : m_most(most) {}
    ~Background() override;

    /// Starts a job and returns at once. If the job cannot start, `done` reports that later.
    /// @param work        Value work(Job &), on the worker
    /// @param done        done(JobResult<Value>), later, unless the job is cancelled. The job has
    /// ended by then.
    /// @param progressed  called before `done`, with rising shares
    template <class Work, class Done>
    void start(Work work, Done done, std::function<void(double)> progressed = {})
    {
        using Value = std::invoke_result_t<Work &, Job &>;
        const auto job = std::make_shared<Job>(*this);
        const auto value = std::make_shared<std::optional<Value>>();
        job->m_work = [work = std::move(work), value](Job &self) mutable { value->emplace(work(self)); };
        job->m_done = [done = std::move(done), value](const std::exception_ptr &exception) mutable {
            done(exception ? JobResult<Value>(failureOf(exception)) : JobResult<Value>(std::move(**value)));
        };
        job->m_progressed = std::move(progressed);
        m_jobs.push_back(job);
        startWaiting();
    }
    /// Cancels all jobs: no report of them arrives any more.
    void cancel();
    /// Waits until all jobs have ended, including jobs that a `done` starts. Calls each `done`
    /// before it returns.
    void finish();
    /// Returns whether a `done` is still to come.
    bool isRunning() const;

    enum class Step { Start, Work };
    /// A hook for tests: called before a thread is started, and by the worker before the work. If
    /// it throws, that step fails with the exception. Change it only while no job runs.
    static inline std::function<void(Step)> fault;

private:
    friend class Job;

    void startWaiting();
    void run(Job &job) noexcept;
    void end(const std::shared_ptr<Job> &job);
    template <class Action>
    bool post(Action action) noexcept;
    void postEnd(const std::shared_ptr<Job> &job) noexcept;

    const std::size_t m_most;
    std::deque<std::shared_ptr<Job>> m_jobs; ///< in order; the cancelled ones among them are ending
    std::atomic<bool> m_isClosing{false};
};

} // namespace unprojector::gui
