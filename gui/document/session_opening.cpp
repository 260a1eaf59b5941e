// What a session opens: models, scenes, the bundled one, the lessons' steps.

#include "core/examples/bundled_scene.h"
#include "core/files/path_text.h"
#include "core/opening/models.h"
#include "core/scene_file/scene_error_text.h"
#include "gui/document/camera_looks.h"
#include "gui/document/landmark_objects.h"
#include "gui/document/point_files.h"
#include "gui/document/scene_document.h"
#include "gui/document/scene_edits.h"
#include "gui/document/session.h"
#include "gui/text/added_text.h"
#include "gui/text/error_text.h"
#include "gui/text/note_text.h"
#include "gui/text/sentences.h"

#include <algorithm>
#include <utility>

namespace unprojector::gui {
void Session::openFiles(std::vector<std::filesystem::path> files)
{
    const auto points = std::stable_partition(files.begin(), files.end(), [](const std::filesystem::path &file) {
        return !PointFiles::isPointFile(file) && !PointFiles::isTemplate(file);
    });
    std::vector<std::filesystem::path> pointFiles(points, files.end());
    files.erase(points, files.end());
    if (files.empty() && !pointFiles.empty()) {
        emit progressed();
        emit pointFilesOpened(pointFiles);
        return;
    }
    const auto scene = std::find_if(files.begin(), files.end(), opening::isMeantAsScene);
    if (scene != files.end()) {
        openScene(*scene, std::move(pointFiles));
        return;
    }
    emit progressed();
    Pending pending;
    pending.points = std::move(pointFiles);
    pending.models = std::move(files);
    load(std::move(pending));
}

void Session::addFiles(std::vector<std::filesystem::path> files)
{
    emit progressed();
    Pending pending;
    pending.use = Pending::For::Addition;
    pending.models = std::move(files);
    load(std::move(pending));
}

void Session::openScene(const std::filesystem::path &file, std::vector<std::filesystem::path> points)
{
    m_loader.cancel(); // it would replace the scene later, whatever becomes of this one
    emit progressed();
    const std::filesystem::path path = absolutePath(file);
    // Taken before it is read, so that what changes in between is seen as a change.
    std::error_code error;
    std::optional<files::FileStamp> stamp;
    if (std::filesystem::file_size(path, error) <= kMostSceneBytes && !error)
        stamp = files::stampOf(path);
    Result<SceneFile, SceneFileError> scene = readSceneFile(file);
    if (!scene) {
        emit failed(QString::fromStdString(sceneErrorText(scene.error())));
        return;
    }
    if (const auto reason = whyNotShown(*scene, files::utf8FromPath(file.filename()))) {
        emit failed(errorText(*reason));
        return;
    }
    if (!mayLeave())
        return;
    Pending pending{Pending::For::SceneFile, path, std::move(scene).value(), stamp, pathText(file.filename())};
    pending.points = std::move(points);
    load(std::move(pending));
}

void Session::openBundledScene()
{
    if (!mayLeave())
        return;
    emit progressed();
    openObjects(m_document, examples::bundledScene(),
                {WorldPoint(6.5, 5.0, 10.5), WorldPoint(0.5, 0.9, 0.0), {0.0, 1.0, 0.0}});
    setScene(tr("Bundled scene"));
}

bool Session::openLesson(Scene scene, const QString &name, const QString &lesson)
{
    emit progressed();
    std::optional<SceneAside> before; // its changes are kept in their file for as long as they are nowhere else
    if (!m_aside)
        before = {m_document.scene(),
                  m_name,
                  m_file,
                  m_stamp,
                  hasUnsavedChanges(),
                  m_autosave ? m_autosave->release() : nullptr};
    if (const Check shown = m_document.open(std::move(scene)); !shown) {
        if (before && before->recovery)
            m_autosave->adopt(std::move(before->recovery));
        followChanges(); // those that could not be written when the file was given away
        emit failed(errorText(shown.error()));
        return false;
    }
    if (before)
        m_aside = std::move(before);
    setScene(name, lesson);
    return true;
}

bool Session::comeBack()
{
    emit progressed();
    if (const Check shown = m_document.open(m_aside->scene); !shown) {
        emit failed(errorText(shown.error()));
        return false;
    }
    SceneAside before = *std::exchange(m_aside, std::nullopt);
    setScene(before.name, {}, before.file, before.stamp, true);
    if (before.recovery)
        m_autosave->adopt(std::move(before.recovery));
    if (before.isUnsaved)
        m_document.markUnsaved();
    return true;
}

void Session::dropAside()
{
    if (m_aside && m_aside->recovery)
        m_aside->recovery->remove();
    m_aside.reset();
}

void Session::nameStep(const QString &name)
{
    if (!m_file.empty() || name == m_name)
        return;
    m_name = name;
    emit changed();
}

void Session::cancelLoading()
{
    if (!m_pending)
        return;
    const QString name = nameOf(*m_pending);
    m_loader.cancel();
    emit noticed(tr("Opening of %1 cancelled. The scene is as it was.").arg(name));
}

QString Session::nameOf(const Pending &pending)
{
    if (pending.use == Pending::For::SceneFile || pending.models.empty())
        return pending.name;
    return namesText(pathText(pending.models.front().filename()), static_cast<int>(pending.models.size()) - 1);
}

QString Session::namesText(const QString &first, int others)
{
    return others == 0 ? first : tr("%1 and %n more", nullptr, others).arg(first);
}

void Session::load(Pending pending)
{
    m_loader.cancel(); // it would take what this is for
    if (pending.use == Pending::For::SceneFile)
        pending.models = opening::modelFiles(pending.contents, pending.path);
    std::vector<std::filesystem::path> models = pending.models;
    m_pending = std::move(pending);
    // A scene of bundled models alone names no file. The loader then has nothing to read and reports that it is done:
    // takeLoaded opens every scene.
    m_loader.load(std::move(models));
}

void Session::takeLoaded(const std::vector<LoadedModel> &models, const std::vector<ImportError> &errors)
{
    Pending pending = std::move(m_pending).value_or(Pending{});
    m_pending.reset();
    const std::vector<std::filesystem::path> points = std::move(pending.points);
    bool isShown = false;
    const auto shown = connect(this, &Session::opened, this,
                               [&isShown](const QString &, bool isBack) { isShown = isShown || !isBack; });
    QStringList reasons; // what is not as in a file stays to be read until it is closed, as reasons do
    if (pending.use != Pending::For::SceneFile)
        takeModels(models, pending.use);
    else if (errors.empty())
        reasons << takeScene(std::move(pending), models);
    reasons.removeAll(QString());
    disconnect(shown);
    for (const ImportError &error : errors)
        reasons << errorText(error);
    for (const LoadedModel &loaded : models) {
        if (const QString notes = notesText(pathText(loaded.file.filename()), loaded.model->notes); !notes.isEmpty())
            reasons << notes;
    }
    if (!errors.empty())
        emit failed(reasons.join(u'\n'));
    else if (!reasons.isEmpty())
        emit warned(reasons.join(u'\n'));
    if (isShown && !points.empty()) // to nothing else they belong
        emit pointFilesOpened(points);
    emit loadingEnded();
}

void Session::takeModels(const std::vector<LoadedModel> &models, Pending::For use)
{
    const bool isAddition = use == Pending::For::Addition;
    if (models.empty() || (!isAddition && !mayLeave()))
        return;
    std::vector<SceneObject> objects;
    for (const LoadedModel &loaded : models) {
        objects.push_back({freeName(pathText(loaded.file.filename()).toStdString(), objects),
                           absolutePath(loaded.file),
                           loaded.model,
                           {}});
        rememberRecent(loaded.file);
    }
    if (isAddition) {
        const std::size_t count = objects.size();
        if (const Check added = addObjects(m_document, std::move(objects)))
            emit noticed(addedText(m_document.objects(), count));
        else
            emit failed(errorText(added.error()));
        return;
    }
    const QString first = QString::fromStdString(objects.front().name);
    const int others = static_cast<int>(models.size()) - 1;
    openObjects(m_document, std::move(objects));
    setScene(namesText(first, others));
    if (const QString sizes = sizesText(m_document.objects(), m_document.objects().size()); !sizes.isEmpty())
        emit noticed(sizes);
}

QString Session::takeScene(Pending pending, const std::vector<LoadedModel> &models)
{
    auto objects = opening::objectsOf(pending.contents, pending.path, [&models](const std::filesystem::path &file) {
        const auto isIt = [&file](const LoadedModel &loaded) { return loaded.file == file; };
        return opening::ReadModel(std::find_if(models.begin(), models.end(), isIt)->model);
    });
    if (!objects) {
        emit failed(tr("%1: %2").arg(pending.name, ended(objects.error())));
        return {};
    }
    Result<Scene, SceneFileError> scene = sceneFromFile(pending.contents, pending.path, std::move(objects).value());
    if (!scene) {
        SceneFileError reason = scene.error();
        reason.file = pending.name.toStdString();
        emit failed(errorText(reason));
        return {};
    }
    Scene opened = std::move(scene).value();
    const QString loose = letGo(opened.landmarks.landmarks, opened.objects);
    if (const Check shown = m_document.open(std::move(opened)); !shown) {
        emit failed(tr("%1: %2").arg(pending.name, errorText(shown.error())));
        return {};
    }
    const QString name = pending.name;
    setScene(pending.name, {}, pending.path, pending.stamp);
    if (pending.recovered)
        takeRecovered(pending.recovered);
    else
        rememberRecent(pending.path);
    return loose.isEmpty() ? loose : tr("%1: %2").arg(name, loose);
}

void Session::setScene(const QString &name, const QString &lesson, const std::filesystem::path &file,
                       const std::optional<files::FileStamp> &stamp, bool isBack)
{
    if (lesson.isEmpty())
        dropAside();
    m_name = name;
    m_file = file;
    m_stamp = stamp;
    m_document.markSaved();
    emit opened(lesson, isBack);
}

} // namespace unprojector::gui
