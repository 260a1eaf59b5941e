#include "gui/objects/objects_feature.h"

#include "gui/document/session.h"
#include "gui/objects/objects_panel.h"
#include "gui/window/feature.h"
#include "gui/window/window.h"

namespace unprojector::gui {

class ObjectsFeature : public Feature {
    Q_OBJECT
public:
    explicit ObjectsFeature(Window &window) : Feature(&window), m_panel(new ObjectsPanel(window.document()))
    {
        connect(&window.session(), &Session::commitPendingEdits, m_panel, &ObjectsPanel::applyTyped);
    }

    std::vector<PanelSpec> panels() override
    {
        return {{Panel::Objects, tr("Objects"), m_panel, Qt::RightDockWidgetArea, Qt::ALT | Qt::Key_6}};
    }

private:
    ObjectsPanel *m_panel;
};

Feature *makeObjectsFeature(Window &window)
{
    return new ObjectsFeature(window);
}

} // namespace unprojector::gui

#include "objects_feature.moc"
