#include "gui/document/session.h"

#include "core/examples/examples.h"
#include "gui/document/camera_looks.h"
#include "gui/document/landmark_files.h"
#include "gui/document/picks.h"
#include "gui/document/recent_files.h"
#include "gui/document/scene_document.h"
#include "gui/document/scene_edits.h"
#include "gui/text/added_text.h"
#include "gui/text/error_text.h"
#include "gui/text/sentences.h"

#include <QCoreApplication>
#include <QDir>

#include <algorithm>
#include <utility>

namespace unprojector::gui {
using namespace geometry;
using namespace scene;
using namespace scene_file;

Session::Session(SceneDocument &document, SessionQuestions &questions, const Options &options, QObject *parent)
    : QObject(parent), m_document(document), m_questions(questions),
      m_options(options), m_origin{tr("the scene")} // until a scene is opened
{
    connect(&m_opener, &SceneOpener::started, this, &Session::loadingStarted);
    connect(&m_opener, &SceneOpener::progressed, this, &Session::loadingProgressed);
    connect(&m_opener, &SceneOpener::opened, this, &Session::show);
    connect(&m_opener, &SceneOpener::ended, this, &Session::loadingEnded);
    connect(&m_models, &ModelStore::jobFailed, this, [this](const JobFailure &failure) {
        emit noticed(tr("Large models are not simplified while the view moves: %1.").arg(failureText(failure)));
    });
    createAutosave();
    connect(&m_document, &SceneDocument::changed, this, [this](Changes changes) {
        if (changes & Change::History)
            followChanges();
        if ((changes & Change::Landmarks) && m_autosave) // each one is work that cannot be repeated exactly
            m_autosave->hurry();
    });
}

Session::~Session() = default;

bool Session::hasUnsavedChanges() const
{
    // Looking at a model from all sides leaves nothing to save; a scene with a file is someone's
    // work.
    return m_origin.file.empty() ? m_document.isEdited() : m_document.isModified();
}

// ---- opening ------------------------------------------------------------------------------------

void Session::openFiles(std::vector<std::filesystem::path> files)
{
    const auto points = std::stable_partition(files.begin(), files.end(), [](const std::filesystem::path &file) {
        return !LandmarkFiles::isLandmarkFile(file) && !LandmarkFiles::isTemplate(file);
    });
    std::vector<std::filesystem::path> landmarkFiles(points, files.end());
    files.erase(points, files.end());
    if (files.empty() && !landmarkFiles.empty()) {
        emit progressed();
        emit landmarkFilesOpened(landmarkFiles);
        return;
    }
    const auto scene = std::find_if(files.begin(), files.end(), opening::isMeantAsScene);
    if (scene != files.end()) {
        openScene(*scene, std::move(landmarkFiles));
        return;
    }
    emit progressed();
    Opening opening;
    opening.models = std::move(files);
    opening.landmarkFiles = std::move(landmarkFiles);
    m_opener.load(std::move(opening));
}

void Session::addFiles(std::vector<std::filesystem::path> files)
{
    emit progressed();
    Opening opening{Opening::Kind::Addition};
    opening.models = std::move(files);
    m_opener.load(std::move(opening));
}

void Session::openScene(const std::filesystem::path &file, std::vector<std::filesystem::path> landmarkFiles)
{
    m_opener.cancel(); // it would replace the scene later
    emit progressed();
    Result<Opening, QString> scene = SceneOpener::readScene(file);
    if (!scene) {
        emit failed(scene.error());
        return;
    }
    if (!mayLeave())
        return;
    Opening opening = std::move(scene).value();
    opening.landmarkFiles = std::move(landmarkFiles);
    m_opener.load(std::move(opening));
}

void Session::openBundledScene()
{
    if (!mayLeave())
        return;
    emit progressed();
    openObjects(m_document, examples::bundledScene(),
                {WorldPoint(6.5, 5.0, 10.5), WorldPoint(0.5, 0.9, 0.0), {0.0, 1.0, 0.0}});
    setScene({tr("Bundled scene")});
}

bool Session::openLesson(Scene scene, const QString &name, const QString &lesson)
{
    emit progressed();
    std::optional<SceneAside> before; // its file keeps the changes while they are saved nowhere else
    if (!m_aside)
        before = {m_document.ownScene(), m_document.picks().keptPick(), m_origin, hasUnsavedChanges(),
                  m_autosave ? m_autosave->release() : nullptr};
    if (const Check shown = m_document.open(std::move(scene)); !shown) {
        if (before && before->recovery)
            m_autosave->adopt(std::move(before->recovery));
        followChanges(); // retries changes that could not be written when the file was given away
        emit failed(errorText(shown.error()));
        return false;
    }
    if (before)
        m_aside = std::move(before);
    setScene({name}, lesson);
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
    setScene(before.origin, {}, true);
    m_document.picks().putBack(std::move(before.pick));
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
    if (!m_origin.file.empty() || name == m_origin.name)
        return;
    m_origin.name = name;
    emit changed();
}

void Session::cancelLoading()
{
    if (!m_opener.isLoading())
        return;
    const QString name = m_opener.name();
    m_opener.cancel();
    emit noticed(tr("Opening of %1 cancelled. The scene is as it was.").arg(name));
}

void Session::show(Opened opened)
{
    bool isShown = false;
    if (opened.scene)
        isShown = showScene(opened);
    else if (opened.opening.kind == Opening::Kind::Addition)
        addModels(std::move(opened.objects));
    else
        isShown = showModels(std::move(opened.objects));
    // Import notes stay visible until the user closes them, as errors do.
    const QStringList reasons = opened.errors + opened.notes;
    if (!opened.errors.isEmpty())
        emit failed(reasons.join(u'\n'));
    else if (!reasons.isEmpty())
        emit warned(reasons.join(u'\n'));
    if (isShown && !opened.opening.landmarkFiles.empty()) // they belong only to these models
        emit landmarkFilesOpened(opened.opening.landmarkFiles);
}

bool Session::showModels(std::vector<SceneObject> objects)
{
    if (objects.empty() || !mayLeave())
        return false;
    for (const SceneObject &object : objects)
        rememberRecent(object.file);
    const QString name = namesText(QString::fromStdString(objects.front().name), static_cast<int>(objects.size()) - 1);
    openObjects(m_document, std::move(objects));
    setScene({name});
    if (const QString sizes = sizesText(m_document.objects(), m_document.objects().size()); !sizes.isEmpty())
        emit noticed(sizes);
    return true;
}

void Session::addModels(std::vector<SceneObject> objects)
{
    if (objects.empty())
        return;
    for (const SceneObject &object : objects)
        rememberRecent(object.file);
    const std::size_t count = objects.size();
    if (const Check added = addObjects(m_document, std::move(objects)))
        emit noticed(addedText(m_document.objects(), count));
    else
        emit failed(errorText(added.error()));
}

bool Session::showScene(Opened &opened)
{
    const Opening &opening = opened.opening;
    if (const Check shown = m_document.open(*std::move(opened.scene)); !shown) {
        opened.errors << tr("%1: %2").arg(opening.origin.name, errorText(shown.error()));
        return false;
    }
    setScene(opening.origin);
    if (opening.recovered) {
        const std::optional<RecoveryInfo> info = opening.recovered->info();
        takeRecovered(opening.recovered);
        if (info && info->series && m_keeper)
            m_keeper->resume(*info->series);
    } else {
        rememberRecent(opening.origin.file);
    }
    return true;
}

void Session::setScene(const SceneOrigin &origin, const QString &lesson, bool isBack)
{
    if (lesson.isEmpty())
        dropAside();
    m_origin = origin;
    m_document.markSaved();
    emit opened(lesson, isBack);
}

// ---- saving -------------------------------------------------------------------------------------

bool Session::save()
{
    if (m_origin.file.empty() && m_keeper) {
        if (const std::optional<bool> saved = m_keeper->save())
            return *saved;
    }
    return saveToScene();
}

bool Session::saveToScene()
{
    return m_origin.file.empty() ? saveAs() : saveScene(m_origin.file);
}

/// Beside the first model that came from a file, with its name.
std::filesystem::path Session::proposedName() const
{
    for (const SceneObject &object : m_document.objects()) {
        if (!object.file.empty())
            return std::filesystem::path(object.file).replace_extension(".json");
    }
    return "scene.json";
}

bool Session::saveAs()
{
    m_opener.cancel(); // it could replace the scene during the question
    const std::filesystem::path named = m_questions.askFileName(m_origin.file.empty() ? proposedName() : m_origin.file);
    if (named.empty())
        return false;
    std::filesystem::path file = named;
    if (!file.has_extension())
        file += ".json";
    std::error_code error;
    if (file != named && std::filesystem::exists(file, error) && !m_questions.askOverwrite(file))
        return false;
    return saveScene(file);
}

bool Session::saveScene(const std::filesystem::path &file)
{
    emit commitPendingEdits();
    if (m_keeper)
        static_cast<void>(m_keeper->keepBeforeLeaving()); // the scene has them too
    const std::filesystem::path path = absolutePath(file);
    const SceneFile contents = sceneFileFrom(m_document.ownScene(), m_document.ownSetup(), path);
    const std::optional<base::FileStamp> onlyIf = path == m_origin.file ? m_origin.stamp : std::nullopt;
    base::Expected<base::FileStamp, base::Error> written = writeSceneFile(path, contents, onlyIf);
    if (!written && written.error().kind == base::Error::Kind::Changed) {
        if (!m_questions.askOverwriteChanged(path))
            return false;
        written = writeSceneFile(path, contents);
    }
    if (!written) {
        emit failed(QString::fromStdString(written.error().message()));
        return false;
    }
    emit progressed();
    rememberRecent(path);
    if (const QString dropped = droppedMatrices(); !dropped.isEmpty())
        emit noticed(dropped);
    m_origin = {pathText(path.filename()), path, written.value()};
    m_document.markSaved();
    return true;
}

QString Session::droppedMatrices() const
{
    const Scene own = m_document.ownScene();
    const bool projection = own.projection.hadMatrix(), view = own.camera.hadMatrix();
    if (projection && view)
        return tr("Saved. The projection and the view have changed since they were given as matrices; they are saved "
                  "as arguments.");
    if (projection)
        return tr("Saved. The projection has changed since it was given as a matrix; it is saved as arguments.");
    if (view)
        return tr("Saved. The view has changed since it was given as a matrix; it is saved as eye, center and up.");
    return {};
}

bool Session::mayLeave()
{
    if (!m_aside)
        return finishBeforeLeaving() && mayLoseChanges();
    if (!mayLeaveStep())
        return false;
    if (!m_options.remembers || !m_aside->isUnsaved)
        return true;
    // It is restored only to be saved: a user who cancels continues with the lesson.
    return mayLoseChanges(m_aside->origin.name, !m_aside->origin.file.empty(),
                          [this] { return comeBack() && saveToScene(); });
}

bool Session::mayLeaveStep()
{
    return finishBeforeLeaving() && (!m_aside || m_origin.file.empty() || mayLoseChanges());
}

bool Session::finishBeforeLeaving()
{
    m_opener.cancel(); // it could replace the scene during the question
    emit commitPendingEdits();
    return !m_keeper || m_keeper->keepBeforeLeaving();
}

bool Session::mayLoseChanges()
{
    if (!m_options.remembers || !hasUnsavedChanges())
        return true;
    return mayLoseChanges(name(), !m_origin.file.empty(), [this] { return saveToScene(); });
}

bool Session::mayLoseChanges(const QString &name, bool hasFile, const std::function<bool()> &save)
{
    switch (m_questions.askSave(name, hasFile)) {
    case SessionQuestions::SaveAnswer::Save: return save();
    case SessionQuestions::SaveAnswer::Discard: return true;
    case SessionQuestions::SaveAnswer::Cancel: return false;
    }
    return false;
}

void Session::end()
{
    if (m_autosave)
        m_autosave->discard();
    dropAside();
}

// ---- recent files -------------------------------------------------------------------------------

QStringList Session::recentFiles() const
{
    return m_options.remembers ? gui::recentFiles() : QStringList();
}

void Session::clearRecentFiles()
{
    gui::clearRecentFiles();
    emit recentFilesChanged();
}

void Session::rememberRecent(const std::filesystem::path &file)
{
    if (!m_options.remembers)
        return;
    addRecentFile(QString::fromStdU16String(absolutePath(file).u16string()));
    emit recentFilesChanged();
}

// ---- crash recovery -----------------------------------------------------------------------------

void Session::createAutosave()
{
    QString folder = m_options.recoveryFolder;
    if (folder.isEmpty() && m_options.remembers)
        folder = RecoveryFile::defaultFolder(QCoreApplication::applicationDirPath());
    if (folder.isEmpty())
        return;
    m_autosave = new Autosave(
        folder, m_options.autosave, [this] { return unsavedContent(); }, this);
    connect(m_autosave, &Autosave::failed, this, [this](const QString &reason) {
        emit warned(joinSentences({tr("Unsaved changes are not protected from a crash, because they cannot be kept."),
                                   ended(reason.toStdString()), tr("Save the scene.")}));
    });
}

void Session::followChanges()
{
    if (m_autosave)
        m_autosave->follow(hasUnsavedChanges());
    emit changed();
}

SceneFile Session::contents() const
{
    return sceneFileFrom(m_document.ownScene(), m_document.ownSetup(), m_origin.file);
}

Result<Autosave::Content, QString> Session::unsavedContent() const
{
    base::Expected<std::string, base::Error> text = sceneText(contents());
    if (!text) {
        base::Error error = text.error();
        error.file = name().toStdString();
        return QString::fromStdString(error.message());
    }
    return Autosave::Content{{name(), m_origin.file, QDateTime::currentDateTime(), m_origin.stamp,
                              m_keeper ? m_keeper->series() : std::nullopt},
                             std::move(text).value()};
}

void Session::offerRecovery()
{
    if (!m_autosave)
        return;
    QStringList damaged;
    for (std::unique_ptr<RecoveryFile> &file : RecoveryFile::abandonedIn(m_autosave->folder())) {
        if (file->info())
            m_offered.push_back(std::move(file));
        else
            damaged << tr("Unsaved changes of an earlier session are damaged and cannot be recovered. The file was "
                          "kept as %1.")
                           .arg(QDir::toNativeSeparators(file->putAside()));
    }
    emit offeredChanged();
    if (!damaged.isEmpty())
        emit failed(damaged.join(u'\n'));
}

std::vector<RecoveryInfo> Session::offered() const
{
    std::vector<RecoveryInfo> infos;
    for (const std::unique_ptr<RecoveryFile> &file : m_offered)
        infos.push_back(file->info().value_or(RecoveryInfo{}));
    return infos;
}

std::unique_ptr<RecoveryFile> Session::takeOffered(std::size_t index)
{
    std::unique_ptr<RecoveryFile> file = std::move(m_offered.at(index));
    m_offered.erase(m_offered.begin() + static_cast<std::ptrdiff_t>(index));
    emit offeredChanged();
    return file;
}

void Session::recover(std::size_t index)
{
    m_opener.cancel(); // it would replace the scene later
    const RecoveryFile &file = *m_offered.at(index);
    const std::optional<RecoveryInfo> info = file.info();
    SceneOrError scene = file.scene();
    if (!info || !scene) {
        const QString reason = scene ? QString() : QString::fromStdString(scene.error().message());
        const QString aside = takeOffered(index)->putAside();
        emit failed(tr("The unsaved changes are damaged and cannot be recovered. The file was kept as %1.\n%2")
                        .arg(QDir::toNativeSeparators(aside), reason));
        return;
    }
    if (!mayLeave())
        return;
    emit progressed();
    m_opener.load(
        {Opening::Kind::SceneFile, {info->name, info->sceneFile, info->stamp}, std::move(scene).value(), &file});
}

void Session::takeRecovered(const RecoveryFile *file)
{
    const auto found =
        std::find_if(m_offered.begin(), m_offered.end(), [file](const auto &offer) { return offer.get() == file; });
    if (found != m_offered.end())
        m_autosave->adopt(takeOffered(static_cast<std::size_t>(found - m_offered.begin())));
    m_document.markUnsaved();
}

void Session::discardOffered(std::size_t index)
{
    const QString lost = m_offered.at(index)->info().value_or(RecoveryInfo{}).lostText();
    if (m_questions.askDeleteKept(lost))
        takeOffered(index)->remove();
}

void Session::postponeOffered()
{
    m_offered.clear();
    emit offeredChanged();
}

} // namespace unprojector::gui
