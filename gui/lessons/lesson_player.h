#pragma once

#include "core/lessons/covered_panels.h"
#include "core/lessons/lesson.h"
#include "core/lessons/slips.h"
#include "gui/document/session.h"

#include <QObject>

#include <cstddef>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace unprojector::gui {
using lessons::Lesson;

/// The present step of a lesson, without a widget: opens the steps' scenes, checks and counts the
/// answers, and restores the former scene at the end.
class LessonPlayer : public QObject {
    Q_OBJECT
public:
    /// @param document, session  outlive the player
    LessonPlayer(SceneDocument &document, Session &session, QObject *parent = nullptr);

    /// All lessons in order, in the program's language; read on demand. Leaves out a lesson that
    /// cannot be read, and emits `failed`.
    const std::vector<Lesson> &lessons();

    /// The present lesson; null if there is none.
    const Lesson *lesson() const { return m_lesson; }
    /// The index of the step in the lesson.
    std::size_t index() const { return m_index; }
    /// @pre lesson()
    const lessons::Step &step() const { return m_lesson->steps[m_index]; }

    // Changes in a step's scene are dropped without a question, unless it was saved under a name:
    // the steps ask for these changes. The scene before the lesson needs no question either,
    // because it is restored. If the user cancels, nothing has changed, and the functions return
    // false.

    /// Starts a lesson at its first step, without any answers.
    bool start(const std::string &name);
    /// Starts a lesson by its name, optionally with a step after a colon, from 1: "weng:3".
    /// @return an error of the option --lesson if there is no such step; else empty
    QString startAt(const QString &nameAndStep);
    /// @pre lesson(), index < its number of steps
    bool goTo(std::size_t index);
    bool hasNext() const { return m_lesson && m_index + 1 < m_lesson->steps.size(); }
    bool hasPrevious() const { return m_lesson && m_index > 0; }
    /// @pre hasNext()
    bool next() { return goTo(m_index + 1); }
    /// @pre hasPrevious()
    bool previous() { return goTo(m_index - 1); }
    /// Ends the lesson and restores the scene before it, with its unsaved changes.
    bool leave();
    /// Ends the lesson, if there is one, and keeps the present scene.
    void end();

    /// Returns whether camera, projection, viewport and objects equal the step's.
    bool isAsTheStep() const;
    /// Resets the step's scene. Emits `clickWanted` if a link had clicked a point of it.
    bool restart();
    /// Returns whether the numbers of the step are valid for the view's size.
    bool hasViewOfStep() const;

    /// The step's question and its answer. @pre it has one
    /// @return nothing if it cannot be computed, which is a bug
    std::optional<lessons::Asked> asked() const;
    /// Checks an answer; a right one counts as found. @pre the step asks
    /// @return whether it is right
    bool check(double given);
    /// Returns whether the answer was found or shown since the lesson began.
    bool isRevealed() const { return m_given.contains(m_index); }
    /// Shows the answer. @pre the step asks
    void reveal();
    /// The panels that show an answer that is not given yet. @pre lesson()
    std::vector<lessons::CoveredPanel> coveredPanels() const;

    /// The number of questions in the lesson, and how they were answered.
    struct Tally {
        int questions = 0;
        int atOnce = 0; ///< right at the first attempt
        int later = 0;  ///< right after a wrong answer
        int shown = 0;
    };
    /// @pre lesson()
    Tally tally() const;
    /// The next lesson; null after the last. @pre lesson()
    const Lesson *following() const;

    /// The pixel of a point that the step names; nothing if it is not in the present view.
    std::optional<geometry::DevicePixel> pixelOf(const std::string &point) const;
    /// The same for a click: a reset of the scene repeats it.
    std::optional<geometry::DevicePixel> clickedPixel(const std::string &point);

    /// Applies the change of a link set:NAME of the step, undoably.
    /// @return false if it cannot, after `failed`
    bool change(const std::string &name);

signals:
    /// Emitted before a lesson begins: the former scene is still shown.
    void aboutToBegin();
    /// Emitted when another step or lesson is shown, or none.
    void changed();
    void revealed();
    /// Emitted to repeat the click on a point of the step after a reset.
    void clickWanted(const std::string &point);
    void failed(const QString &reason);

private:
    enum class Answered { AtOnce, Later, Shown };

    /// @param isNew  the lesson begins, without any answers
    bool show(const Lesson &lesson, std::size_t index, bool isNew);
    void give(Answered how);
    bool open(const Lesson &lesson, const lessons::Step &step);

    SceneDocument &m_document;
    Session &m_session;
    std::vector<Lesson> m_lessons;
    bool m_areRead = false;
    const Lesson *m_lesson = nullptr; ///< one of m_lessons
    std::size_t m_index = 0;
    std::map<std::size_t, Answered> m_given; ///< by the indices of the steps
    std::set<std::size_t> m_tried;           ///< the steps with a wrong answer
    std::optional<scene::Scene> m_shown;     ///< the step's scene as opened
    std::string m_clicked;                   ///< the last point clicked by a link in this scene; empty: none
};

} // namespace unprojector::gui
