#include "gui/document/scene_opener.h"

#include "core/base/path_text.h"
#include "core/scene_file/lost_keys.h"
#include "gui/document/landmark_objects.h"
#include "gui/document/object_names.h"
#include "gui/document/texture_decoding.h"
#include "gui/text/error_text.h"
#include "gui/text/note_text.h"
#include "gui/text/sentences.h"

#include <algorithm>
#include <utility>

namespace unprojector::gui {
using namespace geometry;
using namespace mesh;
using namespace scene;
using namespace scene_file;

namespace {

struct LoadedModel {
    std::filesystem::path file;
    opening::ModelPointer model;
};

/// The files that could be read, in the requested order, and the errors of the others.
struct Loaded {
    std::vector<LoadedModel> models;
    std::vector<base::Error> errors;
};

std::vector<SceneObject> objectsOf(const std::vector<LoadedModel> &models)
{
    std::vector<SceneObject> objects;
    objects.reserve(models.size());
    for (const LoadedModel &loaded : models)
        objects.push_back({freeName(pathText(loaded.file.filename()).toStdString(), objects),
                           absolutePath(loaded.file),
                           loaded.model,
                           {}});
    return objects;
}

/// @return the reason if there is no scene, in words
Result<Scene, QString> sceneOf(const Opening &asked, const std::vector<LoadedModel> &models)
{
    const SceneOrigin &origin = asked.origin;
    auto objects = opening::objectsOf(asked.contents, origin.file, [&models](const std::filesystem::path &file) {
        const auto isIt = [&file](const LoadedModel &loaded) { return loaded.file == file; };
        return opening::ReadModel(std::find_if(models.begin(), models.end(), isIt)->model);
    });
    if (!objects) {
        base::Error error = objects.error();
        error.file = origin.name.toStdString();
        return errorText(error);
    }
    base::Expected<Scene, base::Error> scene = sceneFromFile(asked.contents, origin.file, std::move(objects).value());
    if (!scene) {
        base::Error reason = scene.error();
        reason.file = origin.name.toStdString();
        return errorText(reason);
    }
    return std::move(scene).value();
}

/// Adds the note, if there are such keys.
void addNote(const std::vector<std::string> &keys, const QString &note, Opening &opening)
{
    if (!keys.empty())
        opening.notes << SceneOpener::tr("%1: %2").arg(
            opening.origin.name,
            note.arg(namesText(QString::fromStdString(keys.front()), static_cast<int>(keys.size()) - 1)));
}

void add(const Loaded &loaded, Opened &opened)
{
    for (const base::Error &error : loaded.errors)
        opened.errors << errorText(error);
    if (opened.opening.kind != Opening::Kind::SceneFile) {
        opened.objects = objectsOf(loaded.models);
    } else if (loaded.errors.empty()) {
        if (Result<Scene, QString> scene = sceneOf(opened.opening, loaded.models)) {
            opened.scene = std::move(scene).value();
            const QString loose = detachStale(opened.scene->landmarks.landmarks, opened.scene->objects);
            if (!loose.isEmpty())
                opened.notes << SceneOpener::tr("%1: %2").arg(opened.opening.origin.name, loose);
            opened.notes << opened.opening.notes;
        } else {
            opened.errors << scene.error();
        }
    }
    for (const LoadedModel &model : loaded.models) {
        if (const QString notes = notesText(pathText(model.file.filename()), model.model->notes); !notes.isEmpty())
            opened.notes << notes;
    }
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

Result<Opening, QString> SceneOpener::readScene(const std::filesystem::path &file)
{
    Opening opening{Opening::Kind::SceneFile, {pathText(file.filename()), absolutePath(file)}};
    // Taken before reading, so that a change in between is detected.
    std::error_code error;
    if (std::filesystem::file_size(opening.origin.file, error) <= kMostSceneBytes && !error)
        opening.origin.stamp = base::stampOf(opening.origin.file);
    const base::Expected<std::string, base::Error> text = readSceneText(file);
    if (!text)
        return QString::fromStdString(text.error().message());
    SceneOrError scene = parseScene(*text, base::utf8FromPath(file));
    if (!scene)
        return QString::fromStdString(scene.error().message());
    if (const auto reason = whyNotShown(*scene, base::utf8FromPath(file.filename())))
        return errorText(*reason);
    opening.contents = std::move(scene).value();
    const LostKeys lost = lostKeys(*text, opening.contents);
    addNote(lost.ofSteps, tr("%1: unknown key in a transform step; it is not saved."), opening);
    addNote(lost.ofPlanes, tr("%1: unknown key; it is not saved once the clip plane is switched on."), opening);
    return opening;
}

void SceneOpener::load(Opening asked)
{
    cancel();
    m_opening = std::move(asked);
    // A scene of bundled models alone names no file: then there is nothing to read.
    if (m_opening.kind == Opening::Kind::SceneFile)
        m_opening.models = opening::modelFiles(m_opening.contents, m_opening.origin.file);
    QStringList names;
    for (const std::filesystem::path &file : m_opening.models)
        names << pathText(file.filename());
    const auto count = static_cast<double>(names.size());
    const auto work = [this, files = m_opening.models, count](Job &job) {
        Loaded loaded;
        for (std::size_t i = 0; i < files.size() && !job.isCancelled(); ++i) {
            const auto progress = [&](double share) { return job.report((static_cast<double>(i) + share) / count); };
            const auto decode = [&job](Model &model) {
                decodeTextures(model, [&job] { return !job.isCancelled(); });
                return !job.isCancelled();
            };
            if (const opening::ReadModel model = m_modelFiles.read(files[i], progress, decode))
                loaded.models.push_back({files[i], *model});
            else
                loaded.errors.push_back(model.error());
        }
        return loaded;
    };
    const auto done = [this](const JobResult<Loaded> &loaded) {
        Opened result{std::exchange(m_opening, {})};
        if (loaded)
            add(*loaded, result);
        else
            result.errors << tr("The files cannot be opened: %1. Close other programs, then try again.")
                                 .arg(failureText(loaded.error()));
        emit opened(result);
        if (!isLoading()) // a receiver may have started the next one
            emit ended();
    };
    m_background.start(work, done, [this, names, count](double share) {
        const auto index = std::min(static_cast<qsizetype>(share * count), names.size() - 1);
        emit progressed(names[index], share);
    });
    emit started();
}

void SceneOpener::cancel()
{
    if (!isLoading())
        return;
    m_background.cancel();
    m_opening = {};
    emit ended();
}

QString SceneOpener::name() const
{
    if (m_opening.kind == Opening::Kind::SceneFile || m_opening.models.empty())
        return m_opening.origin.name;
    return namesText(pathText(m_opening.models.front().filename()), static_cast<int>(m_opening.models.size()) - 1);
}

} // namespace unprojector::gui
