// What the window keeps of unsaved changes in case of a crash, and what it asks about those that a crash has left.

#include "gui/window/main_window.h"

#include "core/scene_file/scene_error_text.h"
#include "gui/document/scene_document.h"
#include "gui/text/error_text.h"
#include "gui/window/overlay_bars.h"

#include <QDir>
#include <QMessageBox>
#include <QStatusBar>

#include <algorithm>
#include <utility>

namespace unprojector::gui {
using namespace scene_file;

void MainWindow::createAutosave()
{
    QString folder = m_options.recoveryFolder;
    if (folder.isEmpty() && m_options.remembers)
        folder = RecoveryFile::defaultFolder();
    if (!folder.isEmpty()) {
        m_autosave = new Autosave(
            folder, m_options.autosave, [this] { return unsavedContent(); }, this);
        connect(m_autosave, &Autosave::failed, this, [this](const QString &path) {
            statusBar()->showMessage(tr("In case of a crash unsaved changes would be lost: %1 cannot be written.")
                                         .arg(QDir::toNativeSeparators(path)),
                                     kNoticeMilliseconds);
        });
    }
    connect(m_document, &SceneDocument::changed, this, [this](Changes changes) {
        if (changes & Change::History)
            followChanges();
    });
    connect(m_recovery, &RecoveryBar::recoverRequested, this,
            [this](int place) { recover(static_cast<std::size_t>(place)); });
    connect(m_recovery, &RecoveryBar::discardRequested, this,
            [this](int place) { discardOffered(static_cast<std::size_t>(place)); });
    connect(m_recovery, &RecoveryBar::laterRequested, this, [this] {
        m_offered.clear();
        showOffered();
    });
    connect(this, &MainWindow::loadingEnded, m_recovery, [this] { m_recovery->setEnabled(true); });
}

void MainWindow::followChanges()
{
    const bool isUnsaved = hasUnsavedChanges();
    setWindowModified(isUnsaved);
    if (m_autosave)
        m_autosave->follow(isUnsaved);
}

std::optional<Autosave::Content> MainWindow::unsavedContent() const
{
    Result<std::string, SceneFileError> text =
        sceneText(sceneFileFrom(m_document->scene(), m_document->geometry(), m_scenePath, m_sceneFile));
    if (!text)
        return std::nullopt;
    return Autosave::Content{{m_sceneName, m_scenePath, QDateTime::currentDateTime()}, std::move(text).value()};
}

void MainWindow::offerRecovery()
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
    showOffered();
    if (!damaged.isEmpty())
        showFailure(damaged.join(u'\n'));
}

void MainWindow::showOffered()
{
    std::vector<RecoveryInfo> infos;
    for (const std::unique_ptr<RecoveryFile> &file : m_offered)
        infos.push_back(file->info().value_or(RecoveryInfo{}));
    m_recovery->offer(infos);
}

std::unique_ptr<RecoveryFile> MainWindow::takeOffered(std::size_t place)
{
    std::unique_ptr<RecoveryFile> file = std::move(m_offered.at(place));
    m_offered.erase(m_offered.begin() + static_cast<std::ptrdiff_t>(place));
    showOffered();
    return file;
}

void MainWindow::recover(std::size_t place)
{
    RecoveryFile &file = *m_offered.at(place);
    const std::optional<RecoveryInfo> info = file.info();
    Result<SceneFile, SceneFileError> scene = file.scene();
    if (!info || !scene) {
        const QString reason = scene ? QString() : QString::fromStdString(sceneErrorText(scene.error()));
        const QString aside = takeOffered(place)->putAside();
        showFailure(tr("The unsaved changes are damaged and cannot be recovered. The file was put aside as %1.\n%2")
                        .arg(QDir::toNativeSeparators(aside), reason));
        return;
    }
    if (!mayLeaveScene())
        return;
    m_message->hide();
    SceneFile recovered = std::move(scene).value();
    locateObjects(recovered, info->sceneFile);
    load({info->sceneFile, std::move(recovered), info->name, &file});
    m_recovery->setEnabled(!isLoading());
}

void MainWindow::takeRecovered(const RecoveryFile &file)
{
    const auto found = std::find_if(m_offered.begin(), m_offered.end(),
                                    [&file](const auto &offered) { return offered.get() == &file; });
    m_autosave->adopt(takeOffered(static_cast<std::size_t>(found - m_offered.begin())));
    m_document->markUnsaved();
}

void MainWindow::discardOffered(std::size_t place)
{
    const QString name = m_offered.at(place)->info().value_or(RecoveryInfo{}).name;
    QMessageBox box(QMessageBox::Question, tr("Discard Unsaved Changes"),
                    tr("Delete the unsaved changes to %1 for good?").arg(name),
                    QMessageBox::Discard | QMessageBox::Cancel, this);
    box.setDefaultButton(QMessageBox::Cancel);
    if (box.exec() == QMessageBox::Discard)
        takeOffered(place)->remove();
}

} // namespace unprojector::gui
