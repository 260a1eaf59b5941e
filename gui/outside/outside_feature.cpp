#include "gui/outside/outside_feature.h"

#include "core/lessons/lesson.h"
#include "gui/document/session.h"
#include "gui/outside/observer_inset.h"
#include "gui/outside/observer_panel.h"
#include "gui/outside/observer_view.h"
#include "gui/window/actions.h"
#include "gui/window/feature.h"
#include "gui/window/view_frame.h"
#include "gui/window/window.h"

#include <QAction>
#include <QDockWidget>
#include <QMenu>
#include <QSettings>
#include <QTimer>
#include <QToolBar>
#include <QVBoxLayout>

#include <algorithm>
#include <set>
#include <utility>

namespace unprojector::gui {
using lessons::Highlight;

class OutsideFeature : public Feature {
    Q_OBJECT
public:
    explicit OutsideFeature(Window &window);

    std::vector<PanelSpec> panels() override
    {
        return {{Panel::Observer, tr("View from Outside"), m_home, Qt::RightDockWidgetArea, {}, true}};
    }
    void addActions(MenuKind kind, QMenu &menu, QToolBar &bar) override;
    bool follow(const lessons::Link &link) override;
    QVariantMap state() const override;
    void restore(const QVariantMap &state) override;
    void keep(QSettings &settings) const override;
    void restore(const QSettings &settings) override;

private:
    void show(bool isShown);
    /// Creates the panel in a dock or over the view, as it was last.
    void create();
    /// The panel, created on demand.
    ObserverPanel &panel();
    void dock(bool isDocked);
    /// Returns whether the user last left it in a dock.
    bool wasDocked() const
    {
        return m_window.remembers() && QSettings().value(QStringLiteral("observer/isDocked"), false).toBool();
    }
    void showStep(const lessons::Step *step);
    /// Shows it beside the view when a lesson refers to it.
    void showInLesson();

