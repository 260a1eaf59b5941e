#include "gui/map/map_maker.h"

#include "gui/document/picks.h"

#include <optional>
#include <utility>

namespace unprojector::gui {
using namespace geometry;
using namespace scene;
using namespace unproject;

/// The ray hits of a setup. It keeps the models alive.
struct MapMaker::Seen {
    std::vector<SceneObject> objects;
    Unprojector unprojector;
    ray::SceneRays rays;
    std::optional<maps::SurfaceImage> surfaces; ///< once computed
};

struct MapMaker::Answer {
    std::shared_ptr<const Seen> seen;    ///< with surfaces, if they could be computed
    std::shared_ptr<const MadeMap> made; ///< null: cancelled, or without a map
    std::optional<Error> error;
};

/// @param seen  without surfaces: they are computed first
MapMaker::Answer MapMaker::answerOf(const maps::Question &question, std::shared_ptr<const Seen> seen, Job &job)
{
    const bool areMet = seen->surfaces.has_value();
    if (!areMet) {
        const Result<maps::PixelRays> pixels = maps::PixelRays::of(seen->rays.rays());
        if (!pixels)
            return {seen, nullptr, pixels.error()};
        std::optional<maps::SurfaceImage> surfaces =
            maps::surfacesMet(seen->rays, *pixels, {}, [&](double share) { return job.report(share / 2.0); });
        if (!surfaces)
            return {seen, nullptr, std::nullopt};
        seen = std::make_shared<const Seen>(Seen{seen->objects, seen->unprojector, seen->rays, std::move(surfaces)});
    }
    const auto map = maps::pixelMap(question, seen->unprojector, *seen->surfaces, seen->objects,
                                    [&](double share) { return job.report(areMet ? share : 0.5 + share / 2.0); });
    if (!map)
        return {seen, nullptr, map.error()};
    if (!*map)
        return {seen, nullptr, std::nullopt};
    const MadeMap made{**map, maps::statisticsOf(**map), question, seen->unprojector.setup(), seen->rays.hasPoints()};
    return {seen, std::make_shared<const MadeMap>(made), std::nullopt};
}

MapMaker::MapMaker(const SceneDocument &document, QObject *parent) : QObject(parent), m_document(document)
{
    connect(&m_document, &SceneDocument::changed, this, [this](Changes changes) {
        if (changes & (kVisibleChanges | Change::Preview)) {
            cancel();
            m_seen.reset(); // it also holds the models of a removed scene
        }
    });
}

bool MapMaker::ask(const maps::Question &question)
{
    cancel();
    if (!m_seen) {
        const ray::SceneRays *rays = m_document.picks().rays();
        if (rays == nullptr)
            return false;
        m_seen =
            std::make_shared<const Seen>(Seen{m_document.objects(), m_document.unprojector(), *rays, std::nullopt});
    }
    m_background.start([question, seen = m_seen](Job &job) { return answerOf(question, seen, job); },
                       [this](const JobResult<Answer> &answer) {
                           if (!answer) {
                               emit jobFailed(answer.error());
                               return;
                           }
                           m_seen = answer->seen;
                           if (answer->error)
                               emit failed(*answer->error);
                           else if (answer->made)
                               emit made(answer->made);
                       },
                       [this](double share) { emit progressed(share); });
    return true;
}

} // namespace unprojector::gui
