#include "gui/document/session.h"

#include "core/scene_file/scene_error_text.h"
#include "gui/document/recent_files.h"
#include "gui/document/scene_document.h"
#include "gui/text/error_text.h"

#include <QCoreApplication>
#include <QDir>

#include <algorithm>
#include <utility>

// The scene's name and file, its saving, and what is kept of its changes.

namespace unprojector::gui {

std::filesystem::path Session::absolutePath(const std::filesystem::path &file)
{
    std::error_code error;
    std::filesystem::path absolute = std::filesystem::absolute(file, error);
    return error ? file : absolute;
}

Session::Session(SceneDocument &document, SessionQuestions &questions, const Options &options, QObject *parent)
    : QObject(parent), m_document(document), m_questions(questions), m_options(options),
      m_name(tr("the scene")) // until one is opened
{
    connect(&m_loader, &ModelLoader::started, this, &Session::loadingStarted);
    connect(&m_loader, &ModelLoader::progressed, this, &Session::loadingProgressed);
    connect(&m_loader, &ModelLoader::finished, this, &Session::takeLoaded);
    connect(&m_loader, &ModelLoader::cancelled, this, &Session::giveUpPending);
    connect(&m_loader, &ModelLoader::jobFailed, this, [this](const JobFailure &failure) {
        emit failed(
            tr("The files cannot be opened: %1. Close other programs, then try again.").arg(failureText(failure)));
        giveUpPending();
    });
    connect(&m_models, &ModelStore::jobFailed, this, [this](const JobFailure &failure) {
        emit noticed(tr("Large models are not simplified while the view moves: %1.").arg(failureText(failure)));
    });
    createAutosave();
    connect(&m_document, &SceneDocument::changed, this, [this](Changes changes) {
        if (changes & Change::History)
            followChanges();
    });
}

Session::~Session() = default;

void Session::giveUpPending()
{
    m_pending.reset();
    emit loadingEnded();
}

bool Session::hasUnsavedChanges() const
{
    // Who only looks at a model from all sides has nothing to save; a scene with a file has an owner.
    return m_file.empty() ? m_document.isEdited() : m_document.isModified();
}

// ---- saving ------------------------------------------------------------------------------------------------------

bool Session::save()
{
    return m_file.empty() ? saveAs() : saveScene(m_file);
}

/// Beside the first model that came from a file, by its name.
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
    m_loader.cancel(); // it could replace the scene under the question
    const std::filesystem::path named = m_questions.askFileName(m_file.empty() ? proposedName() : m_file);
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
    emit typedToCount();
    emit aboutToSaveOrLeave();
    const std::filesystem::path path = absolutePath(file);
    const SceneFile contents = sceneFileFrom(m_document.scene(), m_document.picture(), path);
    const std::optional<files::FileStamp> onlyIf = path == m_file ? m_stamp : std::nullopt;
    Result<files::FileStamp, SceneFileError> written = writeSceneFile(path, contents, onlyIf);
    if (!written && written.error().code == SceneFileErrorCode::ChangedMeanwhile) {
        if (!m_questions.askOverwriteChanged(path))
            return false;
        written = writeSceneFile(path, contents);
    }
    if (!written) {
        emit failed(QString::fromStdString(sceneErrorText(written.error())));
        return false;
    }
    emit progressed();
    rememberRecent(path);
    if (const QString dropped = droppedMatrices(); !dropped.isEmpty())
        emit noticed(dropped);
    m_file = path;
    m_stamp = written.value();
    m_name = pathText(path.filename());
    m_document.markSaved();
    return true;
}

QString Session::droppedMatrices() const
{
    const bool projection = m_document.scene().projection.hadMatrix(), view = m_document.scene().camera.hadMatrix();
    if (projection && view)
        return tr("Saved. The projection and the view have changed since they came as matrices; they are written by "
                  "their arguments.");
    if (projection)
        return tr("Saved. The projection has changed since it came as a matrix; it is written by its arguments.");
    if (view)
        return tr("Saved. The view has changed since it came as a matrix; it is written as eye, center and up.");
    return {};
}

