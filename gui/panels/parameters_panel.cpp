#include "gui/panels/parameters_panel.h"

#include "gui/panels/parameters/clip_tab.h"
#include "gui/panels/parameters/model_tab.h"
#include "gui/panels/parameters/projection_tab.h"
#include "gui/panels/parameters/view_tab.h"
#include "gui/panels/parameters/viewport_tab.h"

#include <QProxyStyle>
#include <QTabBar>

namespace unprojector::gui {
namespace {

/// Tabs as narrow as their words, so that all five fit beside each other in a narrow dock.
class NarrowTabStyle : public QProxyStyle {
public:
    int pixelMetric(PixelMetric metric, const QStyleOption *option, const QWidget *widget) const override
    {
        constexpr int kPadding = 5;
        return metric == PM_TabBarTabHSpace ? kPadding : QProxyStyle::pixelMetric(metric, option, widget);
    }
};

} // namespace

ParametersPanel::ParametersPanel(SceneDocument &document, QWidget *parent) : QTabWidget(parent)
{
    auto *narrow = new NarrowTabStyle;
    narrow->setParent(tabBar());
    tabBar()->setStyle(narrow);
    tabBar()->setElideMode(Qt::ElideNone);
    tabBar()->setAccessibleName(tr("Parameters"));
    setDocumentMode(true);
    const auto add = [this](QWidget *tab, const QString &name, const QString &objectName, const QString &tip) {
        tab->setObjectName(objectName);
        setTabToolTip(addTab(tab, name), tip);
    };
    add(new ViewTab(document), tr("View"), QStringLiteral("viewTab"), tr("Where the camera stands (gluLookAt)"));
    add(new ProjectionTab(document), tr("Projection"), QStringLiteral("projectionTab"),
        tr("glFrustum, gluPerspective, glOrtho, oblique"));
    add(new ViewportTab(document), tr("Viewport"), QStringLiteral("viewportTab"), tr("glViewport and glDepthRange"));
    add(new ModelTab(document), tr("Model"), QStringLiteral("modelTab"),
        tr("Where each object stands (glTranslate, glRotate, glScale)"));
    add(new ClipTab(document), tr("Clip"), QStringLiteral("clipTab"), tr("Planes that cut the objects (glClipPlane)"));
}

} // namespace unprojector::gui
