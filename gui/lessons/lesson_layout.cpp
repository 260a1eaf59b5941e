#include "gui/lessons/lesson_layout.h"

#include "gui/lessons/answer_text.h"
#include "gui/lessons/lesson_player.h"
#include "gui/view/scene_view.h"
#include "gui/window/view_frame.h"

#include <QDockWidget>
#include <QStatusBar>
#include <QTimer>

#include <map>

namespace unprojector::gui {

LessonLayout::LessonLayout(Window &window, LessonPlayer &player)
    : QObject(&player), m_window(window), m_player(player), m_viewResizer(window, this)
{
}

void LessonLayout::remember()
{
    m_before = m_window.state();
    m_rooms.clear();
    for (SteadyLabel *label : m_window.findChildren<SteadyLabel *>())
        m_rooms.emplace_back(label, label->room());
}

void LessonLayout::end()
{
    m_lesson.clear();
    coverAnswers();
    m_window.showStep(nullptr);
    m_viewResizer.want({}, false);
    m_viewResizer.shrinkBack();
    m_covers.reset();
    m_workspace.reset();
    m_withRoom.clear();
    QDockWidget &lesson = m_window.workspaces().dock(Panel::Lesson);
    if (lesson.isAncestorOf(m_window.focusWidget()))
        m_window.view().setFocus(); // Qt would go on to the next widget as by Tab, which shows the crosshair
    lesson.hide();
    m_window.restore(*m_before);
    // The lesson's texts may have taken more room.
    for (const auto &[label, room] : m_rooms) {
        if (label)
            label->setRoom(room);
    }
}

void LessonLayout::showStep()
{
    const Lesson *lesson = m_player.lesson();
    const std::string name = lesson ? lesson->name : std::string();
    const bool isAnother = name.empty() || name != m_lesson;
    if (isAnother) {
        // The former lesson ends first, so that its layout is not kept for the next one.
        if (!m_lesson.empty())
            end();
        m_lesson = name;
    }
    if (!lesson) {
        m_before.reset();
        return;
    }
    Workspaces &workspaces = m_window.workspaces();
    if (isAnother)
        workspaces.hidePanels(false); // a lesson refers to them
    const lessons::Step &step = m_player.step();
    if (step.workspace != m_workspace) {
        m_workspace = step.workspace;
        if (m_workspace)
            enter(*m_workspace);
    }
    coverAnswers();
    showPanels();
    m_window.showStep(&step);
    workspaces.show(Panel::Lesson);
    giveRoom(false);
    m_viewResizer.want(step.view ? QSize(step.view->x, step.view->y) : QSize(), false);
}

void LessonLayout::enter(Workspace workspace)
{
    if (workspace != m_window.workspaces().current())
        m_window.workspaces().enter(workspace);
}

void LessonLayout::arrange()
{
    m_window.workspaces().dock(Panel::Lesson).setVisible(!m_lesson.empty());
    giveRoom(false);
}

void LessonLayout::showPanels()
{
    for (const Panel panel : m_player.step().panels)
        m_window.follow(lessons::PanelLink{panel});
}

void LessonLayout::showAnswer()
{
    coverAnswers();
    showPanels();
    m_window.workspaces().show(Panel::Lesson); // it explains the situation, if the panels are tabs of one column
}

void LessonLayout::coverAnswers()
{
    std::map<Panel, QString> texts;
    if (!m_lesson.empty()) {
        for (const lessons::CoveredPanel &one : m_player.coveredPanels())
            texts[one.panel] = coverText(one, m_player.index());
    }
    if (!m_covers)
        m_covers.emplace(m_window.workspaces());
    m_covers->set(texts);
    emit m_window.coordinatesHidden(texts.contains(Panel::Comparison));
}

void LessonLayout::showPanel(Panel panel)
{
    Workspaces &workspaces = m_window.workspaces();
    const bool wasHidden = workspaces.dock(panel).isHidden();
    workspaces.show(panel);
    if (wasHidden)
        giveRoom(true);
}

void LessonLayout::giveRoom(bool isAgain)
{
    if (m_lesson.empty() || (!m_withRoom.insert(m_window.workspaces().current()).second && !isAgain))
        return;
    // After the layout.
    QTimer::singleShot(0, this, [this] {
        constexpr double kShare = 0.6; // the panel above is only looked up, this one is read
        QDockWidget &dock = m_window.workspaces().dock(Panel::Lesson);
        const int column = m_window.statusBar()->geometry().top() - m_window.frame().geometry().top();
        if (m_window.dockWidgetArea(&dock) == Qt::LeftDockWidgetArea && !dock.isFloating())
            m_window.resizeDocks({&dock}, {static_cast<int>(kShare * column)}, Qt::Vertical);
    });
}

} // namespace unprojector::gui
