#include "gui/parameters/parameters_feature.h"

#include "gui/document/session.h"
#include "gui/parameters/parameters_panel.h"
#include "gui/parameters/viewport_group.h"
#include "gui/window/actions.h"
#include "gui/window/feature.h"
#include "gui/window/kept_bytes.h"
#include "gui/window/window.h"

#include <QSettings>

namespace unprojector::gui {

class ParametersFeature : public Feature {
    Q_OBJECT
public:
    explicit ParametersFeature(Window &window) : Feature(&window), m_panel(new ParametersPanel(window.document()))
    {
        connect(&window.session(), &Session::commitPendingEdits, m_panel, &ParametersPanel::applyTyped);
        connect(m_panel->findChild<ViewportGroup *>(), &ViewportGroup::sizeRequested, &window,
                [&window] { trigger(window, kViewSizeAction); });
    }

    std::vector<PanelSpec> panels() override
    {
        return {{Panel::Parameters, tr("Parameters"), m_panel, Qt::LeftDockWidgetArea, Qt::ALT | Qt::Key_3}};
    }
    void keep(QSettings &settings) const override
    {
        settings.setValue(QLatin1String(kState), sealed(m_panel->saveState(), kState));
    }
    void restore(const QSettings &settings) override
    {
        m_panel->restoreState(unsealed(settings.value(QLatin1String(kState)), kState));
    }
    using Feature::restore;

private:
    static constexpr char kState[] = "parameters/state";

    ParametersPanel *m_panel;
};

Feature *makeParametersFeature(Window &window)
{
    return new ParametersFeature(window);
}

} // namespace unprojector::gui

#include "parameters_feature.moc"
