#include "gui/shell/preferences_dialog.h"

#include <QAction>
#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLabel>
#include <QMenu>
#include <QPushButton>
#include <QRegularExpression>
#include <QStandardItemModel>
#include <QVBoxLayout>

namespace unprojector::gui {
namespace {

/// The text without its key: "浅色" of "浅色(&L)".
QString withoutKey(QString text)
{
    static const QRegularExpression keyInParentheses(QStringLiteral("\\(&.\\)"));
    return text.remove(keyInParentheses).remove(u'&');
}

} // namespace

PreferencesDialog::PreferencesDialog(const Choices &choices, QWidget *parent) : QDialog(parent)
{
    setWindowTitle(tr("Preferences"));
    auto *form = new QFormLayout;
    form->addRow(tr("&Colours:"), boxOf(*choices.colours, tr("Colours"), tr("Light or dark windows")));
    if (choices.languages) {
        const QString toolTip = tr("The language of the program, from its next start on");
        form->addRow(tr("&Language:"), boxOf(*choices.languages, tr("Language"), toolTip));
        auto *note = new QLabel(tr("The new language is used from the next start on."));
        note->setWordWrap(true);
        form->addRow(QString(), note);
    }
    auto *smooth = new QCheckBox(withoutKey(choices.smoothEdges->text()));
    smooth->setToolTip(choices.smoothEdges->toolTip());
    smooth->setChecked(choices.smoothEdges->isChecked());
    connect(smooth, &QCheckBox::toggled, choices.smoothEdges, &QAction::setChecked);
    connect(choices.smoothEdges, &QAction::toggled, smooth, &QCheckBox::setChecked);
    form->addRow(tr("3-D view:"), smooth);

    auto *steps = new QPushButton(tr("Show First &Steps Again"));
    steps->setToolTip(tr("Show the three things to try, now and at the next start"));
    connect(steps, &QPushButton::clicked, this, &PreferencesDialog::firstStepsRequested);
    auto *layoutReset = new QPushButton(tr("&Reset Layout"));
    layoutReset->setToolTip(tr("Restore the default layout of all workspaces"));
    connect(layoutReset, &QPushButton::clicked, this, &PreferencesDialog::layoutResetRequested);
    form->addRow(tr("Start over:"), steps);
    form->addRow(QString(), layoutReset);

    auto *buttons = new QDialogButtonBox(QDialogButtonBox::Close);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    auto *layout = new QVBoxLayout(this);
    layout->addLayout(form);
    layout->addWidget(buttons);
}

QComboBox *PreferencesDialog::boxOf(const QMenu &menu, const QString &name, const QString &toolTip)
{
    auto *box = new QComboBox;
    box->setAccessibleName(name);
    box->setToolTip(toolTip);
    const QList<QAction *> actions = menu.actions();
    auto &items = *qobject_cast<QStandardItemModel *>(box->model());
    for (const QAction *action : actions) {
        box->addItem(withoutKey(action->text()));
        QStandardItem &item = *items.item(box->count() - 1);
        item.setToolTip(action->toolTip());
        item.setEnabled(action->isEnabled());
        if (action->isChecked())
            box->setCurrentIndex(box->count() - 1);
    }
    connect(box, &QComboBox::activated, this, [actions](int index) { actions.at(index)->trigger(); });
    return box;
}

} // namespace unprojector::gui
