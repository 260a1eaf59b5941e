#include "gui/shell/window_questions.h"

#include "gui/text/error_text.h"
#include "gui/widgets/file_dialogs.h"

#include <QMessageBox>
#include <QPushButton>

namespace unprojector::gui {
namespace {

/// Asks in a message box. Names come from files: markup in them is shown literally.
QMessageBox::StandardButton ask(QWidget &window, const QString &title, const QString &text,
                                QMessageBox::StandardButtons buttons, QMessageBox::StandardButton proposed)
{
    QMessageBox box(QMessageBox::Question, title, text, buttons, &window);
    box.setTextFormat(Qt::PlainText);
    box.setDefaultButton(proposed);
    return static_cast<QMessageBox::StandardButton>(box.exec());
}

} // namespace

void warn(QWidget &window, const QString &title, const QString &text)
{
    QMessageBox box(QMessageBox::Warning, title, text, QMessageBox::Ok, &window);
    box.setTextFormat(Qt::PlainText);
    box.exec();
}

SessionQuestions::SaveAnswer WindowQuestions::askSave(const QString &name, bool hasFile)
{
    const QString question = hasFile
                                 ? tr("Save the changes to %1?").arg(name)
                                 : tr("Save the changes to %1 as a scene file? Model files are not changed.").arg(name);
    switch (ask(m_window, tr("Unsaved Changes"), question,
                QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, QMessageBox::Save)) {
    case QMessageBox::Save: return SaveAnswer::Save;
    case QMessageBox::Discard: return SaveAnswer::Discard;
    default: return SaveAnswer::Cancel;
    }
}

std::filesystem::path WindowQuestions::askFileName(const std::filesystem::path &proposal)
{
    return askSceneName(m_window, tr("Save Scene"), proposal, tr("Scenes (*.json)"));
}

bool WindowQuestions::askOverwrite(const std::filesystem::path &file)
{
    return ask(m_window, tr("Save Scene"), tr("%1 exists already. Replace it?").arg(pathText(file)),
               QMessageBox::Yes | QMessageBox::Cancel, QMessageBox::Cancel)
           == QMessageBox::Yes;
}

bool WindowQuestions::askOverwriteChanged(const std::filesystem::path &file)
{
    return ask(m_window, tr("Save Scene"),
               tr("%1 has been changed by another window or program since it was opened here. Replace it, and lose "
                  "those changes?")
                   .arg(pathText(file)),
               QMessageBox::Yes | QMessageBox::Cancel, QMessageBox::Cancel)
           == QMessageBox::Yes;
}

SessionQuestions::FewerAnswer WindowQuestions::askFewerLandmarks(const std::filesystem::path &file, int saved, int now)
{
    QMessageBox box(QMessageBox::Question, tr("Fewer Landmarks"),
                    tr("%1: landmarks placed in the file: %2; now: %3. Replace the saved landmarks?")
                        .arg(pathText(file.filename()))
                        .arg(saved)
                        .arg(now),
                    QMessageBox::Cancel, &m_window);
    box.setTextFormat(Qt::PlainText);
    const QAbstractButton *replace = box.addButton(tr("&Replace"), QMessageBox::DestructiveRole);
    const QAbstractButton *keep = box.addButton(tr("&Keep the Saved Ones"), QMessageBox::AcceptRole);
    box.setDefaultButton(QMessageBox::Cancel);
    box.exec();
    return box.clickedButton() == replace ? FewerAnswer::Replace
           : box.clickedButton() == keep  ? FewerAnswer::KeepSaved
                                          : FewerAnswer::Cancel;
}

bool WindowQuestions::askDeleteKept(const QString &lost)
{
    return ask(m_window, tr("Discard Unsaved Changes"), tr("Delete the unsaved changes to %1 for good?").arg(lost),
               QMessageBox::Discard | QMessageBox::Cancel, QMessageBox::Cancel)
           == QMessageBox::Discard;
}

} // namespace unprojector::gui
