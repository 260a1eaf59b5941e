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

/// Which step of which lesson is shown, without a widget: opens the steps' scenes, checks and counts the answers to what they ask,
/// and gives back at the end what was shown before.
class LessonPlayer : public QObject {
    Q_OBJECT
public:
    /// @param document, session  outlive the player
    LessonPlayer(SceneDocument &document, Session &session, QObject *parent = nullptr);

    /// All lessons in their order, in the program's language; read when they are first asked for. One that cannot be read is
    /// told by `failed` and left out.
    const std::vector<Lesson> &lessons();

    /// Null while there is none.
    const Lesson *lesson() const { return m_lesson; }
    /// Of the step in the lesson.
    std::size_t index() const { return m_index; }
    /// @pre lesson()
    const lessons::Step &step() const { return m_lesson->steps[m_index]; }

    // Nothing is asked about what was done in a step's scene, unless that was saved under a name: the steps tell to do it. Nor
    // about the scene that was shown before, which comes back. Where the user stays, nothing has changed, and false is
    // returned.

    /// Starts a lesson at its first step, without any answers.
    bool start(const std::string &name);
    /// Starts a lesson by its name, and goes to a step behind a colon, from 1 on: "weng:3".
    /// @return an error of the option --lesson where there is no such step; else empty
    QString startAt(const QString &nameAndStep);
    /// @pre lesson(), place < its number of steps
    bool goTo(std::size_t index);
    bool hasNext() const { return m_lesson && m_index + 1 < m_lesson->steps.size(); }
    bool hasPrevious() const { return m_lesson && m_index > 0; }
    /// @pre hasNext()
    bool next() { return goTo(m_index + 1); }
    /// @pre hasPrevious()
    bool previous() { return goTo(m_index - 1); }
    /// Ends the lesson and shows again what was shown before it, its unsaved changes included.
    bool leave();
    /// Ends the lesson, if there is one, and leaves what is shown.
    void end();

    /// Whether camera, projection, viewport and objects are as the step has them.
    bool isAsTheStep() const;
    /// Shows the step's scene as it was at first. `clickWanted` follows where a point of it had been clicked by a link.
    bool restart();
    /// Whether the numbers of the step hold in the view as large as it is.
    bool hasViewOfStep() const;

    /// What the step asks for, and its answer. @pre it asks
    /// @return nothing where it cannot be computed, which is a mistake of ours
    std::optional<lessons::Asked> asked() const;
    /// Checks an answer; the right one is found then. @pre the step asks
    /// @return whether it is right
    bool check(double given);
    /// Whether the answer was found or shown, since the lesson began.
    bool isRevealed() const { return m_given.contains(m_index); }
    /// Shows the answer. @pre the step asks
    void reveal();
    /// The panels that show an answer that is still to be given. @pre lesson()
    std::vector<lessons::CoveredPanel> coveredPanels() const;

    /// How many questions the lesson asks, and how they were answered.
    struct Tally {
        int questions = 0;
        int atOnce = 0; ///< right with the first answer
        int later = 0;  ///< right after a wrong answer
        int shown = 0;
    };
    /// @pre lesson()
    Tally tally() const;
    /// The lesson after this one; null after the last. @pre lesson()
    const Lesson *following() const;

    /// Where to click for a point that the step names; nothing where it is not in the picture as it is now.
    std::optional<geometry::DevicePixel> pixelOf(const std::string &point) const;
    /// The same for somebody who clicks there: the click comes back where the picture is put back.
    std::optional<geometry::DevicePixel> clickedPixel(const std::string &point);

    /// Does what a link set:NAME of the step says, undoably.
    /// @return false where it cannot, which `failed` tells
    bool change(const std::string &name);

signals:
    /// A lesson is about to begin where there was none: what is shown is still what was shown before.
    void aboutToBegin();
    /// Another step, another lesson, or none.
    void changed();
    void revealed();
    /// The point of the step that was clicked before the picture was put back.
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
    std::map<std::size_t, Answered> m_given; ///< by the indexes of the steps
    std::set<std::size_t> m_tried;           ///< the steps that were answered wrongly
    std::optional<scene::Scene> m_shown;     ///< the step's, as it was opened
    std::string m_clicked;                   ///< by a link, in this scene, last; empty: nothing
};

} // namespace unprojector::gui
