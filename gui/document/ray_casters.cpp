#include "gui/document/ray_casters.h"

#include <QTimer>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <new>
#include <system_error>
#include <thread>
#include <utility>

namespace unprojector::gui {
namespace {

/// Views let go of their models with the next picture.
constexpr std::chrono::milliseconds kUntilViewsLetGo{1000};

std::size_t sizeOf(const Model &model)
{
    return model.triangleCount() + model.pointCount();
}

/// A caster that does not hold its model.
/// @return null where progress stops it. Throws std::bad_alloc.
RayCasters::Caster build(const Model &model, const ray::Progress &progress)
{
    return ray::RayCaster::build(std::shared_ptr<const Model>(std::shared_ptr<const Model>(), &model), progress);
}

/// null where there is no memory
RayCasters::Caster builtAtOnce(const Model &model)
{
    try {
        return build(model, {});
    } catch (const std::bad_alloc &) {
        return nullptr;
    }
}

} // namespace

struct RayCasters::Job {
    std::weak_ptr<const Model> model;
    double size = 0.0;
    std::atomic<bool> isEnded{false};
    std::atomic<bool> isDone{false};
    // Written before isDone, read after it.
    Caster caster;
    bool isOutOfMemory = false;
    std::thread thread;
};

RayCasters::RayCasters(QObject *parent) : QObject(parent) {}

RayCasters::~RayCasters()
{
    for (const std::shared_ptr<Job> &job : m_jobs)
        job->isEnded = true;
    reap(true);
}

/// Joins the threads that have ended, or waits for all of them to.
void RayCasters::reap(bool all)
{
    std::erase_if(m_jobs, [all](const std::shared_ptr<Job> &job) {
        if (!all && !job->isDone)
            return false;
        job->thread.join();
        return true;
    });
}

const RayCasters::Kept *RayCasters::keptOf(const std::shared_ptr<const Model> &model) const
{
    const auto found = m_kept.find(model.get());
    return found != m_kept.end() && found->second.model.lock() == model ? &found->second : nullptr;
}

void RayCasters::keep(const std::shared_ptr<const Model> &model, const Caster &caster)
{
    m_kept[model.get()] = {model, caster};
    emit built();
}

std::vector<std::shared_ptr<const Model>> RayCasters::missing(const std::vector<SceneObject> &objects) const
{
    std::vector<std::shared_ptr<const Model>> models;
    for (const SceneObject &object : objects) {
        if (!object.isHidden && !keptOf(object.model)
            && std::find(models.begin(), models.end(), object.model) == models.end())
            models.push_back(object.model);
    }
    return models;
}

void RayCasters::prepare(const std::vector<SceneObject> &objects)
{
    if (m_isAhead)
        require(objects);
}

void RayCasters::require(const std::vector<SceneObject> &objects)
{
    dropUnused();
    reap(false);
    if (!m_kept.empty())
        QTimer::singleShot(kUntilViewsLetGo, this, &RayCasters::dropUnused);
    std::size_t atOnce = 0;
    std::vector<std::shared_ptr<const Model>> later;
    for (const std::shared_ptr<const Model> &model : missing(objects)) {
        if (atOnce + sizeOf(*model) > kMostAtOnce) {
            later.push_back(model);
            continue;
        }
        atOnce += sizeOf(*model);
        keep(model, builtAtOnce(*model));
    }
    const bool wasPreparing = isPreparing();
    const std::shared_ptr<const Model> underWay = m_job ? m_job->model.lock() : nullptr;
    const bool goesOn = std::find(later.begin(), later.end(), underWay) != later.end();
    if (m_job && !goesOn)
        giveUp();
    m_waiting.clear();
    m_all = m_done = 0.0;
    for (const std::shared_ptr<const Model> &model : later) {
        m_all += static_cast<double>(sizeOf(*model));
        if (model != underWay)
            m_waiting.push_back(model);
    }
    if (!m_job)
        begin();
    if (wasPreparing && !isPreparing())
        emit finished();
}

void RayCasters::giveUp()
{
    m_job->isEnded = true;
    m_job.reset();
}

void RayCasters::begin()
{
    std::shared_ptr<const Model> model;
    while (!model && !m_waiting.empty()) {
        model = m_waiting.front().lock();
        m_waiting.pop_front();
    }
    if (!model)
        return;
    const auto job = std::make_shared<Job>();
    job->model = model;
    job->size = static_cast<double>(sizeOf(*model));
    m_job = job;
    auto work = [this, job, model = std::move(model)]() mutable {
        double reported = 0.0;
        const auto report = [&](double share) {
            // A hundred reports are enough; each is an event for the window.
            if (share - reported >= 0.01) {
                reported = share;
                QMetaObject::invokeMethod(
                    this,
                    [this, job, share] {
                        if (job == m_job && m_all > 0.0)
                            emit progressed(std::min(1.0, (m_done + share * job->size) / m_all));
                    },
                    Qt::QueuedConnection);
            }
            return !job->isEnded && model.use_count() > 1; // else nobody else has it any more
        };
        try {
            job->caster = build(*model, report);
        } catch (const std::bad_alloc &) {
            job->isOutOfMemory = true;
        }
        model.reset();
        QMetaObject::invokeMethod(
            this, [this, job] { take(job); }, Qt::QueuedConnection);
        job->isDone = true;
    };
    try {
        job->thread = std::thread(std::move(work));
        m_jobs.push_back(job);
    } catch (const std::system_error &) {
        // The system gives no thread, which takes memory too.
        job->isOutOfMemory = true;
        QMetaObject::invokeMethod(
            this, [this, job] { take(job); }, Qt::QueuedConnection);
    }
}

void RayCasters::take(const std::shared_ptr<Job> &job)
{
    if (job != m_job)
        return; // given up, or taken already
    m_job.reset();
    m_done += job->size;
    if (const std::shared_ptr<const Model> model = job->model.lock()) {
        if (job->caster || job->isOutOfMemory)
            keep(model, job->caster);
        else
            m_waiting.push_back(model); // stopped when nobody had it, and found again since
    }
    job->caster.reset();
    if (!m_job)
        begin();
    if (!m_job)
        emit finished();
}

void RayCasters::complete(const std::vector<SceneObject> &objects)
{
    require(objects);
    while (m_job) {
        const std::shared_ptr<Job> job = m_job;
        if (job->thread.joinable()) // else it could not be started
            job->thread.join();
        m_jobs.remove(job);
        take(job);
    }
}

std::optional<std::vector<RayCasters::Caster>> RayCasters::of(const std::vector<SceneObject> &objects) const
{
    struct Held {
        std::shared_ptr<const Model> model;
        Caster caster;
    };
    std::vector<Caster> casters;
    casters.reserve(objects.size());
    for (const SceneObject &object : objects) {
        if (object.isHidden) {
            casters.push_back(nullptr);
            continue;
        }
        const Kept *kept = keptOf(object.model);
        if (!kept || !kept->caster)
            return std::nullopt;
        const auto held = std::make_shared<const Held>(Held{object.model, kept->caster});
        casters.emplace_back(held, held->caster.get());
    }
    return casters;
}

bool RayCasters::isHopeless(const std::vector<SceneObject> &objects) const
{
    return std::any_of(objects.begin(), objects.end(), [this](const SceneObject &object) {
        const Kept *kept = object.isHidden ? nullptr : keptOf(object.model);
        return kept && !kept->caster;
    });
}

void RayCasters::dropUnused()
{
    std::erase_if(m_kept, [](const auto &entry) { return entry.second.model.expired(); });
}

} // namespace unprojector::gui
