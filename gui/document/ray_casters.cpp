#include "gui/document/ray_casters.h"

#include <QTimer>

#include <algorithm>
#include <chrono>
#include <utility>

namespace unprojector::gui {
using namespace mesh;
using namespace scene;

namespace {

/// The time after which views have released their models.
constexpr std::chrono::milliseconds kUntilViewsLetGo{1000};

std::size_t sizeOf(const Model &model)
{
    return model.triangleCount() + model.pointCount();
}

/// Builds a caster that does not hold its model.
/// @return null if progress stops it. Throws std::bad_alloc.
RayCasters::Caster build(const Model &model, const ray::Progress &progress)
{
    return ray::RayCaster::build(std::shared_ptr<const Model>(std::shared_ptr<const Model>(), &model), progress);
}

JobResult<RayCasters::Caster> builtAtOnce(const Model &model)
{
    try {
        return build(model, {});
    } catch (...) {
        return failureOf(std::current_exception());
    }
}

} // namespace

RayCasters::RayCasters(QObject *parent) : QObject(parent) {}

const RayCasters::Kept *RayCasters::keptOf(const std::shared_ptr<const Model> &model) const
{
    const auto found = m_kept.find(model.get());
    return found != m_kept.end() && found->second.model.lock() == model ? &found->second : nullptr;
}

void RayCasters::keep(const std::shared_ptr<const Model> &model, Built caster)
{
    m_kept.insert_or_assign(model.get(), Kept{model, std::move(caster)});
    emit built();
}

std::vector<std::shared_ptr<const Model>> RayCasters::missing(const std::vector<SceneObject> &objects) const
{
    std::vector<std::shared_ptr<const Model>> models;
    // Another thread may have ended by now.
    const auto isKept = [this](const std::shared_ptr<const Model> &model) {
        const Kept *kept = keptOf(model);
        return kept && (kept->caster || kept->caster.error().kind != JobFailure::Kind::NoThread);
    };
    for (const SceneObject &object : objects) {
        if (!object.isHidden && !isKept(object.model)
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
    if (!m_kept.empty())
        QTimer::singleShot(kUntilViewsLetGo, this, &RayCasters::dropUnused);
    std::size_t atOnce = 0;
    std::vector<std::shared_ptr<const Model>> later;
    for (const std::shared_ptr<const Model> &model : missing(objects)) {
        if (atOnce + sizeOf(*model) > kMostAtOnce) {
            m_kept.erase(model.get()); // retries after a failure
            later.push_back(model);
            continue;
        }
        atOnce += sizeOf(*model);
        keep(model, builtAtOnce(*model));
    }
    const bool wasPreparing = isPreparing();
    const std::shared_ptr<const Model> underWay = wasPreparing ? m_underWay.lock() : nullptr;
    if (std::find(later.begin(), later.end(), underWay) == later.end())
        m_background.cancel();
    m_waiting.clear();
    m_all = m_done = 0.0;
    for (const std::shared_ptr<const Model> &model : later) {
        m_all += static_cast<double>(sizeOf(*model));
        if (model != underWay)
            m_waiting.push_back(model);
    }
    if (!isPreparing())
        begin();
    if (wasPreparing && !isPreparing())
        emit finished();
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
    m_underWay = model;
    const auto size = static_cast<double>(sizeOf(*model));
    m_background.start(
        [model = std::move(model)](Job &job) {
            return build(*model, [&](double share) {
                return job.report(share) && model.use_count() > 1; // else no object uses it any more
            });
        },
        [this, size](const Built &caster) { take(size, caster); },
        [this, size](double share) { emit progressed(std::min(1.0, (m_done + share * size) / m_all)); });
}

void RayCasters::take(double size, const Built &caster)
{
    m_done += size;
    if (const std::shared_ptr<const Model> model = m_underWay.lock()) {
        if (!caster || *caster)
            keep(model, caster);
        else
            m_waiting.push_back(model); // stopped while unused, and used again since
    }
    if (!isPreparing())
        begin();
    if (!isPreparing())
        emit finished();
}

void RayCasters::complete(const std::vector<SceneObject> &objects)
{
    require(objects);
    m_background.finish();
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
        const auto held = std::make_shared<const Held>(Held{object.model, *kept->caster});
        casters.emplace_back(held, held->caster.get());
    }
    return casters;
}

std::optional<JobFailure> RayCasters::failureOf(const std::vector<SceneObject> &objects) const
{
    for (const SceneObject &object : objects) {
        const Kept *kept = object.isHidden ? nullptr : keptOf(object.model);
        if (kept && !kept->caster)
            return kept->caster.error();
    }
    return std::nullopt;
}

void RayCasters::dropUnused()
{
    std::erase_if(m_kept, [](const auto &entry) { return entry.second.model.expired(); });
}

} // namespace unprojector::gui
