#pragma once

#include "gui/lessons/view_resizer.h"
#include "gui/window/window.h"

#include <QObject>

#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace unprojector::gui {

class LessonPlayer;

/// What a lesson shows around the view: its panel, the workspace and the panels of its steps, the size of the view. Panels that show
/// the answer to a question are closed until it is given. After the lesson all is as it was before.
class LessonLayout : public QObject {
public:
    /// @param player  owns the layout
    LessonLayout(Window &window, LessonPlayer &player);

    ViewResizer &viewResizer() { return m_viewResizer; }
    /// Remembers what is around the view, to give it back after the lesson that is about to begin.
    void remember() { m_before = m_window.state(); }
    /// Shows the workspace, the panels and the view size of the player's step.
    void showStep();
    /// Shows the panels of the step that do not show its answer.
    void showPanels();
    void showPanel(Panel panel);
    /// Goes to a workspace, if another one is entered.
    void enter(Workspace workspace);
    /// The panels of a workspace that was laid out: the lesson's goes along, those with the answer stay closed.
    void arrange();

private:
    void end();
    /// The panels with the answer to the question of the step, until it is given.
    std::vector<Panel> panelsWithAnswer() const;
    /// Closes panels with the answer in the current workspace, and shows those again that were closed there and show no answer any
    /// more.
    void hideAnswers();
    /// Gives the lesson's panel the larger part of the side that it shares with other panels; the user may change that.
    /// @param isAgain  also where it was given before: another panel has come
    void giveRoom(bool isAgain);

    Window &m_window;
    LessonPlayer &m_player;
    ViewResizer m_viewResizer;
    std::string m_lesson;                              ///< the name of the one that is shown; empty: none
    std::optional<Window::State> m_before;             ///< around the view, before the lesson
    std::optional<Workspace> m_workspace;              ///< where the lesson wants to be
    std::set<Workspace> m_withRoom;                    ///< where the lesson's panel was given room
    std::vector<std::pair<Workspace, Panel>> m_closed; ///< panels that were closed because they have the answer
};

} // namespace unprojector::gui
