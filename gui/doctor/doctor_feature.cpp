#include "gui/doctor/doctor_feature.h"

#include "gui/doctor/code_changes_view.h"
#include "gui/doctor/doctor_panel.h"
#include "gui/document/session.h"
#include "gui/view/scene_view.h"
#include "gui/window/actions.h"
#include "gui/window/feature.h"
#include "gui/window/panel_scroll.h"
#include "gui/window/window.h"

#include <QSettings>

namespace unprojector::gui {
namespace {

constexpr QLatin1String kLibrary("doctor/library");

} // namespace

class DoctorFeature : public Feature {
    Q_OBJECT
public:
    explicit DoctorFeature(Window &window) : Feature(&window), m_panel(new DoctorPanel(window.document()))
    {
        connect(m_panel, &DoctorPanel::pickRequested, &window.view(), &SceneView::pickPixel);
        connect(&window.session(), &Session::opened, m_panel, &DoctorPanel::followScene);
        connect(m_panel, &DoctorPanel::pasteCameraWanted, &window, [&window] { trigger(window, kPasteCameraAction); });
    }

    std::vector<PanelSpec> panels() override
    {
        return {{Panel::Doctor, tr("Doctor"), new PanelScroll(m_panel), Qt::RightDockWidgetArea, {}}};
    }
    std::optional<WorkspaceSpec> workspace() override
    {
        return WorkspaceSpec{
            Workspace::Doctor, tr("Doctor"), tr("Find the mistake that gives your program a wrong coordinate"),
            Drawing::Doctor,   Qt::Key_F8,   {Panel::Doctor, Panel::Objects}};
    }
    void keep(QSettings &settings) const override { settings.setValue(kLibrary, m_panel->code().chosenLibrary()); }
    void restore(const QSettings &settings) override
    {
        m_panel->code().setLibrary(settings.value(kLibrary).toString());
    }
    using Feature::restore;

private:
    DoctorPanel *m_panel;
};

Feature *makeDoctorFeature(Window &window)
{
    return new DoctorFeature(window);
}

} // namespace unprojector::gui

#include "doctor_feature.moc"
