#include "gui/widgets/copy_menu.h"

#include "core/pipeline/matrix_format.h"
#include "gui/text/number_text.h"

#include <QClipboard>
#include <QCoreApplication>
#include <QGuiApplication>
#include <QItemSelectionModel>
#include <QMenu>

#include <algorithm>

namespace unprojector::gui {
using namespace pipeline;

namespace {

struct CopyMenu {
    Q_DECLARE_TR_FUNCTIONS(CopyMenu)
};

} // namespace

QString selectedCells(const QItemSelectionModel &selection, const std::function<QString(const QModelIndex &)> &textOf)
{
    QModelIndexList selected = selection.selectedIndexes();
    std::sort(selected.begin(), selected.end());
    QString text;
    int row = -1;
    for (const QModelIndex &index : selected) {
        if (!index.data().isValid())
            continue;
        if (!text.isEmpty())
            text += index.row() == row ? u'\t' : u'\n';
        row = index.row();
        text += textOf(index);
    }
    return text;
}

void copyToClipboard(const QString &text)
{
    QGuiApplication::clipboard()->setText(text);
}

void addCopyActions(QMenu &menu, const Copyable &number, const Copyable &whole)
{
    using pipeline::MatrixSyntax;
    if (!number.numbers.empty()) {
        const QString text = shortestText(number.numbers.front());
        menu.addAction(CopyMenu::tr("&Copy %1").arg(text), &menu, [text] { copyToClipboard(text); });
    }
    if (whole.numbers.empty())
        return;
    if (!number.numbers.empty())
        menu.addSeparator();
    const auto add = [&](const QString &format, MatrixSyntax syntax) {
        const QString text =
            QString::fromStdString(pipeline::formatted(whole.numbers, syntax, whole.name.toStdString()));
        QAction *action = menu.addAction(format.arg(whole.name), &menu, [text] { copyToClipboard(text); });
        action->setToolTip(text.trimmed());
    };
    menu.setToolTipsVisible(true);
    add(CopyMenu::tr("Copy %1 as &text"), MatrixSyntax::Text);
    add(CopyMenu::tr("Copy %1 as C &array"), MatrixSyntax::CArray);
    add(CopyMenu::tr("Copy %1 as &GLM"), MatrixSyntax::Glm);
    add(CopyMenu::tr("Copy %1 as &NumPy"), MatrixSyntax::NumPy);
    add(CopyMenu::tr("Copy %1 as &LaTeX"), MatrixSyntax::Latex);
    add(CopyMenu::tr("Copy %1 as C&SV"), MatrixSyntax::Csv);
}

void showCopyMenu(QWidget &parent, const QPoint &globalPosition, const Copyable &number, const Copyable &whole)
{
    if (number.numbers.empty() && whole.numbers.empty())
        return;
    auto *menu = new QMenu(&parent);
    menu->setAttribute(Qt::WA_DeleteOnClose);
    addCopyActions(*menu, number, whole);
    menu->popup(globalPosition);
}

} // namespace unprojector::gui
