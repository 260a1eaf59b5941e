// What the window opens: models, the bundled scene, the tutorials' examples, and the files opened last.

#include "gui/main_window.h"

#include "core/bundled_scene.h"
#include "core/cli/scene_error_text.h"
#include "core/examples.h"
#include "gui/error_text.h"
#include "gui/example_note.h"
#include "gui/example_texts.h"
#include "gui/overlay_bars.h"
#include "gui/recent_files.h"
#include "gui/scene_document.h"

#include <QDockWidget>
#include <QFileDialog>
#include <QMenu>
#include <QMessageBox>

#include <algorithm>

namespace unprojector {
namespace {

bool isSceneFile(const std::filesystem::path &file)
{
    const std::filesystem::path suffix = file.extension();
    return suffix == ".json" || suffix == ".JSON";
}

QString openFileFilter()
{
    return modelFileFilter() + QStringLiteral(";;") + MainWindow::tr("Scenes (*.json)") + QStringLiteral(";;") + MainWindow::tr("All files (*)");
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
    setSceneFile({}, {});
    setWindowTitle(tr("Bundled scene – Unprojector"));
    m_document->setObjects(bundledScene(), {WorldPoint(6.5, 5.0, 10.5), WorldPoint(0.5, 0.9, 0.0), {0.0, 1.0, 0.0}});
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
            objects.push_back({pathText(loaded.file.filename()).toStdString(), loaded.file, loaded.model, {}});
            rememberRecent(loaded.file);
        }
        const QString first = QString::fromStdString(objects.front().name);
        const int others = static_cast<int>(models.size()) - 1;
        setWindowTitle(others == 0 ? tr("%1 – Unprojector").arg(first) : tr("%1 and %n more – Unprojector", nullptr, others).arg(first));
        leaveExample();
        setSceneFile({}, {});
        m_document->setObjects(std::move(objects));
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
    std::vector<std::filesystem::path> models;
    for (const SceneFileObject &object : scene->objects) {
        if (object.bundled.empty())
            models.push_back(objectFile(object, file));
    }
    m_pendingScene.emplace(file, std::move(scene).value());
    m_loader->load(std::move(models)); // none is none, and ends like any other
}

void MainWindow::takeScene(const std::vector<LoadedModel> &models)
{
    const auto &[path, contents] = *m_pendingScene;
    std::vector<std::shared_ptr<const Model>> inOrder;
    std::size_t next = 0;
    for (const SceneFileObject &object : contents.objects) {
        std::shared_ptr<const Model> model = object.bundled.empty() ? models.at(next++).model : bundledModel(object.bundled);
        if (!model) {
            showFailure(tr("%1: there is no bundled model \"%2\".").arg(pathText(path), QString::fromStdString(object.bundled)));
            return;
        }
        inOrder.push_back(std::move(model));
    }
    Result<Scene> scene = sceneFromFile(contents, path, inOrder);
    const Check opened = scene ? m_document->open(std::move(scene).value()) : Check(scene.error());
    if (!opened) {
        showFailure(tr("%1: %2").arg(pathText(path), errorText(opened.error())));
        return;
    }
    leaveExample();
    rememberRecent(path);
    setSceneFile(path, contents);
}

void MainWindow::setSceneFile(const std::filesystem::path &file, SceneFile contents)
{
    m_scenePath = file;
    m_sceneFile = std::move(contents);
    m_document->undoStack().setClean();
    setWindowModified(false);
    if (!file.empty())
        setWindowTitle(tr("%1[*] – Unprojector").arg(pathText(file.filename())));
}

bool MainWindow::saveScene(const std::filesystem::path &file)
{
    SceneFile contents = sceneFileFrom(m_document->scene(), m_document->geometry(), file, m_sceneFile);
    const Result<std::monostate, SceneFileError> written = writeSceneFile(file, contents);
    if (!written) {
        showFailure(QString::fromStdString(sceneErrorText(written.error())));
        return false;
    }
    m_message->hide();
    rememberRecent(file);
    setSceneFile(file, std::move(contents));
    return true;
}

void MainWindow::save()
{
    if (m_scenePath.empty())
        saveAs();
    else
        saveScene(m_scenePath);
}

void MainWindow::saveAs()
{
    const QString name = QFileDialog::getSaveFileName(this, tr("Save Scene"), m_scenePath.empty() ? tr("scene.json") : pathText(m_scenePath), tr("Scenes (*.json)"));
    if (!name.isEmpty())
        saveScene(std::filesystem::path(name.toStdU16String()));
}

bool MainWindow::mayLeaveScene()
{
    // Who only looks at a model from all sides has nothing to save; a scene with a file has an owner.
    if (!isWindowModified() || !m_options.remembers)
        return true;
    const auto answer = QMessageBox::question(this, tr("Unsaved Changes"), tr("Save the changes to %1?").arg(pathText(m_scenePath.filename())),
                                              QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, QMessageBox::Save);
    if (answer == QMessageBox::Save)
        return saveScene(m_scenePath);
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
    std::error_code error;
    const std::filesystem::path absolute = std::filesystem::absolute(file, error);
    addRecentFile(QString::fromStdU16String((error ? file : absolute).u16string()));
    updateRecentMenu();
}

void MainWindow::updateRecentMenu()
{
    m_recentMenu->clear();
    const QStringList files = m_options.remembers ? recentFiles() : QStringList();
    m_recentMenu->setEnabled(!files.isEmpty());
    for (const QString &file : files)
        connect(m_recentMenu->addAction(recentFileText(file)), &QAction::triggered, this, [this, file] { openFiles({std::filesystem::path(file.toStdU16String())}); });
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
    setSceneFile({}, {});
    if (const Check opened = m_document->open(found->scene); !opened) {
        m_message->showMessage(errorText(opened.error()));
        return;
    }
    setWindowTitle(tr("%1 – Unprojector").arg(exampleText(id)->name));
    m_exampleNote->showExample(id);
    m_exampleDock->show();
    m_exampleDock->raise();
}

void MainWindow::leaveExample()
{
    m_exampleNote->clear();
    m_exampleDock->hide();
}

} // namespace unprojector
