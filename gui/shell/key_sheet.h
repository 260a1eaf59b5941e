#pragma once

#include <QDialog>

class QMenuBar;

namespace unprojector::gui {

/// The functions of mouse and keys, on a sheet that can stay open beside the window. The keys are
/// read from the menus, so none is missing.
class KeySheet : public QDialog {
    Q_OBJECT
public:
    KeySheet(const QMenuBar &menus, QWidget *parent);
};

} // namespace unprojector::gui
