#include "gui/click/click_feature.h"

#include "gui/click/comparison_panel.h"
#include "gui/click/pick_strip.h"
#include "gui/document/picks.h"
#include "gui/document/scene_document.h"
#include "gui/view/drop_labels.h"
#include "gui/view/scene_view.h"
#include "gui/window/actions.h"
#include "gui/window/feature.h"
#include "gui/window/panel_scroll.h"
#include "gui/window/window.h"

#include <QAction>
#include <QActionGroup>
#include <QEvent>
#include <QLayout>
#include <QMenu>
#include <QSettings>
#include <QToolBar>
#include <QToolButton>

#include <cmath>
#include <utility>

namespace unprojector::gui {
using namespace geometry;

namespace {

/// Returns whether a click lies on the mark of the picked point in the current view.
bool isAtPickMark(const SceneDocument &document, const unproject::PixelClick &click)
{
    constexpr double kReach = 8.0; // logical pixels, around the mark
    const std::optional<WorldPoint> point = document.picks().pickedPoint();
    const std::optional<QPointF> mark = point ? widgetOf(document.setup(), *point) : std::nullopt;
    return mark && std::hypot(mark->x() - click.position.x, mark->y() - click.position.y) <= kReach;
}

} // namespace

/// A tool bar without margins in every style.
class FlushBar : public QToolBar {
    Q_OBJECT
public:
    FlushBar(const QString &title, QWidget *parent) : QToolBar(title, parent)
    {
        layout()->setContentsMargins(0, 0, 0, 0);
    }

protected:
    void changeEvent(QEvent *event) override
    {
        QToolBar::changeEvent(event);
        if (event->type() == QEvent::StyleChange)
            layout()->setContentsMargins(0, 0, 0, 0);
    }
};

class ClickFeature : public Feature {
    Q_OBJECT
public:
    explicit ClickFeature(Window &window);

    std::vector<PanelSpec> panels() override
    {
        return {{Panel::Comparison, tr("Comparison"), new PanelScroll(m_comparison), Qt::RightDockWidgetArea,
                 Qt::ALT | Qt::Key_1}};
    }
    std::optional<WorkspaceSpec> workspace() override
    {
        return WorkspaceSpec{Workspace::Click, tr("Click"), tr("The view and the answer to a click"),
                             Drawing::Click,   Qt::Key_F5,  {Panel::Comparison, Panel::Objects}};
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
        settings.setValue(kShowsStrip, m_isStripWanted);
        settings.setValue(kShowsFloat, m_comparison->showsFloat());
        settings.setValue(kShowsRay, m_comparison->showsRay());
        settings.setValue(kOpenFolds, m_comparison->openFolds());
    }
    void restore(const QSettings &settings) override
    {
        m_isStripWanted = settings.value(kShowsStrip, true).toBool();
        placeStrip();
        m_comparison->setShowsFloat(settings.value(kShowsFloat, false).toBool());
        m_comparison->setShowsRay(settings.value(kShowsRay, false).toBool());
        m_comparison->setOpenFolds(settings.value(kOpenFolds).toStringList());
    }

private:
    static inline const QString kSnap = QStringLiteral("snap"), kShowsStrip = QStringLiteral("window/showsStrip"),
                                kShowsFloat = QStringLiteral("comparison/showsFloat"),
                                kShowsRay = QStringLiteral("comparison/showsRay"),
                                kOpenFolds = QStringLiteral("comparison/openFolds");

    void placeStrip();
    void addSnaps(QMenu &menu);
    void addSnapButton(QToolBar &bar);
    void addCopy(QMenu &menu);

