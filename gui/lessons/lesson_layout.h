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

/// The layout around the view in a lesson: its panel, the workspace and the panels of its steps,
/// the size of the view. Panels that show the answer to a question are covered until it is given.
/// After the lesson the former layout is restored.
class LessonLayout : public QObject {
public:
    /// @param player  owns the layout
    LessonLayout(Window &window, LessonPlayer &player);

    ViewResizer &viewResizer() { return m_viewResizer; }
    /// Saves the layout before a lesson begins, to restore it afterwards.
    void remember();
    /// Shows the workspace, the panels and the view size of the player's step.
    void showStep();
    /// Opens the panels that showed the answer that was just given.
    void showAnswer();
    void showPanel(Panel panel);
    /// Switches to a workspace, unless it is the current one.
    void enter(Workspace workspace);
    /// Shows the lesson's panel, only during a lesson, after a workspace was laid out.
    void arrange();

private:
    void end();
    void showPanels();
    /// Covers the panels that show an answer, and opens the others; meanwhile the status bar hides
    /// coordinates.
    void coverAnswers();
    /// Gives the lesson's panel the larger part of the side that it shares with other panels; the
    /// user may change that.
    /// @param isAgain  also if it was given room there before: another panel was added
    void giveRoom(bool isAgain);

    Window &m_window;
    LessonPlayer &m_player;
    ViewResizer m_viewResizer;
    std::string m_lesson;                  ///< the name of the present one; empty: none
    std::optional<Window::State> m_before; ///< layout around the view, before the lesson
    std::vector<std::pair<QPointer<SteadyLabel>, SteadyLabel::Room>> m_rooms; ///< rooms of texts, before the lesson
    /// the workspace that the lesson asks for
    std::optional<Workspace> m_workspace;
    std::set<Workspace> m_withRoom;      ///< workspaces in which the lesson's panel was given room
    std::optional<PanelCovers> m_covers; ///< created when a lesson begins
};

} // namespace unprojector::gui
