#include "gui/shell/window_questions.h"

#include "gui/text/error_text.h"

#include <QFileDialog>
#include <QMessageBox>
#include <QPushButton>

namespace unprojector::gui {
namespace {

/// Names come from files: whatever looks like markup in them is text.
QMessageBox::StandardButton ask(QWidget &window, const QString &title, const QString &text,
                                QMessageBox::StandardButtons buttons, QMessageBox::StandardButton proposed)
{
    QMessageBox box(QMessageBox::Question, title, text, buttons, &window);
    box.setTextFormat(Qt::PlainText);
    box.setDefaultButton(proposed);
    return static_cast<QMessageBox::StandardButton>(box.exec());
}

/// The same with buttons of our own, "Cancel" besides.
/// @return the place of the one that was pressed, -1 for Cancel
int askOwn(QWidget &window, const QString &title, const QString &text, const QStringList &choices)
{
    QMessageBox box(QMessageBox::Question, title, text, QMessageBox::Cancel, &window);
    box.setTextFormat(Qt::PlainText);
    QList<QAbstractButton *> buttons;
    for (const QString &choice : choices)
        buttons << box.addButton(choice, QMessageBox::AcceptRole);
    box.exec();
    return static_cast<int>(buttons.indexOf(box.clickedButton()));
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
    const QString question = hasFile ? tr("Save the changes to %1?").arg(name)
                                     : tr("Save what was made of %1 as a scene? Models stay as they are.").arg(name);
    switch (ask(m_window, tr("Unsaved Changes"), question,
                QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, QMessageBox::Save)) {
    case QMessageBox::Save: return SaveAnswer::Save;
    case QMessageBox::Discard: return SaveAnswer::Discard;
    default: return SaveAnswer::Cancel;
    }
}

std::filesystem::path WindowQuestions::askFileName(const std::filesystem::path &proposal)
{
    const QString name =
        QFileDialog::getSaveFileName(&m_window, tr("Save Scene"), pathText(proposal), tr("Scenes (*.json)"));
    return std::filesystem::path(name.toStdU16String());
}

bool WindowQuestions::askOverwrite(const std::filesystem::path &file)
{
    return ask(m_window, tr("Save Scene"), tr("%1 is there already. Replace it?").arg(pathText(file)),
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

bool WindowQuestions::askDeleteKept(const QString &name)
{
    return ask(m_window, tr("Discard Unsaved Changes"), tr("Delete the unsaved changes to %1 for good?").arg(name),
               QMessageBox::Discard | QMessageBox::Cancel, QMessageBox::Cancel)
           == QMessageBox::Discard;
}

PointFileQuestions::Join WindowQuestions::askJoin(const Counts &counts)
{
    QString text = tr("Points that are placed already: %1. Points in the file: %2. Replace them, or put the new ones "
                      "behind them?")
                       .arg(counts.placed)
                       .arg(counts.coming);
    if (counts.waiting > 0)
        text += QStringLiteral("\n\n")
                + tr("Names of the template that wait for their points: %1. Replace takes them away as well; Append "
                     "gives those that the file has their places.")
                      .arg(counts.waiting);
    switch (askOwn(m_window, tr("Import Points"), text, {tr("&Replace"), tr("&Append")})) {
    case 0: return Join::Replace;
    case 1: return Join::Append;
    default: return Join::Cancel;
    }
}

PointFileQuestions::Stray WindowQuestions::askStray(const QString &text)
{
    switch (askOwn(m_window, tr("Import Points"), text,
                   {tr("&Move Them onto the Mesh"), tr("&Leave Them Where They Are")})) {
    case 0: return Stray::Tie;
    case 1: return Stray::LeaveFree;
    default: return Stray::Cancel;
    }
}

PointFileQuestions::Order WindowQuestions::askOrder(const QString &text)
{
    switch (askOwn(m_window, tr("Import Points"), text, {tr("&Take the Names in Order"), tr("&Put Them Behind")})) {
    case 0: return Order::Fill;
    case 1: return Order::Behind;
    default: return Order::Cancel;
    }
}

} // namespace unprojector::gui
