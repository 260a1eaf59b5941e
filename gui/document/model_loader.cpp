#include "gui/document/model_loader.h"

#include "gui/document/model_store.h"
#include "gui/document/texture_decoding.h"
#include "gui/text/error_text.h"

#include <optional>

namespace unprojector::gui {

struct ModelLoader::Job {
    std::atomic<bool> isCancelled{false};
    std::atomic<bool> isDone{false};
    std::thread thread;
};

ModelLoader::ModelLoader(ModelStore &store, QObject *parent) : QObject(parent), m_store(store) {}

ModelLoader::~ModelLoader()
{
    for (const auto &job : m_jobs)
        job->isCancelled = true;
    reap(true);
}

/// Joins the threads that have ended, or waits for all of them to.
void ModelLoader::reap(bool all)
{
    std::erase_if(m_jobs, [all](const std::shared_ptr<Job> &job) {
        if (!all && !job->isDone)
            return false;
        job->thread.join();
        return true;
    });
}

void ModelLoader::load(std::vector<std::filesystem::path> files)
{
    cancel();
    reap(false);
    m_isLoading = true;
    emit started();

    const auto job = std::make_shared<Job>();
    m_jobs.push_back(job);
    // Every report is run by this object's thread, and only while the job is not cancelled: after a cancel nothing
    // of it arrives, although its thread may still be busy ending.
    const auto report = [this, job](auto action) {
        QMetaObject::invokeMethod(
            this,
            [job, action = std::move(action)] {
                if (!job->isCancelled)
                    action();
            },
            Qt::QueuedConnection);
    };
    std::vector<std::shared_ptr<const Model>> held;
    for (const std::filesystem::path &file : files)
        held.push_back(m_store.find(file));
    job->thread = std::thread([this, job, report, files = std::move(files), held = std::move(held)] {
        std::vector<LoadedModel> models;
        std::vector<std::optional<ModelStore::FileState>> states; // of the files of the models
        std::vector<ImportError> errors;
        for (std::size_t i = 0; i < files.size() && !job->isCancelled; ++i) {
            const QString name = pathText(files[i].filename());
            const std::optional<ModelStore::FileState> state = ModelStore::stateOf(files[i]);
            if (held[i]) {
                models.push_back({files[i], held[i]});
                states.push_back(state);
                continue;
            }
            double reported = -1.0;
            auto result = importModel(files[i], [&](double share) {
                const double total = (double(i) + share) / double(files.size());
                // A hundred reports are enough; each is an event for the window.
                if (total - reported >= 0.01) {
                    reported = total;
                    report([this, name, total] { emit progressed(name, total); });
                }
                return !job->isCancelled;
            });
            if (!result) {
                errors.push_back(result.error());
                continue;
            }
            const std::shared_ptr<Model> model = std::move(result).value();
            decodeTextures(*model, [&] { return !job->isCancelled; });
            models.push_back({files[i], model});
            states.push_back(state);
        }
        report([this, models = std::move(models), states = std::move(states), errors = std::move(errors)] {
            m_isLoading = false;
            for (std::size_t i = 0; i < models.size(); ++i)
                m_store.keep(models[i].file, states[i], models[i].model);
            emit finished(models, errors);
        });
        job->isDone = true;
    });
}

void ModelLoader::cancel()
{
    if (!m_isLoading)
        return;
    m_jobs.back()->isCancelled = true;
    m_isLoading = false;
    emit cancelled();
}

} // namespace unprojector::gui
