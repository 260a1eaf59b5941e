#include "gui/shading/model_curvatures.h"

#include <algorithm>

namespace unprojector::gui {
using namespace mesh;

void ModelCurvatures::prepare(const ModelList &models)
{
    std::erase_if(m_all, [](const auto &entry) { return entry.first.expired(); });
    ModelList missing;
    for (const std::shared_ptr<const Model> &model : models) {
        if (!m_all.contains(model) && std::find(missing.begin(), missing.end(), model) == missing.end())
            missing.push_back(model);
    }
    const bool isSame = std::equal(missing.begin(), missing.end(), m_waiting.begin(), m_waiting.end(),
                                   [](const auto &model, const auto &waiting) { return model == waiting.lock(); });
    if (isSame)
        return; // already under way
    cancel();
    m_waiting.assign(missing.begin(), missing.end());
    for (const std::shared_ptr<const Model> &model : missing)
        m_size += static_cast<double>(model->triangleCount());
    for (const std::shared_ptr<const Model> &model : missing)
        begin(model);
}

void ModelCurvatures::begin(const std::shared_ptr<const Model> &model)
{
    const auto size = static_cast<double>(model->triangleCount());
    m_background.start(
        [model](Job &job) {
            return std::make_shared<const Curvature>(
                curvatureOf(*model, [&job](double share) { return job.report(share); }));
        },
        [this, size, model = std::weak_ptr(model)](const JobResult<std::shared_ptr<const Curvature>> &curvature) {
            std::erase_if(m_waiting, [&model](const auto &waiting) {
                return !waiting.owner_before(model) && !model.owner_before(waiting);
            });
            m_done += size;
            if (curvature)
                m_all[model] = *curvature;
            else
                emit jobFailed(curvature.error());
            emit changed();
        },
        [this, size](double share) { emit progressed(m_size > 0.0 ? (m_done + share * size) / m_size : share); });
}

void ModelCurvatures::cancel()
{
    m_background.cancel();
    m_waiting.clear();
    m_size = m_done = 0.0;
}

} // namespace unprojector::gui