    Window &m_window;
    QWidget *m_home;                     ///< the panel's container in its dock
    ObserverPanel *m_panel = nullptr;    ///< created on demand
    ObserverInset *m_inset = nullptr;    ///< the panel's container over the view, if it is there
    QSizeF m_insetShare;                 ///< its last share of the view
    std::set<Highlight> m_highlights;    ///< of the step
    std::optional<QVariantMap> m_before; ///< the state before steps of a lesson showed the panel
    QAction *m_action = nullptr;
};

OutsideFeature::OutsideFeature(Window &window) : Feature(&window), m_window(window), m_home(new QWidget)
{
    m_home->setLayout(new QVBoxLayout);
    m_home->layout()->setContentsMargins(0, 0, 0, 0);
    connect(&window, &Window::stepShown, this, &OutsideFeature::showStep);
    connect(&window, &Window::smoothEdgesChanged, this, [this](bool isSmooth) {
        if (m_panel)
            m_panel->view().setSmoothEdges(isSmooth);
    });
}

void OutsideFeature::addActions(MenuKind kind, QMenu &menu, QToolBar &bar)
{
    if (kind != MenuKind::View)
        return;
    m_action = addSwitch(menu, tr("&View from Outside"), Qt::Key_0,
                         tr("Show the camera and its view volume from outside, in a corner of the view or in a panel"));
    m_action->setObjectName(QStringLiteral("outside"));
    connect(m_action, &QAction::toggled, this, &OutsideFeature::show);
    putOnBar(bar, *m_action, Drawing::FromOutside);
    Workspaces &workspaces = m_window.workspaces();
    connect(&workspaces, &Workspaces::laidOut, this,
            [this, &workspaces] { workspaces.dock(Panel::Observer).setVisible(m_action->isChecked() && !m_inset); });
    connect(&workspaces, &Workspaces::closed, this, [this](Panel panel) {
        if (panel == Panel::Observer)
            m_action->setChecked(false);
    });
}

void OutsideFeature::show(bool isShown)
{
    if (!m_panel) {
        if (!isShown)
            return;
        create();
    }
    if (m_inset)
        m_inset->setVisible(isShown);
    else
        m_window.workspaces().dock(Panel::Observer).setVisible(isShown);
    m_panel->setVisible(isShown);
}

void OutsideFeature::create()
{
    m_panel = new ObserverPanel(m_window.document());
    m_panel->view().setSmoothEdges(m_window.hasSmoothEdges());
    m_panel->view().setModelStore(m_window.session().models());
    m_panel->view().setHighlights(m_highlights);
    connect(&m_panel->view(), &ObserverView::failed, &m_window, &Window::showFailure);
    connect(&m_panel->view(), &ObserverView::quantityPointed, &m_window, &Window::quantityPointed);
    connect(&m_window, &Window::termPointed, &m_panel->view(), &ObserverView::setMarkedTerm);
    connect(m_panel, &ObserverPanel::dockRequested, this, &OutsideFeature::dock);
    connect(m_panel, &ObserverPanel::closeRequested, m_action, [this] { m_action->setChecked(false); });
    dock(wasDocked());
}

ObserverPanel &OutsideFeature::panel()
{
    if (!m_panel)
        create();
    return *m_panel;
}

void OutsideFeature::dock(bool isDocked)
{
    ObserverPanel &docked = panel();
    docked.setIsInset(!isDocked);
    if (isDocked) {
        m_home->layout()->addWidget(&docked);
        if (m_inset)
            m_insetShare = m_inset->share();
        delete m_inset;
        m_inset = nullptr;
        m_window.workspaces().show(Panel::Observer);
    } else {
        m_inset = new ObserverInset(docked, m_window.frame(), m_insetShare);
        m_window.workspaces().dock(Panel::Observer).hide();
        m_inset->show();
    }
    docked.show();
    if (m_window.remembers() && !m_before)
        QSettings().setValue(QStringLiteral("observer/isDocked"), isDocked);
}

bool OutsideFeature::follow(const lessons::Link &link)
{
    const auto *panel = std::get_if<lessons::PanelLink>(&link);
    if (!panel || panel->panel != Panel::Observer)
        return false;
    showInLesson();
    return true;
}

void OutsideFeature::showStep(const lessons::Step *step)
{
    m_highlights = step ? step->highlights : std::set<Highlight>();
    if (m_panel)
        m_panel->view().setHighlights(m_highlights);
    if (!step) {
        m_before.reset(); // the window restores the state before the lesson
        return;
    }
    // Shows what the step labels with letters.
    const bool hasCube = m_highlights.contains(Highlight::Cube);
    if (hasCube || m_highlights.contains(Highlight::Volume)
        || std::count(step->panels.begin(), step->panels.end(), Panel::Observer) > 0) {
        showInLesson();
        panel().view().setMorph(hasCube ? 1.0 : 0.0);
    } else if (const auto before = std::exchange(m_before, std::nullopt)) {
        restore(*before);
    }
}

void OutsideFeature::showInLesson()
{
    QVariantMap before = state();
    m_action->setChecked(true);
    if (!m_before)
        m_before = std::move(before);
    Workspaces &workspaces = m_window.workspaces();
    if (m_inset) {
        dock(true);
        // Half of the height: the panel below has less to show. After the layout.
        QTimer::singleShot(0, this, [this, &workspaces] {
            m_window.resizeDocks({&workspaces.dock(Panel::Observer)}, {m_window.height() / 2}, Qt::Vertical);
        });
    }
    workspaces.show(Panel::Observer);
    workspaces.giveRoom(Panel::Pipeline, Panel::Observer); // except the pipeline, which has columns of numbers
}

QVariantMap OutsideFeature::state() const
{
    return {{QStringLiteral("isShown"), m_action->isChecked()},
            {QStringLiteral("isDocked"), m_panel ? !m_inset : wasDocked()},
            {QStringLiteral("morph"), m_panel ? m_panel->view().morph() : 0.0}};
}

void OutsideFeature::restore(const QVariantMap &state)
{
    const bool isShown = state[QStringLiteral("isShown")].toBool(),
               isDocked = state[QStringLiteral("isDocked")].toBool();
    if (m_panel) {
        m_panel->view().setMorph(state[QStringLiteral("morph")].toDouble());
        if (isDocked == (m_inset != nullptr))
            dock(isDocked);
    }
    m_action->setChecked(isShown);
    show(isShown);
}

void OutsideFeature::keep(QSettings &settings) const
{
    settings.setValue(QStringLiteral("observer/share"), m_inset ? m_inset->share() : m_insetShare);
    settings.setValue(QStringLiteral("observer/isShown"), m_action->isChecked());
}

void OutsideFeature::restore(const QSettings &settings)
{
    m_insetShare = settings.value(QStringLiteral("observer/share")).toSizeF();
    m_action->setChecked(settings.value(QStringLiteral("observer/isShown"), false).toBool());
}

Feature *makeOutsideFeature(Window &window)
{
    return new OutsideFeature(window);
}

} // namespace unprojector::gui

#include "outside_feature.moc"
