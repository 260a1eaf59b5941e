#include "gui/landmarks/file_questions.h"

#include <QMessageBox>
#include <QPushButton>

namespace unprojector::gui {
namespace {

/// Asks with its own buttons and "Cancel". Names come from files: markup in them is shown
/// literally.
/// @return the index of the pressed button, -1 for Cancel
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

LandmarkFileQuestions::Join FileQuestions::askJoin(const Counts &counts)
{
    QString text =
        tr("Landmarks already placed: %1. Landmarks in the file: %2. Replace the placed ones, or append the new ones?")
            .arg(counts.placed)
            .arg(counts.coming);
    if (counts.waiting > 0)
        text += QStringLiteral("\n\n")
                + tr("Template names not placed yet: %1. Replace removes them as well; Append fills those that the "
                     "file contains.")
                      .arg(counts.waiting);
    switch (askOwn(m_window, tr("Import Landmarks"), text, {tr("&Replace"), tr("&Append")})) {
    case 0: return Join::Replace;
    case 1: return Join::Append;
    default: return Join::Cancel;
    }
}

LandmarkFileQuestions::Stray FileQuestions::askStray(const QString &text)
{
    switch (askOwn(m_window, tr("Import Landmarks"), text,
                   {tr("&Move Them onto the Mesh"), tr("&Leave Them Where They Are")})) {
    case 0: return Stray::Tie;
    case 1: return Stray::LeaveFree;
    default: return Stray::Cancel;
    }
}

LandmarkFileQuestions::Order FileQuestions::askOrder(const QString &text)
{
    switch (askOwn(m_window, tr("Import Landmarks"), text, {tr("&Take the Names in Order"), tr("&Append Them")})) {
    case 0: return Order::Fill;
    case 1: return Order::Behind;
    default: return Order::Cancel;
    }
}

} // namespace unprojector::gui
