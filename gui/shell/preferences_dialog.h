#pragma once

#include <QDialog>
#include <QString>

class QAction;
class QComboBox;
class QMenu;

namespace unprojector::gui {

/// The choices that last from one start of the program to the next, in one form. It shows the
/// actions of the menus and triggers them: a choice applies at once, as in the menus.
class PreferencesDialog : public QDialog {
    Q_OBJECT
public:
    /// The actions behind the form. They outlive the dialog.
    struct Choices {
        const QMenu *colours = nullptr;
        const QMenu *languages = nullptr; ///< null: there is no such choice
        QAction *smoothEdges = nullptr;
    };
    explicit PreferencesDialog(const Choices &choices, QWidget *parent = nullptr);

signals:
    void firstStepsRequested();
    void layoutResetRequested();

private:
    /// A combo box with the checkable actions of a menu.
    QComboBox *boxOf(const QMenu &menu, const QString &name, const QString &toolTip);
};

} // namespace unprojector::gui
