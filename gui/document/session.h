#pragma once

#include "gui/document/autosave.h"
#include "gui/document/kept_pick.h"
#include "gui/document/model_store.h"
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

/// What only a person can answer.
class SessionQuestions {
public:
    enum class SaveAnswer { Save, Discard, Cancel };

    virtual ~SessionQuestions() = default;
    /// What to do with the unsaved changes of the scene of this name, which is about to be left.
    /// @param hasFile  of a scene; else the name is that of a model, which is never written
    virtual SaveAnswer askSave(const QString &name, bool hasFile) = 0;
    /// Under which name to save; empty: not at all.
    virtual std::filesystem::path askFileName(const std::filesystem::path &proposal) = 0;
    /// Whether to write over this file, whose name is not quite the one that was given.
    virtual bool askOverwrite(const std::filesystem::path &file) = 0;
    /// Whether to write over this file, which somebody else has changed since it was read.
    virtual bool askOverwriteChanged(const std::filesystem::path &file) = 0;
    /// Whether to delete the changes that were kept of this scene for good.
    virtual bool askDeleteKept(const QString &name) = 0;
};

/// Which scene the document shows, where it is from and what becomes of its changes: leaves, saves, keeps in case of a
/// crash and recovers, without a widget; a SceneOpener reads what is opened. Opening ends what is loading, then reads, then asks about unsaved changes: what
/// cannot be read asks nothing. Of a scene it is the scene file that is read before the question, and its models after it.
class Session : public QObject {
    Q_OBJECT
public:
    struct Options {
        bool remembers = true; ///< asks about unsaved changes, keeps the list of recent files
        /// Where unsaved changes are kept in case of a crash; empty: with the user's data if it `remembers`, else nowhere.
        QString recoveryFolder = {};
        AutosaveTiming autosave = {};
    };
    /// @param document, questions  outlive the session
    Session(SceneDocument &document, SessionQuestions &questions, const Options &options, QObject *parent = nullptr);
    ~Session() override;

    /// As in a title: the file's name, that of a lesson's step, or what else there is to call the scene by.
    QString name() const { return m_origin.name; }
    /// Absolute: where the scene was opened from or saved to; empty: nowhere.
    const std::filesystem::path &file() const { return m_origin.file; }
    /// What its file would hold if it were saved there now.
    scene_file::SceneFile contents() const;
    /// Whether leaving the scene would lose work: any change of a scene that has a file, and more than a look around in one
    /// that has none.
    bool hasUnsavedChanges() const;

    // ---- opening: what goes wrong is told by `failed`, and then nothing has changed

    /// Opens model files as a new scene, or the scene where there is a scene file among them; points of files among them
    /// and templates come to what is shown then.
    void openFiles(std::vector<std::filesystem::path> files);
    /// Opens model files and puts them beside the objects that are there, as one undoable step.
    void addFiles(std::vector<std::filesystem::path> files);
    /// Opens a scene file. Its models are loaded first; each file once, however many objects show it.
    void openScene(const std::filesystem::path &file, std::vector<std::filesystem::path> landmarkFiles = {});
    void openBundledScene();
    /// Shows the scene of a lesson's step, whose name it has. What was shown is left without a question: see mayLeaveStep. The
    /// scene that was shown before the lesson stands aside with its unsaved changes.
    /// @param lesson  its name, for `opened`
    /// @return whether it is shown
    bool openLesson(scene::Scene scene, const QString &name, const QString &lesson);

    /// Shows again the scene that was shown before the lesson, its pick and unsaved changes included; what was done cannot be undone any
    /// more. What is shown is left without a question.
    /// @return whether it is shown
    /// @pre a lesson's step is open
    bool comeBack();
    /// Of the scene of a lesson's step, as long as it has no file: another step goes on with it.
    void nameStep(const QString &name);
    ModelStore &models() { return m_models; }
    bool isLoading() const { return m_opener.isLoading(); }
    /// Gives up what is loading, and says so by `noticed`.
    void cancelLoading();

    /// What is being typed counts now.
    void commitTyped() { emit commitPendingEdits(); }

    // ---- saving

