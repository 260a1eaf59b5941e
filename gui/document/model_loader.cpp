#include "gui/document/model_loader.h"

#include "gui/document/model_store.h"
#include "gui/document/texture_decoding.h"
#include "gui/text/error_text.h"

#include <algorithm>
#include <new>
#include <optional>
#include <utility>

namespace unprojector::gui {
namespace {

struct Read {
    std::vector<LoadedModel> models;
    std::vector<std::optional<ModelStore::FileState>> states; ///< of the models' files
    std::vector<ImportError> errors;
};

using Opened = Result<std::shared_ptr<const Model>, ImportError>;

/// A model with its textures.
Opened decodedModel(const std::filesystem::path &file, const ImportProgress &progress, const Job &job)
{
    auto imported = importModel(file, progress);
    if (!imported)
        return imported.error();
    const std::shared_ptr<Model> model = std::move(imported).value();
    try {
        decodeTextures(*model, [&job] { return !job.isCancelled(); });
    } catch (const std::bad_alloc &) { // the other files may be small
        return ImportError{ImportErrorCode::OutOfMemory, file, {}};
    }
    return std::shared_ptr<const Model>(model);
}

} // namespace

ModelLoader::ModelLoader(ModelStore &store, QObject *parent) : QObject(parent), m_store(store) {}

void ModelLoader::load(std::vector<std::filesystem::path> files)
{
    cancel();
    std::vector<std::shared_ptr<const Model>> held;
    QStringList names;
    for (const std::filesystem::path &file : files) {
        held.push_back(m_store.find(file));
        names << pathText(file.filename());
    }
    const auto count = static_cast<double>(files.size());
    const auto work = [files = std::move(files), held = std::move(held), count](Job &job) {
        Read read;
        for (std::size_t i = 0; i < files.size() && !job.isCancelled(); ++i) {
            const std::optional<ModelStore::FileState> state = ModelStore::stateOf(files[i]);
            const auto progress = [&](double share) { return job.report((static_cast<double>(i) + share) / count); };
            const Opened model = held[i] ? Opened(held[i]) : decodedModel(files[i], progress, job);
            if (!model) {
                read.errors.push_back(model.error());
                continue;
            }
            read.models.push_back({files[i], *model});
            read.states.push_back(state);
        }
        return read;
    };
    const auto done = [this](const JobResult<Read> &read) {
        if (!read) {
            emit jobFailed(read.error());
            return;
        }
        for (std::size_t i = 0; i < read->models.size(); ++i)
            m_store.keep(read->models[i].file, read->states[i], read->models[i].model);
        emit finished(read->models, read->errors);
    };
    m_background.start(work, done, [this, names, count](double share) {
        const auto place = std::min(static_cast<qsizetype>(share * count), names.size() - 1);
        emit progressed(names[place], share);
    });
    emit started();
}

void ModelLoader::cancel()
{
    if (!isLoading())
        return;
    m_background.cancel();
    emit cancelled();
}

} // namespace unprojector::gui
