#include "gui/lessons/lesson_layout.h"

#include "gui/lessons/lesson_player.h"
#include "gui/window/view_frame.h"

#include <QDockWidget>
#include <QStatusBar>
#include <QTimer>

#include <algorithm>
#include <iterator>
#include <utility>

namespace unprojector::gui {

LessonLayout::LessonLayout(Window &window, LessonPlayer &player)
    : QObject(&player), m_window(window), m_player(player), m_viewResizer(window, this)
{
}

void LessonLayout::end()
{
    m_lesson.clear();
    m_window.showStep(nullptr);
    m_viewResizer.want({}, false);
    m_viewResizer.shrinkBack();
    m_closed.clear();
    m_workspace.reset();
    m_withRoom.clear();
    m_window.workspaces().dock(Panel::Lesson).hide();
    m_window.restore(*m_before);
}

void LessonLayout::showStep()
{
    const Lesson *lesson = m_player.lesson();
    const std::string name = lesson ? lesson->name : std::string();
    const bool isAnother = name.empty() || name != m_lesson;
    if (isAnother) {
        // A lesson begins as if none had been before it.
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
        workspaces.hidePanels(false); // a lesson speaks of them
    const lessons::Step &step = m_player.step();
    if (step.workspace != m_workspace) {
        m_workspace = step.workspace;
        if (m_workspace)
            enter(*m_workspace);
    }
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
    hideAnswers();
    giveRoom(false);
}

std::vector<Panel> LessonLayout::panelsWithAnswer() const
{
    if (m_lesson.empty() || m_player.isRevealed() || !m_player.step().question)
        return {};
    return m_player.step().question->hides;
}

void LessonLayout::showPanels()
{
    hideAnswers();
    const std::vector<Panel> hidden = panelsWithAnswer();
    for (const Panel panel : m_player.step().panels) { // in front of those that come back
        if (std::count(hidden.begin(), hidden.end(), panel) == 0)
            m_window.follow(lessons::PanelLink{panel});
    }
}

void LessonLayout::hideAnswers()
{
    Workspaces &workspaces = m_window.workspaces();
    const std::vector<Panel> hidden = panelsWithAnswer();
    std::erase_if(m_closed, [&](const auto &one) {
        const auto &[workspace, panel] = one;
        const bool comesBack =
            std::count(hidden.begin(), hidden.end(), panel) == 0 && workspace == workspaces.current();
        if (comesBack)
            workspaces.show(panel);
        return comesBack;
    });
    std::vector<Panel> seen;
    std::copy_if(hidden.begin(), hidden.end(), std::back_inserter(seen),
                 [&](Panel panel) { return !workspaces.dock(panel).isHidden(); });
    // One that is in front of others comes back last, and so in front again.
    std::stable_partition(seen.begin(), seen.end(),
                          [&](Panel panel) { return !workspaces.isFront(workspaces.dock(panel)); });
    for (const Panel panel : seen) {
        workspaces.dock(panel).hide();
        m_closed.emplace_back(workspaces.current(), panel);
    }
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
    // Once all stands where it will.
    QTimer::singleShot(0, this, [this] {
        constexpr double kShare = 0.6; // what stands above it is looked up, this is read
        QDockWidget &dock = m_window.workspaces().dock(Panel::Lesson);
        const int column = m_window.statusBar()->geometry().top() - m_window.frame().geometry().top();
        if (m_window.dockWidgetArea(&dock) == Qt::LeftDockWidgetArea && !dock.isFloating())
            m_window.resizeDocks({&dock}, {static_cast<int>(kShare * column)}, Qt::Vertical);
    });
}

} // namespace unprojector::gui
