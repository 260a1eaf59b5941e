#pragma once

#include "gui/document/autosave.h"
#include "gui/document/kept_pick.h"
#include "gui/document/model_store.h"
#include "gui/document/scene_keeper.h"
#include "gui/document/scene_opener.h"

#include <QObject>
#include <QString>
#include <QStringList>

#include <cstddef>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace unprojector::gui {

class SceneDocument;

/// Questions that only the user can answer.
class SessionQuestions {
public:
    enum class SaveAnswer { Save, Discard, Cancel };

    virtual ~SessionQuestions() = default;
    /// Asks what to do with the unsaved changes of the named scene before it is left.
    /// @param hasFile  of a scene; else the name belongs to a model, which is never written
    virtual SaveAnswer askSave(const QString &name, bool hasFile) = 0;
    /// Asks for a file name to save under; empty: don't save.
    virtual std::filesystem::path askFileName(const std::filesystem::path &proposal) = 0;
    /// Asks whether to overwrite this file, whose name differs slightly from the given one.
    virtual bool askOverwrite(const std::filesystem::path &file) = 0;
    /// Asks whether to overwrite this file, which another program has changed since it was read.
    virtual bool askOverwriteChanged(const std::filesystem::path &file) = 0;
    enum class FewerAnswer { Replace, KeepSaved, Cancel };
    /// Asks whether to replace the landmarks saved in a file by much fewer ones, or by none.
    /// @param saved, now  the numbers of placed landmarks
    virtual FewerAnswer askFewerLandmarks(const std::filesystem::path &file, int saved, int now) = 0;
    /// Asks whether to delete the kept changes for good.
    /// @param lost  the scene, and the numbers of a scan's landmarks
    virtual bool askDeleteKept(const QString &lost) = 0;
};

/// The scene that the document shows, its origin and the fate of its changes: leaves, saves,
/// autosaves and recovers scenes, without a widget; a SceneOpener reads files. Opening cancels a
/// running load, then reads, then asks about unsaved changes: unreadable files cause no question.
/// For a scene, the scene file is read before the question and its models after it.
class Session : public QObject {
    Q_OBJECT
public:
    struct Options {
        bool remembers = true; ///< asks about unsaved changes, keeps the list of recent files
        /// Folder of recovery files; empty: the user's data folder if it `remembers`, else none.
        QString recoveryFolder = {};
        AutosaveTiming autosave = {};
    };
    /// @param document, questions  outlive the session
    Session(SceneDocument &document, SessionQuestions &questions, const Options &options, QObject *parent = nullptr);
    ~Session() override;

    /// The title: the name of the file or of the lesson's step, or another description of the
    /// scene.
    QString name() const { return m_origin.name; }
    /// Absolute path that the scene was opened from or saved to; empty: none.
    const std::filesystem::path &file() const { return m_origin.file; }
    /// The contents of its file if it were saved there now.
    scene_file::SceneFile contents() const;
    /// Returns whether leaving the scene would lose work: any change of a scene with a file, and
    /// more than a change of view in one without.
    bool hasUnsavedChanges() const;

    // ---- opening: `failed` reports an error, and then nothing has changed

    /// Opens model files as a new scene, or the scene file among them; landmark files and templates
    /// among them are applied afterwards.
    void openFiles(std::vector<std::filesystem::path> files);
    /// Opens model files and appends them to the objects, as one undoable step.
    void addFiles(std::vector<std::filesystem::path> files);
    /// Opens a scene file. Loads its models first; each file once, even if several objects show it.
    void openScene(const std::filesystem::path &file, std::vector<std::filesystem::path> landmarkFiles = {});
    void openBundledScene();
    /// Shows the scene of a lesson's step, which has the step's name. Leaves the present scene
    /// without a question: see mayLeaveStep. The scene before the lesson is suspended with its
    /// unsaved changes.
    /// @param lesson  its name, for `opened`
    /// @return whether it is shown
    bool openLesson(scene::Scene scene, const QString &name, const QString &lesson);

    /// Restores the scene before the lesson with its pick and unsaved changes; the undo history is
    /// lost. Leaves the present scene without a question.
    /// @return whether it is shown
    /// @pre a lesson's step is open
    bool comeBack();
    /// Renames the scene of a lesson's step, while it has no file: another step continues with it.
    void nameStep(const QString &name);
    ModelStore &models() { return m_models; }
    bool isLoading() const { return m_opener.isLoading(); }
    /// Cancels the loading and emits `noticed`.
    void cancelLoading();

    /// Sets the keeper of a part of the scene that has files of its own; null: there is none.
    /// @param keeper  outlives the session, or is reset
    void setKeeper(SceneKeeper *keeper) { m_keeper = keeper; }
    SessionQuestions &questions() { return m_questions; }
    /// Returns whether the user is asked questions, and choices last.
    bool remembers() const { return m_options.remembers; }

    /// Commits pending input.
    void commitTyped() { emit commitPendingEdits(); }

    // ---- saving

