#include "gui/lessons/lessons_feature.h"

#include "core/lessons/lesson.h"
#include "gui/document/picks.h"
#include "gui/document/scene_document.h"
#include "gui/document/session.h"
#include "gui/lessons/first_steps.h"
#include "gui/lessons/formulas_window.h"
#include "gui/lessons/lesson_layout.h"
#include "gui/lessons/lesson_panel.h"
#include "gui/lessons/lesson_player.h"
#include "gui/lessons/lesson_text.h"
#include "gui/lessons/manual_window.h"
#include "gui/view/scene_view.h"
#include "gui/view/view_keys.h"
#include "gui/widgets/help_link.h"
#include "gui/widgets/icons.h"
#include "gui/window/actions.h"
#include "gui/window/feature.h"
#include "gui/window/view_frame.h"
#include "gui/window/window.h"

#include <nlohmann/json.hpp>

#include <QAction>
#include <QApplication>
#include <QDockWidget>
#include <QKeyEvent>
#include <QMenu>
#include <QMouseEvent>
#include <QSettings>
#include <QTimer>
#include <QToolBar>
#include <QToolButton>

namespace unprojector::gui {
namespace {

void bringToFront(QWidget &window)
{
    window.show();
    window.raise();
    window.activateWindow();
}

} // namespace

class LessonsFeature : public Feature {
    Q_OBJECT
public:
    explicit LessonsFeature(Window &window);

    std::vector<PanelSpec> panels() override
    {
        return {{Panel::Lesson, tr("Lesson"), m_panel, Qt::LeftDockWidgetArea, {}, true}};
    }
    void addActions(MenuKind kind, QMenu &menu, QToolBar &) override;
    bool follow(const lessons::Link &link) override;
    void restore(const QSettings &settings) override;
    using Feature::restore;

protected:
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    void addLessonActions(QMenu &menu);
    void addToBar(QToolBar &bar);
    void connectWorkspaces();
    void leaveOrStay();
    /// Leaves a lesson after its end: restores a scene, not an empty view.
    void finish();
    void click(const std::string &point);
    void change(const std::string &name);
    void trigger(const lessons::ActionLink &link);
    void showFormulas(const QString &anchor);
    void showManual(const QString &place);
    void showFirstSteps(bool isShown);
    /// Shows the first steps only in the workspace Click, to which they refer.
    void placeFirstSteps();
    void tick(FirstSteps::Step step);
    void keepFirstSteps() const;

    static inline const QString kStepsDone = QStringLiteral("firstSteps/done"),
                                kAreStepsClosed = QStringLiteral("firstSteps/areDone");

