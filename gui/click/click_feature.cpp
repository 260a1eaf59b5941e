#include "gui/click/click_feature.h"

#include "gui/click/comparison_panel.h"
#include "gui/document/picks.h"
#include "gui/document/scene_document.h"
#include "gui/view/scene_view.h"
#include "gui/window/actions.h"
#include "gui/window/feature.h"
#include "gui/window/panel_scroll.h"
#include "gui/window/window.h"

#include <QAction>
#include <QActionGroup>
#include <QMenu>
#include <QSettings>
#include <QToolBar>

namespace unprojector::gui {

class ClickFeature : public Feature {
    Q_OBJECT
public:
    explicit ClickFeature(Window &window)
        : Feature(&window), m_document(window.document()), m_comparison(new ComparisonPanel(m_document))
    {
        connect(m_comparison, &ComparisonPanel::pickRequested, &window.view(), &SceneView::onLButtonDown);
    }

    std::vector<PanelSpec> panels() override
    {
        return {{Panel::Comparison, tr("Comparison"), new PanelScroll(m_comparison), Qt::RightDockWidgetArea,
                 Qt::ALT | Qt::Key_1}};
    }
    std::optional<WorkspaceSpec> workspace() override
    {
        return WorkspaceSpec{Workspace::Click,
                             tr("Click"),
                             tr("The view and what a click gives"),
                             Qt::Key_F5,
                             {Panel::Comparison, Panel::Objects}};
    }
    void addActions(MenuKind kind, QMenu &menu, QToolBar &bar) override;

    QVariantMap state() const override { return {{kSnap, m_snaps->checkedAction()->data()}}; }
    void restore(const QVariantMap &state) override
    {
        for (QAction *action : m_snaps->actions()) {
            if (action->data() == state.value(kSnap))
                action->trigger();
        }
    }
    void keep(QSettings &settings) const override
    {
        settings.setValue(kShowsFloat, m_comparison->showsFloat());
        settings.setValue(kShowsRay, m_comparison->showsRay());
        settings.setValue(kOpenFolds, m_comparison->openFolds());
    }
    void restore(const QSettings &settings) override
    {
        m_comparison->setShowsFloat(settings.value(kShowsFloat, false).toBool());
        m_comparison->setShowsRay(settings.value(kShowsRay, false).toBool());
        m_comparison->setOpenFolds(settings.value(kOpenFolds).toStringList());
    }

private:
    static inline const QString kSnap = QStringLiteral("snap"), kShowsFloat = QStringLiteral("comparison/showsFloat"),
                                kShowsRay = QStringLiteral("comparison/showsRay"),
                                kOpenFolds = QStringLiteral("comparison/openFolds");

    SceneDocument &m_document;
    ComparisonPanel *m_comparison;
    QActionGroup *m_snaps = nullptr;
};

void ClickFeature::addActions(MenuKind kind, QMenu &menu, QToolBar &bar)
{
    if (kind != MenuKind::Edit)
        return;
    menu.addSeparator();
    menu.addSection(tr("A Click Takes"));
    m_snaps = new QActionGroup(&menu);
    const auto add = [&](const char *name, ray::Snap snap, const QString &text, const QKeySequence &key,
                         const QString &tip, Drawing drawing) {
        QAction *action = addSwitch(menu, text, key, tip);
        connect(action, &QAction::triggered, this, [this, snap] { m_document.picks().setSnap(snap); });
        action->setChecked(snap == m_document.picks().snap());
        action->setActionGroup(m_snaps);
        action->setData(static_cast<int>(snap));
        action->setObjectName(QLatin1String(name)); // by which lessons link to it
        putOnBar(bar, *action, drawing);
    };
    add("surface", ray::Snap::Surface, tr("&Surface"), Qt::Key_S, tr("A click takes the surface under it"),
        Drawing::Surface);
    add("vertex", ray::Snap::Vertex, tr("&Vertex"), Qt::Key_V,
        tr("A click takes the vertex in sight within 8 pixels, its very coordinate"), Drawing::Vertex);
    add("edge", ray::Snap::Edge, tr("&Edge"), Qt::Key_E,
        tr("A click takes the nearest point of an edge in sight within 8 pixels"), Drawing::Edge);
    add("face", ray::Snap::Face, tr("&Face"), Qt::SHIFT | Qt::Key_F,
        tr("A click takes the face under it, with its plane"), Drawing::Face);
    bar.addSeparator();
}

Feature *makeClickFeature(Window &window)
{
    return new ClickFeature(window);
}

} // namespace unprojector::gui

#include "click_feature.moc"
