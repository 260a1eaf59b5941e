#include "gui/doctor/doctor_feature.h"

#include "gui/doctor/doctor_panel.h"
#include "gui/view/scene_view.h"
#include "gui/window/feature.h"
#include "gui/window/panel_scroll.h"
#include "gui/window/window.h"

namespace unprojector::gui {

class DoctorFeature : public Feature {
    Q_OBJECT
public:
    explicit DoctorFeature(Window &window) : Feature(&window), m_panel(new DoctorPanel(window.document()))
    {
        connect(m_panel, &DoctorPanel::pickRequested, &window.view(), &SceneView::pickPixel);
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

private:
    DoctorPanel *m_panel;
};

Feature *makeDoctorFeature(Window &window)
{
    return new DoctorFeature(window);
}

} // namespace unprojector::gui

#include "doctor_feature.moc"
