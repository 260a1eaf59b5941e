#include "gui/shell/key_sheet.h"

#include <QAction>
#include <QMenu>
#include <QMenuBar>
#include <QRegularExpression>
#include <QTextBrowser>
#include <QVBoxLayout>

namespace unprojector::gui {
namespace {

QString row(const QString &keys, const QString &does)
{
    return QStringLiteral("<tr><td><b>%1</b>&nbsp;&nbsp;&nbsp;</td><td>%2</td></tr>")
        .arg(keys.toHtmlEscaped(), does.toHtmlEscaped());
}

QString heading(const QString &text)
{
    return QStringLiteral("<tr><td colspan='2'><p style='margin-top:16px; margin-bottom:4px'><b>%1</b></p></td></tr>")
        .arg(text.toHtmlEscaped());
}

/// The title without its mnemonic: "&File" is "File", and "文件(&F)" is "文件".
QString withoutMnemonic(QString title)
{
    static const QRegularExpression keyInParentheses(QStringLiteral("\\(&.\\)"));
    return title.remove(keyInParentheses).remove(u'&');
}

QString keysOf(const QList<QKeySequence> &sequences)
{
    QStringList keys;
    for (const QKeySequence &key : sequences)
        keys << key.toString(QKeySequence::NativeText);
    return keys.join(QStringLiteral(", "));
}

QString rowsOf(const QMenu &menu)
{
    QString rows;
    for (const QAction *action : menu.actions()) {
        if (action->menu())
            rows += rowsOf(*action->menu());
        else if (!action->shortcut().isEmpty())
            rows += row(keysOf(action->shortcuts()),
                        action->statusTip().isEmpty() ? action->iconText() : action->statusTip());
    }
    return rows;
}

} // namespace

KeySheet::KeySheet(const QMenuBar &menus, QWidget *parent) : QDialog(parent)
{
    setWindowTitle(tr("Mouse and Keys"));
    QString rows = heading(tr("Mouse in the view"));
    rows += row(tr("left button"), tr("read the world coordinate of the pixel"));
    rows += row(tr("left drag"), tr("turn the camera about the point under the pointer; the pick is kept"));
    rows += row(tr("middle drag, or Shift + left drag"), tr("move the camera sideways"));
    rows += row(tr("Ctrl + Shift + left drag"), tr("turn the light from the side; Esc takes the drag back"));
    rows += row(tr("wheel"), tr("zoom towards the pointer"));
    rows += row(tr("double-click"), tr("bring the point to the middle"));
    rows += row(tr("right click, or the menu key"), tr("menu for the pixel and its object"));
    rows += heading(tr("Keys in the view"));
    rows += row(tr("arrows"), tr("turn the camera"));
    rows += row(tr("Shift + arrows"), tr("move the camera sideways"));
    rows += row(tr("+, −, Page Up, Page Down"), tr("zoom at the crosshair"));
    rows += row(tr("Ctrl + arrows"), tr("move the crosshair by a pixel, with Shift by ten"));
    rows += row(tr("Enter"), tr("read the world coordinate at the crosshair"));
    rows += row(tr("Esc"), tr("cancel opening files"));
    rows += heading(tr("Landmarks"));
    rows += row(tr("left button on a marker"), tr("select the landmark; with Ctrl, add it to the selection"));
    rows += row(tr("left drag of a marker"), tr("slide the landmark on the surface; Esc cancels"));
    rows += row(tr("left drag of an arrow at the selected landmark"),
                tr("move the landmark along the axis, off the surface; A shows the arrows"));
    rows += row(tr("left button, while placing"), tr("place a landmark; a double-click places one; Esc ends placing"));
    rows += row(tr("arrows, while placing"),
                tr("move the selected landmark by a pixel, with Shift by ten, with Alt by a tenth"));
    rows += row(tr("Del"), tr("remove the selected landmarks"));
    rows += heading(tr("View from Outside"));
    rows += row(tr("drag of a plane"), tr("move the near or the far plane"));
    rows += row(tr("left drag, or arrows"), tr("turn about the view volume"));
    rows += row(tr("middle drag, or Shift + left drag"), tr("move sideways"));
    rows += row(tr("wheel, or +, −"), tr("zoom"));
    rows += row(tr("F"), tr("show everything"));
    rows += heading(tr("Keys in the list of objects"));
    rows += row(tr("Space, Enter, Del"), tr("show or hide the object, rename it, remove it"));
    rows += heading(tr("Keys in a table of numbers"));
    rows += row(QKeySequence(QKeySequence::Copy).toString(QKeySequence::NativeText),
                tr("copy the selected numbers, with all their digits"));
    rows += row(tr("right click, or the menu key"), tr("copy a point or a matrix as code"));
    rows += heading(tr("Keys in a group of parameters"));
    rows += row(tr("Enter, Left, Right"), tr("fold the group or open it"));
    rows += row(tr("Up, Down"), tr("go to the group above, below"));
    rows += heading(tr("Keys in a field"));
    rows += row(tr("Enter, Tab"), tr("apply the number or the expression, such as 1/3 or 2*pi"));
    rows += row(tr("Esc"), tr("restore the former value"));
    rows += row(tr("Up, Down, Page Up, Page Down"), tr("change the digit at the caret by one, by ten"));
    rows += heading(tr("Keys in Help"));
    rows += row(keysOf({QKeySequence::Find}), tr("find words in the page"));
    rows += row(keysOf({Qt::Key_F3, Qt::SHIFT | Qt::Key_F3}), tr("go to the next match, to the previous one"));
    rows += row(keysOf({QKeySequence::ZoomIn, QKeySequence::ZoomOut, Qt::CTRL | Qt::Key_0}),
                tr("larger text, smaller, in its usual size"));
    rows += row(keysOf({Qt::ALT | Qt::Key_Up}), tr("back to the contents"));
    rows += row(keysOf({Qt::ALT | Qt::Key_Left, Qt::ALT | Qt::Key_Right}),
                tr("in the manual, go back to the place before, forward again"));
    rows += row(keysOf({Qt::CTRL | Qt::SHIFT | Qt::Key_F}), tr("search all pages of the manual"));
    for (const QAction *action : menus.actions()) {
        const QString keys = rowsOf(*action->menu());
        if (!keys.isEmpty())
            rows += heading(withoutMnemonic(action->menu()->title())) + keys;
    }
    auto *page = new QTextBrowser;
    page->setFrameShape(QFrame::NoFrame);
    page->setHtml(QStringLiteral("<table>%1</table>").arg(rows));
    page->setAccessibleName(windowTitle());
    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(page);
    constexpr int kDigits = 84, kLines = 36;
    resize(kDigits * fontMetrics().horizontalAdvance(u'0'), kLines * fontMetrics().lineSpacing());
}

} // namespace unprojector::gui
