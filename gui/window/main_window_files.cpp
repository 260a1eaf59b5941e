// What the window opens: models, the bundled scene, the tutorials' examples, and the files opened last.

#include "gui/window/main_window.h"

#include "core/scene/bundled_scene.h"
#include "core/scene/examples.h"
#include "core/scene_file/scene_error_text.h"
#include "gui/document/recent_files.h"
#include "gui/document/scene_document.h"
#include "gui/text/error_text.h"
#include "gui/text/example_texts.h"
#include "gui/window/example_note.h"
#include "gui/window/overlay_bars.h"

#include <QDockWidget>
#include <QFileDialog>
#include <QMenu>
#include <QMessageBox>
#include <QStatusBar>

#include <algorithm>
#include <utility>

namespace unprojector::gui {
using namespace scene;
using namespace scene_file;
namespace {

bool isSceneFile(const std::filesystem::path &file)
{
    const std::filesystem::path suffix = file.extension();
    return suffix == ".json" || suffix == ".JSON";
}

QString openFileFilter()
{
    return modelFileFilter() + QStringLiteral(";;") + MainWindow::tr("Scenes (*.json)") + QStringLiteral(";;")
           + MainWindow::tr("All files (*)");
}

/// From now on the working folder does not matter.
std::filesystem::path absolutePath(const std::filesystem::path &file)
{
    std::error_code error;
    std::filesystem::path absolute = std::filesystem::absolute(file, error);
    return error ? file : absolute;
}

/// A model that the program brings along, by its name.
std::shared_ptr<const Model> bundledModel(const std::string &name)
{
    std::vector<SceneObject> objects = bundledScene();
    for (const Example &example : examples())
        objects.insert(objects.end(), example.scene.objects.begin(), example.scene.objects.end());
    for (const SceneObject &object : objects) {
        if (object.model->name == name)
            return object.model;
    }
    return nullptr;
}

} // namespace

void MainWindow::openBundledScene()
{
    if (!mayLeaveScene())
        return;
    m_loader->cancel();
    leaveExample();
    m_document->setObjects(bundledScene(), {WorldPoint(6.5, 5.0, 10.5), WorldPoint(0.5, 0.9, 0.0), {0.0, 1.0, 0.0}});
    setSceneFile({}, {}, tr("Bundled scene"));
}

void MainWindow::askForFiles()
{
    const QStringList names = QFileDialog::getOpenFileNames(this, tr("Open Models or a Scene"), {}, openFileFilter());
    std::vector<std::filesystem::path> files;
    for (const QString &name : names)
        files.emplace_back(name.toStdU16String());
    if (!files.empty())
        openFiles(std::move(files));
}

void MainWindow::openFiles(std::vector<std::filesystem::path> files)
{
    const auto scene = std::find_if(files.begin(), files.end(), isSceneFile);
    if (scene != files.end()) {
        openScene(*scene);
        return;
    }
    m_message->hide();
    m_pendingScene.reset();
    m_loader->load(std::move(files));
}

void MainWindow::takeLoaded(const std::vector<LoadedModel> &models, const std::vector<ImportError> &errors)
{
    m_loading->finish();
    if (m_pendingScene) {
        if (errors.empty())
            takeScene(models);
        m_pendingScene.reset();
    } else if (!models.empty() && mayLeaveScene()) {
        std::vector<SceneObject> objects;
        for (const LoadedModel &loaded : models) {
            objects.push_back(
                {pathText(loaded.file.filename()).toStdString(), absolutePath(loaded.file), loaded.model, {}});
            rememberRecent(loaded.file);
        }
        const QString first = QString::fromStdString(objects.front().name);
        const int others = static_cast<int>(models.size()) - 1;
        leaveExample();
        m_document->setObjects(std::move(objects));
        setSceneFile({}, {}, others == 0 ? first : tr("%1 and %n more", nullptr, others).arg(first));
    }
    if (!errors.empty()) {
        QStringList reasons;
        for (const ImportError &error : errors)
            reasons << errorText(error);
        m_message->showMessage(reasons.join(u'\n'));
        emit openFailed(reasons.join(u'\n'));
    }
    emit loadingEnded();
}

void MainWindow::openScene(const std::filesystem::path &file)
{
    m_message->hide();
    Result<SceneFile, SceneFileError> scene = readSceneFile(file);
    if (!scene) {
        showFailure(QString::fromStdString(sceneErrorText(scene.error())));
        emit loadingEnded();
        return;
    }
    if (!mayLeaveScene()) {
        emit loadingEnded();
        return;
    }
    load({absolutePath(file), std::move(scene).value(), pathText(file.filename())});
}

void MainWindow::load(PendingScene scene)
{
    m_loader->cancel(); // it would take the scene to come with it
    std::vector<std::filesystem::path> models;
    for (const SceneFileObject &object : scene.contents.objects) {
        if (object.bundled.empty())
            models.push_back(objectFile(object, scene.path));
    }
    m_pendingScene = std::move(scene);
    m_loader->load(std::move(models)); // none is none, and ends like any other
}

void MainWindow::takeScene(const std::vector<LoadedModel> &models)
{
    PendingScene &pending = *m_pendingScene;
    std::vector<std::shared_ptr<const Model>> inOrder;
    std::size_t next = 0;
    for (const SceneFileObject &object : pending.contents.objects) {
        std::shared_ptr<const Model> model =
            object.bundled.empty() ? models.at(next++).model : bundledModel(object.bundled);
        if (!model) {
            showFailure(
                tr("%1: there is no bundled model \"%2\".").arg(pending.name, QString::fromStdString(object.bundled)));
            return;
        }
        inOrder.push_back(std::move(model));
    }
    Result<Scene> scene = sceneFromFile(pending.contents, pending.path, inOrder);
    const Check opened = scene ? m_document->open(std::move(scene).value()) : Check(scene.error());
    if (!opened) {
        showFailure(tr("%1: %2").arg(pending.name, errorText(opened.error())));
        return;
    }
    leaveExample();
    setSceneFile(pending.path, std::move(pending.contents), pending.name);
    if (pending.recovered)
        takeRecovered(*pending.recovered);
    else
        rememberRecent(pending.path);
}

void MainWindow::setSceneFile(const std::filesystem::path &file, SceneFile contents, const QString &name)
{
    m_scenePath = file;
    m_sceneFile = std::move(contents);
    nameScene(name);
    m_document->markSaved();
}

void MainWindow::nameScene(const QString &name)
{
    m_sceneName = name;
    setWindowTitle(tr("%1[*] – Unprojector").arg(name));
}

bool MainWindow::saveScene(const std::filesystem::path &file)
{
    const std::filesystem::path path = absolutePath(file);
    SceneFile contents = sceneFileFrom(m_document->scene(), m_document->geometry(), path, m_sceneFile);
    const Result<files::FileStamp, SceneFileError> written = writeSceneFile(path, contents);
    if (!written) {
        showFailure(QString::fromStdString(sceneErrorText(written.error())));
        return false;
    }
    m_message->hide();
    rememberRecent(path);
    if (const QString dropped = droppedMatrices(contents); !dropped.isEmpty())
        statusBar()->showMessage(dropped, kNoticeMilliseconds);
    m_scenePath = path;
    // Its matrices stay known: undoing what was done to them brings them back into the file.
    m_sceneFile.objects = std::move(contents.objects);
    nameScene(pathText(path.filename()));
    m_document->markSaved();
    return true;
}

QString MainWindow::droppedMatrices(const SceneFile &written) const
{
    const bool projection = std::holds_alternative<MatrixProjection>(m_sceneFile.projection)
                            && !std::holds_alternative<MatrixProjection>(written.projection);
    const bool view =
        std::holds_alternative<glm::dmat4>(m_sceneFile.view) && !std::holds_alternative<glm::dmat4>(written.view);
    if (projection && view)
        return tr("Saved. The projection and the view have changed since they came as matrices; they are written by "
                  "their arguments.");
    if (projection)
        return tr("Saved. The projection has changed since it came as a matrix; it is written by its arguments.");
    if (view)
        return tr("Saved. The view has changed since it came as a matrix; it is written as eye, center and up.");
    return {};
}

bool MainWindow::save()
{
    return m_scenePath.empty() ? saveAs() : saveScene(m_scenePath);
}

bool MainWindow::saveAs()
{
    const QString name = QFileDialog::getSaveFileName(
        this, tr("Save Scene"), m_scenePath.empty() ? tr("scene.json") : pathText(m_scenePath), tr("Scenes (*.json)"));
    return !name.isEmpty() && saveScene(std::filesystem::path(name.toStdU16String()));
}

bool MainWindow::hasUnsavedChanges() const
{
    // Who only looks at a model from all sides has nothing to save; a scene with a file has an owner.
    return m_scenePath.empty() ? m_document->isEdited() : m_document->isModified();
}

bool MainWindow::mayLeaveScene()
{
    if (!hasUnsavedChanges() || !m_options.remembers)
        return true;
    const auto answer =
        QMessageBox::question(this, tr("Unsaved Changes"), tr("Save the changes to %1?").arg(m_sceneName),
                              QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, QMessageBox::Save);
    if (answer == QMessageBox::Save)
        return save();
    return answer == QMessageBox::Discard;
}

QString MainWindow::message() const
{
    return m_message->isHidden() ? QString() : m_message->text();
}

void MainWindow::rememberRecent(const std::filesystem::path &file)
{
    if (!m_options.remembers)
        return;
    addRecentFile(QString::fromStdU16String(absolutePath(file).u16string()));
    updateRecentMenu();
}

void MainWindow::updateRecentMenu()
{
    m_recentMenu->clear();
    const QStringList files = m_options.remembers ? recentFiles() : QStringList();
    m_recentMenu->setEnabled(!files.isEmpty());
    for (const QString &file : files)
        connect(m_recentMenu->addAction(recentFileText(file)), &QAction::triggered, this,
                [this, file] { openFiles({std::filesystem::path(file.toStdU16String())}); });
    if (files.isEmpty())
        return;
    m_recentMenu->addSeparator();
    connect(m_recentMenu->addAction(tr("&Clear This List")), &QAction::triggered, this, [this] {
        clearRecentFiles();
        updateRecentMenu();
    });
}

void MainWindow::createExamplesMenu(QMenu &menu)
{
    std::string tutorial;
    for (const Example &example : examples()) {
        const std::optional<ExampleText> text = exampleText(example.id);
        Q_ASSERT(text);
        if (example.tutorial != tutorial) {
            tutorial = example.tutorial;
            menu.addSection(tutorialName(tutorial));
        }
        addAction(&menu, text->name, {}, text->source, [this, id = example.id] { openExample(id); });
    }
}

void MainWindow::openExample(const std::string &id)
{
    const std::vector<Example> all = examples();
    const auto found = std::find_if(all.begin(), all.end(), [&id](const Example &example) { return example.id == id; });
    if (found == all.end())
        return;
    if (!mayLeaveScene())
        return;
    m_loader->cancel();
    if (const Check opened = m_document->open(found->scene); !opened) {
        m_message->showMessage(errorText(opened.error()));
        return;
    }
    setSceneFile({}, {}, exampleText(id)->name);
    m_exampleNote->showExample(id);
    m_exampleDock->show();
    m_exampleDock->raise();
}

void MainWindow::leaveExample()
{
    m_exampleNote->clear();
    m_exampleDock->hide();
}

} // namespace unprojector::gui
