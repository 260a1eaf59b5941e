// What the window opens: models, the bundled scene, the tutorials' examples, and the files opened last.

#include "gui/main_window.h"

#include "core/bundled_scene.h"
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

#include <algorithm>

namespace unprojector {

void MainWindow::openBundledScene()
{
    m_loader->cancel();
    leaveExample();
    setWindowTitle(tr("Bundled scene – Unprojector"));
    m_document->setObjects(bundledScene(), {WorldPoint(6.5, 5.0, 10.5), WorldPoint(0.5, 0.9, 0.0), {0.0, 1.0, 0.0}});
}

void MainWindow::askForFiles()
{
    const QStringList names = QFileDialog::getOpenFileNames(this, tr("Open Models"), {}, modelFileFilter() + QStringLiteral(";;") + tr("All files (*)"));
    std::vector<std::filesystem::path> files;
    for (const QString &name : names)
        files.emplace_back(name.toStdU16String());
    if (!files.empty())
        openFiles(std::move(files));
}

void MainWindow::openFiles(std::vector<std::filesystem::path> files)
{
    m_message->hide();
    m_loader->load(std::move(files));
}

void MainWindow::takeLoaded(const std::vector<LoadedModel> &models, const std::vector<ImportError> &errors)
{
    m_loading->finish();
    if (!models.empty()) {
        std::vector<SceneObject> objects;
        for (const LoadedModel &loaded : models) {
            objects.push_back({pathText(loaded.file.filename()).toStdString(), loaded.file, loaded.model, {}});
            rememberRecent(loaded.file);
        }
        const QString first = QString::fromStdString(objects.front().name);
        const int others = static_cast<int>(models.size()) - 1;
        setWindowTitle(others == 0 ? tr("%1 – Unprojector").arg(first) : tr("%1 and %n more – Unprojector", nullptr, others).arg(first));
        leaveExample();
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
    m_loader->cancel();
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
