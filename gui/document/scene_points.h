#pragma once

#include "core/landmarks/landmark.h"
#include "gui/document/change_notifier.h"

#include <QObject>
#include <QString>

#include <cstddef>
#include <optional>
#include <vector>

namespace unprojector::gui {
using namespace geometry;

class SceneDocument;

/// The points that are placed in a document's scene: which of them are selected, and what is done to single ones. Each edit is
/// one step of undo, by the name of the point. Places are places in SceneDocument::landmarks().
///
/// Points go with the object that they name, in the same step in which it is moved, renamed or removed: see withObjects. Where
/// they are in the world is therefore always what `world` says.
class ScenePoints : public QObject {
    Q_OBJECT
public:
    using Landmark = landmarks::Landmark;

    /// @param changes  reports what is selected
    ScenePoints(SceneDocument &document, ChangeNotifier &changes);

    const std::vector<Landmark> &all() const;

    // What is selected. Not undoable; it goes with the points, whatever is done to their list. Change::LandmarkSelection tells
    // of it.

    /// Rising.
    const std::vector<std::size_t> &selection() const { return m_selection; }
    bool isSelected(std::size_t place) const;
    /// The one of them that keys move; nothing where none is selected.
    std::optional<std::size_t> current() const { return m_current; }
    /// @param places   in any order; those that are no point's are left out
    /// @param current  one of them; nothing: the first
    void select(std::vector<std::size_t> places, std::optional<std::size_t> current = std::nullopt);
    void selectOnly(std::size_t place) { select({place}, place); }
    /// Selects one besides, as the current one, or selects it no longer.
    void toggle(std::size_t place);
    void clearSelection() { select({}); }
    /// The missing point that is placed next; nothing: what is placed comes new to the end.
    std::optional<std::size_t> waiting() const { return m_waiting; }
    /// @param place  of a missing point, else nothing waits. A missing point that becomes the current one waits by itself
    void setWaiting(std::optional<std::size_t> place);
    /// Lets the next missing point wait that comes after this one, from the start again behind the last; none: the first missing
    /// one.
    void waitForNext(std::optional<std::size_t> after);

    // Edits. @return the errors of SceneDocument::edit…, of which there is none that points can cause

    /// Gives the point that waits its place, and the next missing one waits; without one that waits, it is another point at
    /// the end, with a name of its own where it has none. It is selected then.
    /// @param placed  of a point that waits only its place counts
    Check place(Landmark placed);
    /// Takes the place of another: where it is and what holds it, its object and how far it can be off.
    /// @param mergeKey  moves with the same key, one right after the other, are one step
    Check move(std::size_t place, const Landmark &to, const QString &mergeKey = {});
    /// What of one point another one takes, see move.
    struct Move {
        std::size_t place = 0;
        Landmark to;
    };
    /// All in one step; none of none.
    Check moveAll(const std::vector<Move> &moves, const QString &mergeKey = {});
    /// To coordinates, held by nothing, and as exact as they are.
    Check moveTo(std::size_t place, const WorldPoint &to, const QString &mergeKey = {});
    Check rename(std::size_t place, const QString &name);
    Check setNote(std::size_t place, const QString &note);
    /// @param color  nothing: the usual one
    Check setColor(const std::vector<std::size_t> &places, const std::optional<glm::u8vec3> &color);
    Check setHidden(const std::vector<std::size_t> &places, bool isHidden);
    Check remove(const std::vector<std::size_t> &places);
    /// They stay in the list without a place.
    Check setMissing(const std::vector<std::size_t> &places);
    Check reorder(std::size_t from, std::size_t to);
    /// @param order  of the points as they are, each once
    Check arrange(const std::vector<std::size_t> &order);

    /// Its name, as texts have it; "point 3" for one without.
    static QString shownNameOf(const std::vector<Landmark> &points, std::size_t place);

    /// The selection follows a change of the list of landmarks.
    /// @return the changes of the selection
    Changes follow(const std::vector<Landmark> &before, const std::vector<Landmark> &after);

private:
    /// A change of single points.
    template <class Change>
    Check edit(const std::vector<std::size_t> &places, const QString &one, const QString &several, const Change &change,
               const QString &mergeKey = {});
    /// @return whether it is another selection
    bool take(std::vector<std::size_t> places, std::optional<std::size_t> current, std::optional<std::size_t> waiting);
    std::string freeName() const;

    SceneDocument &m_document;
    ChangeNotifier &m_changes;
    std::vector<std::size_t> m_selection;
    std::optional<std::size_t> m_current;
    std::optional<std::size_t> m_waiting;
};

} // namespace unprojector::gui
