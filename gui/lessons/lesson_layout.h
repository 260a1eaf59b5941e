#pragma once

#include "gui/lessons/panel_covers.h"
#include "gui/lessons/view_resizer.h"
#include "gui/widgets/steady_label.h"
#include "gui/window/window.h"

#include <QObject>
#include <QPointer>

#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace unprojector::gui {

class LessonPlayer;

/// What a lesson shows around the view: its panel, the workspace and the panels of its steps, the size of the view. Panels that show
/// the answer to a question are covered until it is given. After the lesson all is as it was before.
class LessonLayout : public QObject {
public:
    /// @param player  owns the layout
    LessonLayout(Window &window, LessonPlayer &player);

    ViewResizer &viewResizer() { return m_viewResizer; }
    /// Remembers what is around the view, to give it back after the lesson that is about to begin.
    void remember();
    /// Shows the workspace, the panels and the view size of the player's step.
    void showStep();
    /// Opens the panels that showed the answer that was just given.
    void showAnswer();
    void showPanel(Panel panel);
    /// Goes to a workspace, if another one is entered.
    void enter(Workspace workspace);
    /// The panels of a workspace that was laid out: the lesson's goes along.
    void arrange();

private:
    void end();
    void showPanels();
    /// Covers the panels that show an answer, and opens the others; the status bar is silent about coordinates as long.
    void coverAnswers();
    /// Gives the lesson's panel the larger part of the side that it shares with other panels; the user may change that.
    /// @param isAgain  also where it was given before: another panel has come
    void giveRoom(bool isAgain);

    Window &m_window;
    LessonPlayer &m_player;
    ViewResizer m_viewResizer;
    std::string m_lesson;                  ///< the name of the one that is shown; empty: none
    std::optional<Window::State> m_before; ///< around the view, before the lesson
    std::vector<std::pair<QPointer<SteadyLabel>, SteadyLabel::Room>> m_rooms; ///< the same, of texts
    std::optional<Workspace> m_workspace;                                     ///< where the lesson wants to be
    std::set<Workspace> m_withRoom;      ///< where the lesson's panel was given room
    std::optional<PanelCovers> m_covers; ///< made when a lesson begins
};

} // namespace unprojector::gui
