#pragma once

#include "core/landmarks/landmark.h"
#include "gui/document/change_notifier.h"

#include <QObject>
#include <QString>

#include <cstddef>
#include <optional>
#include <vector>

namespace unprojector::gui {

class SceneDocument;

/// The landmarks of a document's scene: the selection, and edits of single landmarks. Each edit is one step of undo, named
/// after the landmark. An index is one into SceneDocument::landmarks().
///
/// A landmark goes with the object that it names, in the same step in which that is moved, renamed or removed: see
/// withObjects. Its `world` is therefore always right.
class SceneLandmarks : public QObject {
    Q_OBJECT
public:
    using Landmark = landmarks::Landmark;

    /// @param changes  reports what is selected
    SceneLandmarks(SceneDocument &document, ChangeNotifier &changes);

    const std::vector<Landmark> &all() const;

    // What is selected. Not undoable; it goes with the points, whatever is done to their list. Change::LandmarkSelection tells
    // of it.

    /// Rising.
    const std::vector<std::size_t> &selection() const { return m_selection; }
    bool isSelected(std::size_t index) const;
    /// The one of them that keys move; nothing where none is selected.
    std::optional<std::size_t> current() const { return m_current; }
    /// @param indices  in any order; those that are no point's are left out
    /// @param current  one of them; nothing: the first
    void select(std::vector<std::size_t> indices, std::optional<std::size_t> current = std::nullopt);
    void selectOnly(std::size_t index) { select({index}, index); }
    /// Selects one besides, as the current one, or selects it no longer.
    void toggle(std::size_t index);
    void clearSelection() { select({}); }
    /// The missing point that is placed next; nothing: what is placed comes new to the end.
    std::optional<std::size_t> nextUnplaced() const { return m_nextUnplaced; }
    /// @param index  of a missing point, else nothing waits. A missing point that becomes the current one waits by itself
    void setNextUnplaced(std::optional<std::size_t> index);
    /// Lets the next missing point wait that comes after this one, from the start again behind the last; none: the first missing
    /// one.
    void waitForNext(std::optional<std::size_t> after);

    // Edits. @return the errors of SceneDocument::edit…, of which there is none that points can cause

    /// Gives the point that waits its place, and the next missing one waits; without one that waits, it is another point at
    /// the end, with a name of its own where it has none. It is selected then.
    /// @param placed  of a point that waits only its place counts
    geometry::Check place(Landmark placed);
    /// Takes the place of another: where it is and what holds it, its object and how far it can be off.
    /// @param mergeKey  moves with the same key, one right after the other, are one step
    geometry::Check move(std::size_t index, const Landmark &to, const QString &mergeKey = {});
    /// What of one point another one takes, see move.
    struct Move {
        std::size_t index = 0;
        Landmark to;
    };
    /// All in one step; none of none.
    geometry::Check moveAll(const std::vector<Move> &moves, const QString &mergeKey = {});
    /// To coordinates, held by nothing, and as exact as they are.
    geometry::Check moveTo(std::size_t index, const geometry::WorldPoint &to, const QString &mergeKey = {});
    geometry::Check rename(std::size_t index, const QString &name);
    geometry::Check setNote(std::size_t index, const QString &note);
    /// @param color  nothing: the usual one
    geometry::Check setColor(const std::vector<std::size_t> &indices, const std::optional<glm::u8vec3> &color);
    geometry::Check setHidden(const std::vector<std::size_t> &indices, bool isHidden);
    geometry::Check remove(const std::vector<std::size_t> &indices);
    /// They stay in the list without a place.
    geometry::Check setMissing(const std::vector<std::size_t> &indices);
    geometry::Check reorder(std::size_t from, std::size_t to);
    /// @param order  of the points as they are, each once
    geometry::Check arrange(const std::vector<std::size_t> &order);

    /// Its name, as texts have it; "point 3" for one without.
    static QString shownNameOf(const std::vector<Landmark> &landmarks, std::size_t index);

    /// The selection follows a change of the list of landmarks.
    /// @return the changes of the selection
    Changes follow(const std::vector<Landmark> &before, const std::vector<Landmark> &after);

private:
    /// A change of single points.
    template <class Change>
    geometry::Check edit(const std::vector<std::size_t> &indices, const QString &one, const QString &several,
                         const Change &change, const QString &mergeKey = {});
    /// @return whether it is another selection
    bool take(std::vector<std::size_t> indices, std::optional<std::size_t> current,
              std::optional<std::size_t> nextUnplaced);
    std::string freeName() const;

    SceneDocument &m_document;
    ChangeNotifier &m_changes;
    std::vector<std::size_t> m_selection;
    std::optional<std::size_t> m_current;
    std::optional<std::size_t> m_nextUnplaced;
};

} // namespace unprojector::gui