    /// To its file, or as saveAs.
    /// @return whether it is on the disk
    bool save();
    /// Under a name that is asked for; ".json" is put behind it where it has no suffix.
    bool saveAs();
    std::filesystem::path proposedName() const;
    bool saveScene(const std::filesystem::path &file);
    /// Asks about unsaved changes. In a lesson they are those of a step's scene that has a file, and of the scene that was shown
    /// before the lesson, which comes back only to be saved.
    /// @return whether the scene may be left; else what is shown stays, or what came back and could not be saved
    bool mayLeave();
    /// The same for a lesson's step, or to come back: only a step's scene that has a file is asked about. The changes of one
    /// that has none are given up; the scene before the lesson keeps its own.
    bool mayLeaveStep();
    /// The scene is left for good, as mayLeave has allowed: nothing is kept of its changes.
    void end();

    // ---- after a crash

    /// Looks for unsaved changes that an unexpected end has left.
    void offerRecovery();
    /// Those that were found, the last one first.
    std::vector<RecoveryInfo> offered() const;
    // With the index of one of those. @pre index < offered().size()
    void recover(std::size_t index);
    void discardOffered(std::size_t index);
    /// They stay for the next start.
    void postponeOffered();

    QStringList recentFiles() const;
    void clearRecentFiles();

signals:
    /// What is being typed is to count now: something of the scene is about to be written or left. See commitTyped.
    void commitPendingEdits();
    /// The scene is to be saved or left, with all that was typed.
    void aboutToSaveOrLeave();
    /// The name, the file, or whether there are unsaved changes.
    void changed();
    /// Something is opened or was saved: what was told before is past.
    void progressed();
    /// Another scene is shown.
    /// @param lesson  the name of the lesson that it is a step of, or empty
    /// @param isBack  it was shown before a lesson, and comes back as it was then
    void opened(const QString &lesson, bool isBack);
    /// Files of points or templates of names were opened with the models that are shown now, or alone: what becomes of them
    /// is not the session's.
    void landmarkFilesOpened(const std::vector<std::filesystem::path> &files);
    /// What could not be opened or saved, in words.
    void failed(const QString &reason);
    /// What of an opened file is not shown, or not as the file has it.
    void warned(const QString &notes);
    /// What is good to know and needs no answer.
    void noticed(const QString &text);
    void loadingStarted();
    /// @param share  of all files, in [0, 1]
    void loadingProgressed(const QString &fileName, double share);
    /// A loading has ended, in whatever way.
    void loadingEnded();
    void offeredChanged();
    void recentFilesChanged();

private:
    /// A scene with all that there is to know of it, to come back to.
    struct SceneAside {
        scene::Scene scene;
        KeptPick pick;
        SceneOrigin origin;
        bool isUnsaved = false;
        std::unique_ptr<RecoveryFile> recovery; ///< where its changes are kept
    };

    /// Shows what was opened, and reports its errors and import notes.
    void show(Opened opened);
    bool showModels(std::vector<scene::SceneObject> objects);
    void addModels(std::vector<scene::SceneObject> objects);
    bool showScene(Opened &opened);
    /// The scene that was just opened is from there.
    void setScene(const SceneOrigin &origin, const QString &lesson = {}, bool isBack = false);
    /// Nobody comes back to it.
    void dropAside();
    void takeRecovered(const RecoveryFile *file);
    std::unique_ptr<RecoveryFile> takeOffered(std::size_t index);
    /// What came as a matrix and was saved by its arguments, in a sentence; empty where nothing was.
    QString droppedMatrices() const;
    void createAutosave();
    void followChanges();
    geometry::Result<Autosave::Content, QString> unsavedContent() const;
    /// What is loading ends, and what was typed counts, before the scene is left.
    void finishBeforeLeaving();
    /// @param hasFile  see SessionQuestions::askSave
    /// @param save     of the scene that is asked about
    bool mayLoseChanges(const QString &name, bool hasFile, const std::function<bool()> &save);
    bool mayLoseChanges();
    void rememberRecent(const std::filesystem::path &file);

    SceneDocument &m_document;
    SessionQuestions &m_questions;
    Options m_options;
    ModelStore m_models;
    SceneOpener m_opener;
    SceneOrigin m_origin;
    std::optional<SceneAside> m_aside;                    ///< in a lesson what was shown before it
    Autosave *m_autosave = nullptr;                       ///< none where nothing is to be kept
    std::vector<std::unique_ptr<RecoveryFile>> m_offered; ///< the last one first
};

} // namespace unprojector::gui
