#include "gui/document/model_store.h"

#include "core/base/parallel.h"
#include "core/mesh/stand_in.h"

#include <algorithm>

namespace unprojector::gui {
using namespace mesh;
using namespace scene;

namespace {

/// The size of all stand-ins of a scene together: a software renderer draws them about 25 times a
/// second.
constexpr std::size_t kStandInSize = 60'000;

std::size_t sizeOf(const Model &model)
{
    return model.triangleCount() + model.pointCount();
}

} // namespace

ModelStore::ModelStore(QObject *parent) : QObject(parent), m_background(base::coreCount()) {}

void ModelStore::dropUnused()
{
    std::erase_if(m_standIns, [](const auto &entry) { return entry.second.model.expired(); });
}

const ModelStore::StandIn *ModelStore::standInOf(const std::shared_ptr<const Model> &model) const
{
    const auto found = m_standIns.find(model.get());
    return found != m_standIns.end() && found->second.model.lock() == model ? &found->second : nullptr;
}

bool ModelStore::areLarge(const std::vector<SceneObject> &objects)
{
    std::size_t size = 0;
    for (const SceneObject &object : objects)
        size += object.isHidden ? 0 : sizeOf(*object.model);
    return size > kMostInMotion;
}

void ModelStore::makeStandIns(const std::vector<SceneObject> &objects)
{
    dropUnused();
    if (!areLarge(objects))
        return;
    std::size_t all = 0;
    for (const SceneObject &object : objects)
        all += sizeOf(*object.model);
    for (const SceneObject &object : objects) {
        if (standInOf(object.model))
            continue;
        // Each model gets a share by its size.
        const double share = static_cast<double>(sizeOf(*object.model)) / static_cast<double>(all);
        const auto most = static_cast<std::size_t>(share * static_cast<double>(kStandInSize));
        m_standIns[object.model.get()] = {object.model, nullptr};
        m_background.start(
            [model = object.model, most](Job &job) {
                return std::make_shared<const Model>(
                    standInFor(*model, most, [&job](double) { return !job.isCancelled(); }));
            },
            [this, model = std::weak_ptr(object.model)](const JobResult<std::shared_ptr<const Model>> &standIn) {
                if (!standIn) {
                    // Another thread may have ended before the next attempt.
                    if (standIn.error().kind == JobFailure::Kind::NoThread)
                        std::erase_if(m_standIns, [&model](const auto &entry) {
                            return entry.second.model.lock() == model.lock();
                        });
                    emit jobFailed(standIn.error());
                } else if (const std::shared_ptr<const Model> of = model.lock()) {
                    m_standIns[of.get()] = {of, *standIn};
                    emit standInReady();
                }
            });
    }
}

std::optional<std::vector<SceneObject>> ModelStore::standInsFor(const std::vector<SceneObject> &objects) const
{
    if (!areLarge(objects))
        return std::nullopt;
    std::vector<SceneObject> coarse = objects;
    for (SceneObject &object : coarse) {
        const StandIn *found = standInOf(object.model);
        if (!found || !found->standIn)
            return std::nullopt;
        object.model = found->standIn;
    }
    return coarse;
}

} // namespace unprojector::gui
