#include "gui/map/map_feature.h"

#include "gui/document/session.h"
#include "gui/map/map_overlay.h"
#include "gui/map/map_panel.h"
#include "gui/text/error_text.h"
#include "gui/view/scene_view.h"
#include "gui/widgets/save_name.h"
#include "gui/window/actions.h"
#include "gui/window/feature.h"
#include "gui/window/view_frame.h"
#include "gui/window/window.h"

#include <QAction>
#include <QMenu>

namespace unprojector::gui {
using namespace unproject;

class MapFeature : public Feature {
    Q_OBJECT
public:
    explicit MapFeature(Window &window);

    void addActions(MenuKind kind, QMenu &menu, QToolBar &) override;
    QVariantMap state() const override { return {{kIsShown, m_action->isChecked()}}; }
    void restore(const QVariantMap &state) override { m_action->setChecked(state[kIsShown].toBool()); }
    using Feature::restore;

private:
    static inline const QString kIsShown = QStringLiteral("isShown");

    void exportMap();

    Window &m_window;
    MapOverlay *m_map;
    QAction *m_action = nullptr;
};

MapFeature::MapFeature(Window &window) : Feature(&window), m_window(window)
{
    m_map = new MapOverlay(window.document(), window.view());
    m_map->setParent(this);
    window.frame().add(m_map->panel(), Qt::AlignTop | Qt::AlignRight);
    window.view().setCornerWidget(&m_map->panel());
    connect(&window, &Window::pointed, m_map, [this](const std::optional<PixelClick> &click) {
        m_map->setPointer(click ? std::optional(click->position) : std::nullopt);
    });
    connect(m_map, &MapOverlay::closeRequested, this, [this] { m_action->setChecked(false); });
    connect(&m_map->panel(), &MapPanel::exportRequested, this, &MapFeature::exportMap);
}

void MapFeature::addActions(MenuKind kind, QMenu &menu, QToolBar &)
{
    if (kind != MenuKind::View)
        return;
    m_action = addSwitch(menu, tr("&Error Map"), Qt::Key_M,
                         tr("Show for every pixel the difference of the methods, the uncertainty of a click, or the "
                            "error of another program"));
    m_action->setObjectName(QStringLiteral("error_map"));
    connect(m_action, &QAction::toggled, m_map, &MapOverlay::setShown);
}

void MapFeature::exportMap()
{
    const SaveName named =
        askSaveName(m_window, tr("Export Map"), {tr("Image with its scale (*.png)"), tr("Float map (*.pfm)")},
                    pathText(m_window.session().proposedName().stem()) + QStringLiteral("-map"), FileKind::Map);
    if (named.file.empty() || !m_window.mayExportTo(named.file))
        return;
    if (const QString problem = m_map->exportTo(named.file); !problem.isEmpty())
        m_window.showFailure(problem);
    else
        m_window.notice(tr("Map written to %1").arg(pathText(named.file.filename())));
}

Feature *makeMapFeature(Window &window)
{
    return new MapFeature(window);
}

} // namespace unprojector::gui

#include "map_feature.moc"
