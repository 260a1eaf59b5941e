#include "gui/document/scene_opener.h"

#include "core/files/path_text.h"
#include "core/scene_file/scene_error_text.h"
#include "gui/document/landmark_objects.h"
#include "gui/document/object_names.h"
#include "gui/text/error_text.h"
#include "gui/text/note_text.h"
#include "gui/text/sentences.h"

#include <algorithm>
#include <utility>

namespace unprojector::gui {
namespace {

std::vector<SceneObject> objectsOf(const std::vector<LoadedModel> &models)
{
    std::vector<SceneObject> objects;
    for (const LoadedModel &loaded : models)
        objects.push_back({freeName(pathText(loaded.file.filename()).toStdString(), objects),
                           absolutePath(loaded.file),
                           loaded.model,
                           {}});
    return objects;
}

/// @return why there is no scene, in words
Result<Scene, QString> sceneOf(const Opening &asked, const std::vector<LoadedModel> &models)
{
    const SceneOrigin &origin = asked.origin;
    auto objects = opening::objectsOf(asked.contents, origin.file, [&models](const std::filesystem::path &file) {
        const auto isIt = [&file](const LoadedModel &loaded) { return loaded.file == file; };
        return opening::ReadModel(std::find_if(models.begin(), models.end(), isIt)->model);
    });
    if (!objects)
        return SceneOpener::tr("%1: %2").arg(origin.name, ended(objects.error()));
    Result<Scene, SceneFileError> scene = sceneFromFile(asked.contents, origin.file, std::move(objects).value());
    if (!scene) {
        SceneFileError reason = scene.error();
        reason.file = origin.name.toStdString();
        return errorText(reason);
    }
    return std::move(scene).value();
}

} // namespace

std::filesystem::path absolutePath(const std::filesystem::path &file)
{
    std::error_code error;
    std::filesystem::path absolute = std::filesystem::absolute(file, error);
    return error ? file : absolute;
}

QString namesText(const QString &first, int others)
{
    return others == 0 ? first : SceneOpener::tr("%1 and %n more", nullptr, others).arg(first);
}

SceneOpener::SceneOpener()
{
    connect(&m_loader, &ModelLoader::started, this, &SceneOpener::started);
    connect(&m_loader, &ModelLoader::progressed, this, &SceneOpener::progressed);
    connect(&m_loader, &ModelLoader::finished, this, &SceneOpener::finish);
    connect(&m_loader, &ModelLoader::cancelled, this, &SceneOpener::end);
    connect(&m_loader, &ModelLoader::jobFailed, this, [this](const JobFailure &failure) {
        emit failed(
            tr("The files cannot be opened: %1. Close other programs, then try again.").arg(failureText(failure)));
        end();
    });
}

Result<Opening, QString> SceneOpener::readScene(const std::filesystem::path &file)
{
    Opening opening{Opening::Kind::SceneFile, {pathText(file.filename()), absolutePath(file)}};
    // Taken before it is read, so that what changes in between is seen as a change.
    std::error_code error;
    if (std::filesystem::file_size(opening.origin.file, error) <= kMostSceneBytes && !error)
        opening.origin.stamp = files::stampOf(opening.origin.file);
    Result<SceneFile, SceneFileError> scene = readSceneFile(file);
    if (!scene)
        return QString::fromStdString(sceneErrorText(scene.error()));
    if (const auto reason = whyNotShown(*scene, files::utf8FromPath(file.filename())))
        return errorText(*reason);
    opening.contents = std::move(scene).value();
    return opening;
}

void SceneOpener::load(Opening asked)
{
    m_loader.cancel(); // it would take what this is for
    m_opening = std::move(asked);
    if (m_opening.kind == Opening::Kind::SceneFile)
        m_opening.models = opening::modelFiles(m_opening.contents, m_opening.origin.file);
    // A scene of bundled models alone names no file. The loader then has nothing to read and reports that it is done.
    m_loader.load(m_opening.models);
}

void SceneOpener::end()
{
    m_opening = {};
    emit ended();
}

QString SceneOpener::name() const
{
    if (m_opening.kind == Opening::Kind::SceneFile || m_opening.models.empty())
        return m_opening.origin.name;
    return namesText(pathText(m_opening.models.front().filename()), static_cast<int>(m_opening.models.size()) - 1);
}

void SceneOpener::finish(const std::vector<LoadedModel> &models, const std::vector<ImportError> &errors)
{
    Opened read{std::exchange(m_opening, {})};
    for (const ImportError &error : errors)
        read.errors << errorText(error);
    if (read.opening.kind != Opening::Kind::SceneFile) {
        read.objects = objectsOf(models);
    } else if (errors.empty()) {
        if (Result<Scene, QString> scene = sceneOf(read.opening, models)) {
            read.scene = std::move(scene).value();
            if (const QString loose = letGo(read.scene->landmarks.landmarks, read.scene->objects); !loose.isEmpty())
                read.notes << tr("%1: %2").arg(read.opening.origin.name, loose);
        } else {
            read.errors << scene.error();
        }
    }
    for (const LoadedModel &loaded : models) {
        if (const QString notes = notesText(pathText(loaded.file.filename()), loaded.model->notes); !notes.isEmpty())
            read.notes << notes;
    }
    emit opened(read);
    emit ended();
}

} // namespace unprojector::gui
