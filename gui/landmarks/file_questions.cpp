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

LandmarkFileQuestions::Stray FileQuestions::askStray(const QString &text)
{
    switch (askOwn(m_window, tr("Import Points"), text,
                   {tr("&Move Them onto the Mesh"), tr("&Leave Them Where They Are")})) {
    case 0: return Stray::Tie;
    case 1: return Stray::LeaveFree;
    default: return Stray::Cancel;
    }
}

LandmarkFileQuestions::Order FileQuestions::askOrder(const QString &text)
{
    switch (askOwn(m_window, tr("Import Points"), text, {tr("&Take the Names in Order"), tr("&Put Them Behind")})) {
    case 0: return Order::Fill;
    case 1: return Order::Behind;
    default: return Order::Cancel;
    }
}

} // namespace unprojector::gui
