#include "gui/panels/parameters_panel.h"

#include "gui/panels/parameters/clip_tab.h"
#include "gui/panels/parameters/model_tab.h"
#include "gui/panels/parameters/projection_tab.h"
#include "gui/panels/parameters/view_tab.h"
#include "gui/panels/parameters/viewport_tab.h"

#include <QTabBar>

namespace unprojector {
namespace {

/// Tabs as narrow as their words, so that all five fit beside each other in a narrow dock.
class NarrowTabBar : public QTabBar {
protected:
    QSize tabSizeHint(int index) const override
    {
        return {fontMetrics().horizontalAdvance(tabText(index)) + kPadding, QTabBar::tabSizeHint(index).height()};
    }
    QSize minimumTabSizeHint(int index) const override { return tabSizeHint(index); }

private:
    static constexpr int kPadding = 9;
};

} // namespace

ParametersPanel::ParametersPanel(SceneDocument &document, QWidget *parent) : QTabWidget(parent)
{
    setTabBar(new NarrowTabBar);
    tabBar()->setElideMode(Qt::ElideNone);
    tabBar()->setAccessibleName(tr("Parameters"));
    setDocumentMode(true);
    const auto add = [this](QWidget *tab, const QString &name, const QString &objectName, const QString &tip) {
        tab->setObjectName(objectName);
        setTabToolTip(addTab(tab, name), tip);
    };
    add(new ViewTab(document), tr("View"), QStringLiteral("viewTab"), tr("Where the camera stands (gluLookAt)"));
    add(new ProjectionTab(document), tr("Projection"), QStringLiteral("projectionTab"), tr("glFrustum, gluPerspective, glOrtho, oblique"));
    add(new ViewportTab(document), tr("Viewport"), QStringLiteral("viewportTab"), tr("glViewport and glDepthRange"));
    add(new ModelTab(document), tr("Model"), QStringLiteral("modelTab"), tr("Where each object stands (glTranslate, glRotate, glScale)"));
    add(new ClipTab(document), tr("Clip"), QStringLiteral("clipTab"), tr("Planes that cut the objects (glClipPlane)"));
}

} // namespace unprojector