bool Session::mayLeave()
{
    if (!m_aside) {
        finishBeforeLeaving();
        return mayLoseChanges();
    }
    if (!mayLeaveStep())
        return false;
    if (!m_options.remembers || !m_aside->isUnsaved)
        return true;
    // It comes back only to be saved: who would rather stay goes on with the lesson.
    return mayLoseChanges(m_aside->name, !m_aside->file.empty(), [this] { return comeBack() && save(); });
}

bool Session::mayLeaveStep()
{
    finishBeforeLeaving();
    return !m_aside || m_file.empty() || mayLoseChanges();
}

void Session::finishBeforeLeaving()
{
    m_loader.cancel(); // it could replace the scene under the question
    emit typedToCount();
    emit aboutToSaveOrLeave();
}

bool Session::mayLoseChanges()
{
    if (!m_options.remembers || !hasUnsavedChanges())
        return true;
    return mayLoseChanges(name(), !m_file.empty(), [this] { return save(); });
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

// ---- recent files ------------------------------------------------------------------------------------------------

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

// ---- in case of a crash ------------------------------------------------------------------------------------------

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
        emit noticed(tr("In case of a crash unsaved changes would be lost. They cannot be kept: %1").arg(reason));
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
    return sceneFileFrom(m_document.scene(), m_document.picture(), m_file);
}

Result<Autosave::Content, QString> Session::unsavedContent() const
{
    Result<std::string, SceneFileError> text = sceneText(contents());
    if (!text) {
        SceneFileError error = text.error();
        error.file = name().toStdString();
        return QString::fromStdString(sceneErrorText(error));
    }
    return Autosave::Content{{name(), m_file, QDateTime::currentDateTime(), m_stamp}, std::move(text).value()};
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
            damaged << tr("Unsaved changes of an earlier session are damaged and cannot be recovered. The file was put "
                          "aside as %1.")
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

std::unique_ptr<RecoveryFile> Session::takeOffered(std::size_t place)
{
    std::unique_ptr<RecoveryFile> file = std::move(m_offered.at(place));
    m_offered.erase(m_offered.begin() + static_cast<std::ptrdiff_t>(place));
    emit offeredChanged();
    return file;
}

void Session::recover(std::size_t place)
{
    m_loader.cancel(); // it would replace the scene later, whatever becomes of this one
    const RecoveryFile &file = *m_offered.at(place);
    const std::optional<RecoveryInfo> info = file.info();
    Result<SceneFile, SceneFileError> scene = file.scene();
    if (!info || !scene) {
        const QString reason = scene ? QString() : QString::fromStdString(sceneErrorText(scene.error()));
        const QString aside = takeOffered(place)->putAside();
        emit failed(tr("The unsaved changes are damaged and cannot be recovered. The file was put aside as %1.\n%2")
                        .arg(QDir::toNativeSeparators(aside), reason));
        return;
    }
    if (!mayLeave())
        return;
    emit progressed();
    load({Pending::For::SceneFile, info->sceneFile, std::move(scene).value(), info->stamp, info->name, &file});
}

void Session::takeRecovered(const RecoveryFile *file)
{
    const auto found =
        std::find_if(m_offered.begin(), m_offered.end(), [file](const auto &offer) { return offer.get() == file; });
    if (found != m_offered.end())
        m_autosave->adopt(takeOffered(static_cast<std::size_t>(found - m_offered.begin())));
    m_document.markUnsaved();
}

void Session::discardOffered(std::size_t place)
{
    const QString name = m_offered.at(place)->info().value_or(RecoveryInfo{}).name;
    if (m_questions.askDeleteKept(name))
        takeOffered(place)->remove();
}

void Session::postponeOffered()
{
    m_offered.clear();
    emit offeredChanged();
}

} // namespace unprojector::gui