    Window &m_window;
    LessonPlayer *m_player;
    LessonPanel *m_panel;
    LessonLayout *m_stage;
    QMenu *m_menu = nullptr;              ///< of the lessons
    FormulasWindow *m_formulas = nullptr; ///< made when it is first asked for
    ManualWindow *m_manual = nullptr;     ///< the same
    FirstSteps *m_firstSteps = nullptr;   ///< the same
    bool m_areFirstStepsShown = false;    ///< whether the user wants them
    QPointF m_pressed;                    ///< position of the left button's press in the view
};

LessonsFeature::LessonsFeature(Window &window)
    : Feature(&window), m_window(window), m_player(new LessonPlayer(window.document(), window.session(), this)),
      m_panel(new LessonPanel(*m_player, window.document())), m_stage(new LessonLayout(window, *m_player))
{
    connect(m_player, &LessonPlayer::aboutToBegin, m_stage, &LessonLayout::remember);
    connect(m_player, &LessonPlayer::aboutToBegin, this, [this] { tick(FirstSteps::Lesson); });
    connect(m_player, &LessonPlayer::changed, m_stage, &LessonLayout::showStep);
    connect(m_player, &LessonPlayer::changed, this, &LessonsFeature::placeFirstSteps);
    connect(m_player, &LessonPlayer::revealed, m_stage, &LessonLayout::showAnswer);
    connect(m_player, &LessonPlayer::clickWanted, this, &LessonsFeature::click);
    connect(m_player, &LessonPlayer::failed, &window, &Window::showFailure);
    connect(m_panel, &LessonPanel::closeRequested, m_player, &LessonPlayer::leave);
    connect(m_panel, &LessonPanel::finished, this, &LessonsFeature::finish);
    connect(m_panel, &LessonPanel::lessonRequested, m_player, &LessonPlayer::start);
    connect(m_panel, &LessonPanel::linkFollowed, &window, &Window::follow);
    connect(&window, &Window::closing, m_player, &LessonPlayer::end); // the next start has the layout before the lesson
    window.view().installEventFilter(this);
}

/// The user's own actions in the view tick the first steps, but not the pick at the program's
/// start.
bool LessonsFeature::eventFilter(QObject *watched, QEvent *event)
{
    if (m_player->lesson())
        return Feature::eventFilter(watched, event);
    const auto *mouse = event->type() == QEvent::MouseButtonPress || event->type() == QEvent::MouseButtonRelease
                            ? static_cast<const QMouseEvent *>(event)
                            : nullptr;
    if (event->type() == QEvent::KeyPress) {
        const auto key = viewKeyOf(*static_cast<const QKeyEvent *>(event));
        if (key && key->kind == ViewKey::Kind::Pick)
            tick(FirstSteps::Click);
        else if (key && key->kind == ViewKey::Kind::Turn)
            tick(FirstSteps::Drag);
    } else if (mouse && mouse->button() == Qt::LeftButton && event->type() == QEvent::MouseButtonPress) {
        m_pressed = mouse->position();
    } else if (mouse && mouse->button() == Qt::LeftButton) {
        const bool isDrag = (mouse->position() - m_pressed).manhattanLength() >= QApplication::startDragDistance();
        tick(isDrag ? FirstSteps::Drag : FirstSteps::Click);
    }
    return Feature::eventFilter(watched, event);
}

void LessonsFeature::tick(FirstSteps::Step step)
{
    if (!m_areFirstStepsShown)
        return;
    m_firstSteps->setDone(step, true);
    if (m_firstSteps->isAllDone())
        showFirstSteps(false);
    else
        keepFirstSteps();
}

void LessonsFeature::keepFirstSteps() const
{
    if (!m_window.remembers())
        return;
    QVariantList done;
    for (int step = 0; step < FirstSteps::StepCount; ++step)
        done << m_firstSteps->isDone(static_cast<FirstSteps::Step>(step));
    QSettings settings;
    settings.setValue(kStepsDone, done);
    settings.setValue(kAreStepsClosed, !m_areFirstStepsShown);
}

void LessonsFeature::addActions(MenuKind kind, QMenu &menu, QToolBar &bar)
{
    if (kind == MenuKind::File) {
        connectWorkspaces();
        menu.addSeparator();
        addAction(menu, tr("&Bundled Scene"), {}, tr("Show the scene that comes with the program"),
                  [this] { m_window.session().openBundledScene(); });
        m_menu = menu.addMenu(tr("&Lessons"));
        addLessonActions(*m_menu);
    } else if (kind == MenuKind::Help) {
        new HelpOpener([this](const QString &anchor) { showFormulas(anchor); },
                       [this](const QString &place) { showManual(place); }, this);
        addAction(menu, tr("&Formulas"), QKeySequence::HelpContents,
                  tr("All formulas with their sources, and the errors in the originals"), [this] { showFormulas({}); });
        addAction(menu, tr("First &Steps"), {}, tr("Three things to try"), [this] {
            m_window.workspaces().enter(Workspace::Click);
            showFirstSteps(true);
            for (int step = 0; m_firstSteps && step < FirstSteps::StepCount; ++step)
                m_firstSteps->setDone(static_cast<FirstSteps::Step>(step), false);
        })->setObjectName(QStringLiteral("firstSteps")); // for the preferences
        addToBar(bar);
    }
}

/// Puts the lessons at the right of the bar.
void LessonsFeature::addToBar(QToolBar &bar)
{
    auto *space = new QWidget;
    space->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
    bar.addWidget(space);
    auto *button = new QToolButton;
    button->setText(tr("Lessons"));
    button->setIcon(drawnIcon(Drawing::Lessons));
    button->setToolTip(tr("Lessons of a few minutes, with questions"));
    button->setMenu(m_menu);
    button->setPopupMode(QToolButton::InstantPopup);
    bar.addWidget(button);
}

void LessonsFeature::connectWorkspaces()
{
    Workspaces &workspaces = m_window.workspaces();
    connect(&workspaces, &Workspaces::titled, this, [this](Panel panel, bool hasTitleBar) {
        if (panel == Panel::Lesson)
            m_panel->setClosesItself(!hasTitleBar);
    });
    connect(&workspaces, &Workspaces::laidOut, m_stage, &LessonLayout::arrange);
    connect(&workspaces, &Workspaces::laidOut, this, &LessonsFeature::placeFirstSteps);
    connect(&workspaces, &Workspaces::panelsHidden, &m_stage->viewResizer(), &ViewResizer::wantAgain);
    connect(&workspaces, &Workspaces::closed, this, [this](Panel panel) {
        if (panel == Panel::Lesson)
            leaveOrStay();
    });
}

void LessonsFeature::addLessonActions(QMenu &menu)
{
    for (const Lesson &lesson : m_player->lessons()) {
        addAction(menu, lessonTitle(lesson.title), {}, lessonTitle(lesson.title),
                  [this, name = lesson.name] { m_player->start(name); });
    }
    menu.addSeparator();
    QAction *next = addAction(menu, tr("&Next Step"), Qt::ALT | Qt::Key_PageDown, tr("The next step of the lesson"),
                              [this] { m_player->next(); });
    QAction *back = addAction(menu, tr("&Previous Step"), Qt::ALT | Qt::Key_PageUp,
                              tr("The previous step of the lesson"), [this] { m_player->previous(); });
    QAction *leave = addAction(menu, tr("L&eave Lesson"), {}, tr("Leave the lesson and return to the scene before it"),
                               [this] { m_player->leave(); });
    const auto enable = [this, next, back, leave] {
        next->setEnabled(m_player->hasNext());
        back->setEnabled(m_player->hasPrevious());
        leave->setEnabled(m_player->lesson() != nullptr);
    };
    connect(m_player, &LessonPlayer::changed, &menu, enable);
    enable();
}

void LessonsFeature::leaveOrStay()
{
    if (m_player->leave())
        return;
    // After the dock, which is only about to close, has closed.
    QTimer::singleShot(0, this, [this] {
        if (m_player->lesson())
            m_window.workspaces().show(Panel::Lesson);
    });
}

void LessonsFeature::finish()
{
    if (m_player->leave() && m_window.document().objects().empty())
        m_window.session().openBundledScene();
}

bool LessonsFeature::follow(const lessons::Link &link)
{
    if (const auto *formulas = std::get_if<lessons::FormulasLink>(&link))
        showFormulas(QString::fromStdString(formulas->anchor));
    else if (const auto *clicked = std::get_if<lessons::ClickLink>(&link))
        click(clicked->point);
    else if (const auto *set = std::get_if<lessons::SetLink>(&link))
        change(set->change);
    else if (const auto *panel = std::get_if<lessons::PanelLink>(&link))
        m_stage->showPanel(panel->panel);
    else if (const auto *workspace = std::get_if<lessons::WorkspaceLink>(&link))
        m_stage->enter(workspace->workspace);
    else if (const auto *action = std::get_if<lessons::ActionLink>(&link))
        trigger(*action);
    else if (const auto *size = std::get_if<lessons::ViewSizeLink>(&link))
        m_stage->viewResizer().want({size->size.x, size->size.y}, true);
    // The others belong to another feature or to the lesson's panel.
    return true;
}

void LessonsFeature::click(const std::string &point)
{
    if (const auto pixel = m_player->clickedPixel(point))
        m_window.view().pickPixel(*pixel);
    else
        m_window.showMessage(tr("The point is outside the current view. Restore the step's view first."));
}

void LessonsFeature::change(const std::string &name)
{
    if (m_player->change(name) && m_player->step().changes.at(name).json().contains("point"))
        m_window.follow(lessons::GivenPointLink{});
}

void LessonsFeature::trigger(const lessons::ActionLink &link)
{
    auto *action = m_window.findChild<QAction *>(QString::fromStdString(link.name));
    if (!action)
        return;
    for (QObject *owner = action->parent(); owner; owner = owner->parent()) {
        const auto panel = lessons::panelOf(owner->objectName().toStdString());
        if (qobject_cast<QDockWidget *>(owner) && panel) { // the panel with the switch
            m_window.follow(lessons::PanelLink{*panel});
            m_window.workspaces().giveRoom(*panel, Panel::Observer);
        }
    }
    if (!action->isCheckable() || action->isChecked() != link.isOn)
        action->trigger();
}

void LessonsFeature::showManual(const QString &place)
{
    if (!m_manual)
        m_manual = new ManualWindow(&m_window);
    bringToFront(*m_manual);
    m_manual->openPlace(place);
}

void LessonsFeature::showFormulas(const QString &anchor)
{
    if (!m_formulas)
        m_formulas = new FormulasWindow(&m_window);
    bringToFront(*m_formulas);
    if (!anchor.isEmpty())
        m_formulas->showFormula(anchor);
}

void LessonsFeature::restore(const QSettings &settings)
{
    if (settings.value(kAreStepsClosed, false).toBool())
        return;
    const QVariantList done = settings.value(kStepsDone).toList();
    showFirstSteps(true);
    for (int step = 0; m_firstSteps && step < std::min<int>(done.size(), FirstSteps::StepCount); ++step)
        m_firstSteps->setDone(static_cast<FirstSteps::Step>(step), done[step].toBool());
    if (m_firstSteps)
        keepFirstSteps();
}

void LessonsFeature::showFirstSteps(bool isShown)
{
    const std::vector<Lesson> &lessons = m_player->lessons();
    if (isShown && !m_firstSteps && !lessons.empty()) { // the note offers the first one
        m_firstSteps = new FirstSteps(lessonTitle(lessons.front().title));
        m_window.frame().addNote(*m_firstSteps);
        connect(m_firstSteps, &FirstSteps::closeRequested, this, [this] { showFirstSteps(false); });
        connect(m_firstSteps, &FirstSteps::lessonRequested, this,
                [this] { m_player->start(m_player->lessons().front().name); });
        if (auto *map = m_window.findChild<QAction *>(QStringLiteral("error_map")))
            connect(map, &QAction::toggled, this, &LessonsFeature::placeFirstSteps);
    }
    if (!m_firstSteps)
        return;
    m_areFirstStepsShown = isShown;
    placeFirstSteps();
    keepFirstSteps();
}

void LessonsFeature::placeFirstSteps()
{
    if (!m_firstSteps)
        return;
    // Not in a lesson either: a lesson is one of them, and the view can be smaller without the
    // note. An error map needs the corner for its choices.
    const auto *map = m_window.findChild<QAction *>(QStringLiteral("error_map"));
    m_firstSteps->setVisible(m_areFirstStepsShown && m_window.workspaces().current() == Workspace::Click
                             && !m_player->lesson() && !(map && map->isChecked()));
    m_firstSteps->raise();
}

Feature *makeLessonsFeature(Window &window)
{
    return new LessonsFeature(window);
}

} // namespace unprojector::gui

#include "lessons_feature.moc"
