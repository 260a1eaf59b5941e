#include "gui/landmarks/computing_button.h"

#include "gui/document/scene_curves.h"

#include <QCoreApplication>
#include <QToolButton>
#include <QTreeWidget>

#include <cmath>

namespace unprojector::gui {
namespace {

struct Texts {
    Q_DECLARE_TR_FUNCTIONS(unprojector::gui::ComputingButton)
};

} // namespace

void showComputing(QTreeWidget &rows, QTreeWidgetItem &row, int column, SceneCurves &curves, bool isComputing)
{
    if (!isComputing) {
        rows.removeItemWidget(&row, column);
        return;
    }
    if (rows.itemWidget(&row, column))
        return;
    auto *button = new QToolButton;
    button->setAutoFillBackground(true); // the cell's text is below it
    button->setToolTip(Texts::tr("Cancel the computation of curves on the surface"));
    const auto showShare = [button, &curves] {
        button->setText(Texts::tr("Cancel, %1 %").arg(std::floor(100.0 * curves.progress().share)));
    };
    showShare();
    QObject::connect(&curves, &SceneCurves::progressed, button, showShare);
    // Deferred, because cancelling removes the button.
    QObject::connect(button, &QToolButton::clicked, &curves, &SceneCurves::cancel, Qt::QueuedConnection);
    rows.setItemWidget(&row, column, button);
}

} // namespace unprojector::gui