    Window &m_window;
    SceneDocument &m_document;
    ComparisonPanel *m_comparison;
    PickStrip *m_strip;
    QToolBar *m_bar; ///< of the strip
    bool m_isStripWanted = true;
    bool m_isInLesson = false;
    bool m_isAtPick = false; ///< the pointer
    QActionGroup *m_snaps = nullptr;
};

ClickFeature::ClickFeature(Window &window)
    : Feature(&window), m_window(window), m_document(window.document()), m_comparison(new ComparisonPanel(m_document)),
      m_strip(new PickStrip), m_bar(new FlushBar(tr("Pick in Every Space"), &window))
{
    connect(m_comparison, &ComparisonPanel::pickRequested, &window.view(), &SceneView::onLButtonDown);
    connect(m_comparison, &ComparisonPanel::termPointed, &window, &Window::termPointed);
    connect(&window, &Window::termPointed, &window.view(), &SceneView::setMarkedTerm);
    connect(&window, &Window::quantityPointed, m_comparison, &ComparisonPanel::markTerm);
    connect(&window, &Window::pointed, this, [this](const std::optional<unproject::PixelClick> &click) {
        const bool isAtPick = click && isAtPickMark(m_document, *click);
        if (std::exchange(m_isAtPick, isAtPick) != isAtPick)
            emit m_window.quantityPointed(isAtPick ? QStringLiteral("world") : QString());
    });
    connect(m_strip, &PickStrip::stageRequested, &window, [this](pipeline::PipelineStage stage) {
        m_window.workspaces().enter(Workspace::Pipeline);
        m_window.follow(lessons::MatrixLink{stage});
        emit m_window.clickValuesWanted(); // the numbers that were clicked
    });
    connect(&m_document, &SceneDocument::changed, m_strip, [this](Changes changes) {
        const SinceClick since = m_document.picks().sinceClick();
        m_strip->setStale(since.isOtherSetup || since.isObjectMoved);
        if (changes & (Change::Pick | Change::Ray | Change::Objects))
            m_strip->setPick(m_document.picks().keptPick(), m_document.picks().pickedPoint(),
                             m_document.picks().pick() ? pickedUncertainty(m_document.picks().keptPick())
                                                       : WorldVector());
    });
    m_bar->setObjectName(QStringLiteral("strip"));
    m_bar->setMovable(false);
    m_bar->addWidget(m_strip);
    connect(m_bar->toggleViewAction(), &QAction::triggered, this, [this](bool isShown) { m_isStripWanted = isShown; });
    connect(&window, &Window::stepShown, this, [this](const lessons::Step *step) {
        m_isInLesson = step != nullptr;
        placeStrip();
    });
}

/// Puts the strip under the view and its panels, as wide as the window, in every workspace. Lessons
/// ask for such numbers: there it is hidden.
void ClickFeature::placeStrip()
{
    if (m_window.toolBarArea(m_bar) != Qt::BottomToolBarArea) // the saved layout may be older than the strip
        m_window.addToolBar(Qt::BottomToolBarArea, m_bar);
    m_bar->setVisible(m_isStripWanted && !m_isInLesson && !m_window.workspaces().arePanelsHidden());
}

void ClickFeature::addActions(MenuKind kind, QMenu &menu, QToolBar &bar)
{
    if (kind == MenuKind::Help)
        addSnapButton(bar);
    if (kind != MenuKind::Edit)
        return;
    addSnaps(menu);
    m_window.addToolBar(Qt::BottomToolBarArea, m_bar);
    connect(&m_window.workspaces(), &Workspaces::laidOut, this, &ClickFeature::placeStrip);
    connect(&m_window.workspaces(), &Workspaces::panelsHidden, this, &ClickFeature::placeStrip);
}

void ClickFeature::addSnaps(QMenu &menu)
{
    menu.addSeparator();
    addCopy(menu);
    menu.addSection(tr("Snap To"));
    m_snaps = new QActionGroup(&menu);
    const auto add = [&](const char *name, ray::Snap snap, const QString &text, const QKeySequence &key,
                         const QString &tip, Drawing drawing) {
        QAction *action = addSwitch(menu, text, key, tip);
        connect(action, &QAction::triggered, this, [this, snap] { m_document.picks().setSnap(snap); });
        action->setChecked(snap == m_document.picks().snap());
        action->setActionGroup(m_snaps);
        action->setData(static_cast<int>(snap));
        action->setObjectName(QLatin1String(name)); // for links in lessons
        action->setIcon(drawnIcon(drawing));
    };
    add("surface", ray::Snap::Surface, tr("&Surface"), Qt::Key_S, tr("A click picks the surface under the pointer"),
        Drawing::Surface);
    add("vertex", ray::Snap::Vertex, tr("&Vertex"), Qt::Key_V,
        tr("A click picks the visible vertex within 8 pixels, with its exact coordinate"), Drawing::Vertex);
    add("edge", ray::Snap::Edge, tr("&Edge"), Qt::Key_E,
        tr("A click picks the nearest point of a visible edge within 8 pixels"), Drawing::Edge);
    add("face", ray::Snap::Face, tr("&Face"), Qt::SHIFT | Qt::Key_F,
        tr("A click picks the face under the pointer, with its plane"), Drawing::Face);
}

/// Last on the bar: its text changes its width.
void ClickFeature::addSnapButton(QToolBar &bar)
{
    auto *button = new QToolButton;
    button->setMenu(new QMenu(button));
    button->menu()->addActions(m_snaps->actions());
    button->setPopupMode(QToolButton::InstantPopup);
    button->setToolTip(tr("Snap clicks to the surface, a vertex, an edge or a face"));
    button->setObjectName(QStringLiteral("snap"));
    const auto show = [button](const QAction *action) {
        button->setText(tr("Snap: %1").arg(action->iconText()));
        button->setIcon(action->icon());
    };
    show(m_snaps->checkedAction());
    connect(m_snaps, &QActionGroup::triggered, button, show);
    bar.addWidget(button);
}

void ClickFeature::addCopy(QMenu &menu)
{
    QAction *copy = addAction(menu, tr("&Copy"), QKeySequence::Copy, {}, [this] { m_comparison->copyAnswer(); });
    copy->setObjectName(QStringLiteral("copyPick"));
    // Texts and tables copy their own selection: the key is only for the view.
    copy->setShortcutContext(Qt::WidgetShortcut);
    m_window.view().addAction(copy);
    const auto show = [this, copy] {
        const bool isThere = m_document.picks().pick().has_value();
        const QString tip = isThere ? tr("Copy the coordinate of the pick with all its digits")
                                    : tr("There is no pick to copy. Click the model first.");
        copy->setEnabled(isThere);
        copy->setToolTip(tip);
        copy->setStatusTip(tip);
    };
    connect(&m_document, &SceneDocument::changed, copy, [show](Changes changes) {
        if (changes & Change::Pick)
            show();
    });
    show();
}

Feature *makeClickFeature(Window &window)
{
    return new ClickFeature(window);
}

} // namespace unprojector::gui

#include "click_feature.moc"
