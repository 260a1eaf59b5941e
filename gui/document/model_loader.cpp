#include "gui/document/model_loader.h"

#include "gui/document/texture_decoding.h"
#include "gui/text/error_text.h"

#include <algorithm>
#include <utility>

namespace unprojector::gui {
namespace {

struct Read {
    std::vector<LoadedModel> models;
    std::vector<ImportError> errors;
};

} // namespace

ModelLoader::ModelLoader(opening::ModelFiles &files, QObject *parent) : QObject(parent), m_files(files) {}

void ModelLoader::load(std::vector<std::filesystem::path> files)
{
    cancel();
    QStringList names;
    for (const std::filesystem::path &file : files)
        names << pathText(file.filename());
    const auto count = static_cast<double>(files.size());
    const auto work = [this, files = std::move(files), count](Job &job) {
        Read read;
        for (std::size_t i = 0; i < files.size() && !job.isCancelled(); ++i) {
            const auto progress = [&](double share) { return job.report((static_cast<double>(i) + share) / count); };
            const auto decode = [&job](Model &model) {
                decodeTextures(model, [&job] { return !job.isCancelled(); });
                return !job.isCancelled();
            };
            if (const opening::ReadModel model = m_files.read(files[i], progress, decode))
                read.models.push_back({files[i], *model});
            else
                read.errors.push_back(model.error());
        }
        return read;
    };
    const auto done = [this](const JobResult<Read> &read) {
        if (read)
            emit finished(read->models, read->errors);
        else
            emit jobFailed(read.error());
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
