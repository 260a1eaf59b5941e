#include "gui/document/map_maker.h"

#include <atomic>
#include <new>
#include <optional>
#include <system_error>
#include <thread>
#include <utility>

namespace unprojector::gui {

/// What rays meet of a picture. Whoever has it has the models too.
struct MapMaker::Seen {
    std::vector<SceneObject> objects;
    Unprojector unprojector;
    ray::SceneRays rays;
    std::optional<maps::SurfaceImage> surfaces; ///< once they are met
};

struct MapMaker::Job {
    maps::Question question;
    std::shared_ptr<const Seen> seen; ///< without surfaces: to be met first
    std::atomic<bool> isEnded{false};
    std::atomic<bool> isDone{false};
    // Written before isDone, read after it.
    std::shared_ptr<const MadeMap> made; ///< null: it was ended, or there is none
    std::optional<Error> error;
    bool isOutOfMemory = false;
    std::thread thread;

    /// @param report  with the share done; false: stop
    void run(const ray::Progress &report)
    {
        const ray::ClickRays &rays = seen->rays.rays();
        const bool areMet = seen->surfaces.has_value();
        if (!areMet) {
            const Result<maps::PixelRays> pixels = maps::PixelRays::of(rays);
            if (!pixels) {
                error = pixels.error();
                return;
            }
            std::optional<maps::SurfaceImage> surfaces =
                maps::surfacesMet(seen->rays, *pixels, {}, [&](double share) { return report(share / 2.0); });
            if (!surfaces)
                return;
            seen =
                std::make_shared<const Seen>(Seen{seen->objects, seen->unprojector, seen->rays, std::move(surfaces)});
        }
        const auto map = maps::pixelMap(question, seen->unprojector, *seen->surfaces, seen->objects,
                                        [&](double share) { return report(areMet ? share : 0.5 + share / 2.0); });
        if (!map)
            error = map.error();
        else if (*map)
            made = std::make_shared<const MadeMap>(MadeMap{**map, maps::statisticsOf(**map), question,
                                                           seen->unprojector.picture(), seen->rays.hasPoints()});
    }
};

MapMaker::MapMaker(const SceneDocument &document, QObject *parent) : QObject(parent), m_document(document)
{
    connect(&m_document, &SceneDocument::changed, this, [this](Changes changes) {
        if (changes & kSeen) {
            cancel();
            m_seen.reset(); // it holds the models of a scene that is gone, too
        }
    });
}

MapMaker::~MapMaker()
{
    cancel();
    reap(true);
}

/// Joins the threads that have ended, or waits for all of them to.
void MapMaker::reap(bool all)
{
    std::erase_if(m_jobs, [all](const std::shared_ptr<Job> &job) {
        if (!all && !job->isDone)
            return false;
        job->thread.join();
        return true;
    });
}

void MapMaker::cancel()
{
    if (m_job)
        m_job->isEnded = true;
    m_job.reset();
}

bool MapMaker::ask(const maps::Question &question)
{
    cancel();
    reap(false);
    if (!m_seen) {
        const ray::SceneRays *rays = m_document.rays();
        if (rays == nullptr)
            return false;
        m_seen =
            std::make_shared<const Seen>(Seen{m_document.objects(), m_document.unprojector(), *rays, std::nullopt});
    }
    const auto job = std::make_shared<Job>();
    job->question = question;
    job->seen = m_seen;
    m_job = job;
    auto work = [this, job] {
        const auto report = [this, job, reported = 0.0](double share) mutable {
            constexpr double kStep = 0.05; // each is an event for the window
            if (share - reported >= kStep) {
                reported = share;
                QMetaObject::invokeMethod(
                    this,
                    [this, job, share] {
                        if (job == m_job)
                            emit progressed(share);
                    },
                    Qt::QueuedConnection);
            }
            return !job->isEnded;
        };
        try {
            job->run(report);
        } catch (const std::bad_alloc &) {
            job->isOutOfMemory = true;
        } catch (const std::system_error &) {
            job->isOutOfMemory = true;
        }
        QMetaObject::invokeMethod(
            this, [this, job] { take(job); }, Qt::QueuedConnection);
        job->isDone = true;
    };
    try {
        job->thread = std::thread(std::move(work));
        m_jobs.push_back(job);
    } catch (const std::system_error &) {
        job->isOutOfMemory = true;
        QMetaObject::invokeMethod(
            this, [this, job] { take(job); }, Qt::QueuedConnection);
    }
    return true;
}

void MapMaker::take(const std::shared_ptr<Job> &job)
{
    if (job != m_job)
        return; // another one is wanted by now, or none
    m_job.reset();
    m_seen = job->seen;
    if (job->isOutOfMemory)
        emit outOfMemory();
    else if (job->error)
        emit failed(*job->error);
    else if (job->made)
        emit made(job->made);
}

} // namespace unprojector::gui