    /// Saves to its file, or as saveAs. Of a scan without a scene file, saves the landmarks beside
    /// it instead.
    /// @return whether it is on the disk
    bool save();
    /// Returns whether save() saves the landmarks of a scan.
    bool savesLandmarks() const { return m_origin.file.empty() && m_keeper && m_keeper->canSave(); }
    /// Asks for a name and saves; appends ".json" if it has no suffix.
    bool saveAs();
    std::filesystem::path proposedName() const;
    bool saveScene(const std::filesystem::path &file);
    /// Asks about unsaved changes. In a lesson: changes of a step's scene with a file, and of the
    /// scene before the lesson, which is restored only to be saved.
    /// @return whether the scene may be left; else the present scene stays, or the restored one
    /// that could not be saved
    bool mayLeave();
    /// The same for a lesson's step, or for the return from it: asks only about a step's scene with
    /// a file. Drops the changes of one without; the scene before the lesson keeps its own.
    bool mayLeaveStep();
    /// Leaves the scene for good, as mayLeave has allowed: keeps nothing of its changes.
    void end();

    // ---- after a crash

    /// Looks for unsaved changes after an unexpected end.
    void offerRecovery();
    /// The found scenes with unsaved changes, the last one first.
    std::vector<RecoveryInfo> offered() const;
    // The index refers to offered(). @pre index < offered().size()
    void recover(std::size_t index);
    void discardOffered(std::size_t index);
    /// Keeps them for the next start.
    void postponeOffered();

    QStringList recentFiles() const;
    void clearRecentFiles();

signals:
    /// Emitted when pending input must be committed: a part of the scene is about to be written or
    /// left. See commitTyped.
    void commitPendingEdits();
    /// Emitted when the name, the file, or the state "has unsaved changes" changes.
    void changed();
    /// Emitted when a file is being opened or was saved: earlier messages are outdated.
    void progressed();
    /// Emitted when another scene is shown.
    /// @param lesson  the name of the lesson that it is a step of, or empty
    /// @param isBack  it is the scene before a lesson, restored
    void opened(const QString &lesson, bool isBack);
    /// Emitted when landmark files or templates were opened, with the present models or alone: the
    /// receiver imports them.
    void landmarkFilesOpened(const std::vector<std::filesystem::path> &files);
    /// Emitted when something could not be opened or saved, with the reason.
    void failed(const QString &reason);
    /// Emitted with import notes: what was changed or dropped.
    void warned(const QString &notes);
    /// Emitted with information that needs no answer.
    void noticed(const QString &text);
    void loadingStarted();
    /// @param share  of all files, in [0, 1]
    void loadingProgressed(const QString &fileName, double share);
    /// Emitted when a loading has ended, in any way.
    void loadingEnded();
    void offeredChanged();
    void recentFilesChanged();

private:
    /// A suspended scene with its whole state, to be restored later.
    struct SceneAside {
        scene::Scene scene;
        KeptPick pick;
        SceneOrigin origin;
        bool isUnsaved = false;
        std::unique_ptr<RecoveryFile> recovery; ///< the file that keeps its changes
    };

    /// Shows what was opened, and reports its errors and import notes.
    void show(Opened opened);
    bool showModels(std::vector<scene::SceneObject> objects);
    void addModels(std::vector<scene::SceneObject> objects);
    bool showScene(Opened &opened);
    /// Sets the origin of the scene that was just opened.
    void setScene(const SceneOrigin &origin, const QString &lesson = {}, bool isBack = false);
    /// Drops the suspended scene: it is not restored any more.
    void dropAside();
    void takeRecovered(const RecoveryFile *file);
    std::unique_ptr<RecoveryFile> takeOffered(std::size_t index);
    /// The matrices that were imported but saved as arguments, in a sentence; empty if there are
    /// none.
    QString droppedMatrices() const;
    void createAutosave();
    void followChanges();
    geometry::Result<Autosave::Content, QString> unsavedContent() const;
    /// Saves the scene to its file, or as saveAs.
    bool saveToScene();
    /// Cancels the loading and commits pending input before the scene is left.
    /// @return false if the user wants to stay
    bool finishBeforeLeaving();
    /// Asks the user whether to save the changes of a scene.
    /// @param hasFile  see SessionQuestions::askSave
    /// @param save     saves this scene; called if the user answers "save"
    /// @return true if the changes are saved or discarded
    bool mayLoseChanges(const QString &name, bool hasFile, const std::function<bool()> &save);
    bool mayLoseChanges();
    void rememberRecent(const std::filesystem::path &file);

    SceneDocument &m_document;
    SessionQuestions &m_questions;
    Options m_options;
    ModelStore m_models;
    SceneOpener m_opener;
    SceneOrigin m_origin;
    SceneKeeper *m_keeper = nullptr;
    std::optional<SceneAside> m_aside;                    ///< the scene before the lesson
    Autosave *m_autosave = nullptr;                       ///< null if nothing is kept
    std::vector<std::unique_ptr<RecoveryFile>> m_offered; ///< the last one first
};

} // namespace unprojector::gui
