#include "gui/document/background.h"

#include <QCoreApplication>

#include <algorithm>
#include <chrono>
#include <new>
#include <stdexcept>
#include <system_error>

namespace unprojector::gui {
namespace {

class Texts {
    Q_DECLARE_TR_FUNCTIONS(unprojector::gui::JobFailure)
};

} // namespace

JobFailure failureOf(const std::exception_ptr &exception)
{
    try {
        std::rethrow_exception(exception);
    } catch (const std::bad_alloc &) {
        return {JobFailure::Kind::OutOfMemory};
    } catch (const std::length_error &) { // a container too large for any memory
        return {JobFailure::Kind::OutOfMemory};
    } catch (const std::system_error &error) {
        // The standard's code for a std::thread that cannot be started.
        if (error.code() == std::errc::resource_unavailable_try_again)
            return {JobFailure::Kind::NoThread};
        return {JobFailure::Kind::Exception, error.what()};
    } catch (const std::exception &error) {
        return {JobFailure::Kind::Exception, error.what()};
    } catch (...) {
        return {JobFailure::Kind::Exception, "?"};
    }
}

QString failureText(const JobFailure &failure)
{
    switch (failure.kind) {
    case JobFailure::Kind::NoThread: return Texts::tr("the system cannot start another thread");
    case JobFailure::Kind::OutOfMemory: return Texts::tr("there is not enough memory");
    case JobFailure::Kind::Exception:
        return Texts::tr("an unexpected error occurred (%1)").arg(QString::fromStdString(failure.detail));
    }
    Q_UNREACHABLE();
}

/// Runs an action on the thread that this object lives in.
/// @return false if there is no memory for that
template <class Action>
bool Background::post(Action action) noexcept
{
    try {
        return QMetaObject::invokeMethod(this, std::move(action), Qt::QueuedConnection);
    } catch (...) {
        return false;
    }
}

bool Job::report(double share)
{
    constexpr double kStep = 0.01;
    const bool isNews = share - m_reported >= kStep || (share >= 1.0 && m_reported < 1.0);
    if (m_progressed && isNews && !m_isCancelled) {
        m_reported = share;
        m_background.post([job = shared_from_this(), share] {
            if (!job->m_isCancelled)
                job->m_progressed(share);
        });
    }
    return !m_isCancelled;
}

Background::~Background()
{
    m_isClosing = true;
    cancel();
    for (const std::shared_ptr<Job> &job : m_jobs) {
        if (job->m_thread.joinable())
            job->m_thread.join();
    }
}

bool Background::isRunning() const
{
    return std::any_of(m_jobs.begin(), m_jobs.end(), [](const auto &job) { return !job->m_isCancelled; });
}

void Background::cancel()
{
    std::erase_if(m_jobs, [](const auto &job) { return !job->m_isStarted; });
    for (const std::shared_ptr<Job> &job : m_jobs)
        job->m_isCancelled = true;
}

void Background::finish()
{
    while (isRunning())
        end(std::shared_ptr<Job>(m_jobs.front())); // the first one has been started
}

void Background::startWaiting()
{
    for (std::size_t i = 0; i < std::min(m_most, m_jobs.size()); ++i) {
        const std::shared_ptr<Job> &job = m_jobs[i];
        if (std::exchange(job->m_isStarted, true))
            continue;
        try {
            if (fault)
                fault(Step::Start);
            job->m_thread = std::thread([this, job] { run(*job); });
        } catch (...) {
            job->m_exception = std::current_exception();
            job->m_work = nullptr;
            postEnd(job);
        }
    }
}

void Background::run(Job &job) noexcept
{
    try {
        if (fault)
            fault(Step::Work);
        if (!job.m_isCancelled)
            job.m_work(job);
    } catch (...) {
        job.m_exception = std::current_exception();
    }
    job.m_work = nullptr;
    postEnd(job.shared_from_this());
}

/// Progress may be lost, but not the end: a waiting receiver would wait for ever.
void Background::postEnd(const std::shared_ptr<Job> &job) noexcept
{
    constexpr std::chrono::milliseconds kUntilMemoryIsFree{50};
    while (!m_isClosing && !post([this, job] { end(job); }))
        std::this_thread::sleep_for(kUntilMemoryIsFree);
}

void Background::end(const std::shared_ptr<Job> &job)
{
    if (std::erase(m_jobs, job) == 0)
        return; // finish() already handled it
    if (job->m_thread.joinable())
        job->m_thread.join();
    startWaiting();
    if (!job->m_isCancelled.exchange(true)) // progress that arrives later is ignored
        job->m_done(job->m_exception);
}

} // namespace unprojector::gui
