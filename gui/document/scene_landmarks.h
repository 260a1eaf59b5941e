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

/// The landmarks of a document's scene: the selection, and edits of single landmarks. Each edit is
/// one step of undo, named after the landmark. An index refers to SceneDocument::landmarks().
///
/// When an object is moved, renamed or removed, its landmarks follow in the same step
/// (withObjects). A landmark's `world` is therefore always right.
class SceneLandmarks : public QObject {
    Q_OBJECT
public:
    using Landmark = landmarks::Landmark;

    /// @param changes  receives the changes of the selection
    SceneLandmarks(SceneDocument &document, ChangeNotifier &changes);

    const std::vector<Landmark> &all() const;

    // The selection. Not undoable; it follows every change of the list. Change::LandmarkSelection
    // reports it.

    /// The selected indices, ascending.
    const std::vector<std::size_t> &selection() const { return m_selection; }
    /// The same indices, in the order in which the user selected them.
    const std::vector<std::size_t> &selectionInOrder() const { return m_order; }
    bool isSelected(std::size_t index) const;
    /// The selected landmark that keys move; nothing if none is selected.
    std::optional<std::size_t> current() const { return m_current; }
    /// @param indices  in any order; invalid ones are ignored
    /// @param current  one of them; nothing: the first
    void select(std::vector<std::size_t> indices, std::optional<std::size_t> current = std::nullopt);
    void selectOnly(std::size_t index) { select({index}, index); }
    /// Selects landmarks in this order. The next one to place stays the same.
    /// @param order  without repeats; invalid indices are ignored
    void selectInOrder(std::vector<std::size_t> order);
    /// Adds a landmark to the selection as the current one, or removes it from the selection.
    void toggle(std::size_t index);
    void clearSelection() { select({}); }
    /// The landmark that the next placement places; nothing: it appends a new one. While a landmark
    /// is to be placed, there is one. After an edit, also an undone one, it is the one that the edit
    /// made wait again, else the following one.
    std::optional<std::size_t> nextUnplaced() const { return m_nextUnplaced; }
    /// @param index  of a landmark without a position; else the first to place is next. Such a
    /// landmark that becomes the current one is next automatically, also if it is marked as missing
    void setNextUnplaced(std::optional<std::size_t> index);
    /// Sets the next landmark to place after this one as the next, and wraps around at the end;
    /// none: the first one. Skipped landmarks come after all others.
    void waitForNext(std::optional<std::size_t> after);

    // Edits. @return the errors of SceneDocument::edit…; landmarks cannot cause any

    /// Places the next landmark; without one, appends a landmark, with a name of its own if it has
    /// none. Selects it.
    /// @param placed  for a landmark of the list only its position counts
    geometry::Check place(Landmark placed);
    /// Moves a landmark: takes over position, anchor, object and uncertainty of `to`.
    /// @param mergeKey  consecutive moves with the same key are one step
    geometry::Check move(std::size_t index, const Landmark &to, const QString &mergeKey = {});
    /// A move of one landmark, see move.
    struct Move {
        std::size_t index = 0;
        Landmark to;
    };
    /// Moves all in one step; does nothing for an empty list.
    geometry::Check moveAll(const std::vector<Move> &moves, const QString &mergeKey = {});
    /// Moves a landmark to free coordinates, which count as exact.
    geometry::Check moveTo(std::size_t index, const geometry::WorldPoint &to, const QString &mergeKey = {});
    geometry::Check rename(std::size_t index, const QString &name);
    geometry::Check setNote(std::size_t index, const QString &note);
    /// @param color  nothing: the default
    geometry::Check setColor(const std::vector<std::size_t> &indices, const std::optional<glm::u8vec3> &color);
    geometry::Check setHidden(const std::vector<std::size_t> &indices, bool isHidden);
    geometry::Check remove(const std::vector<std::size_t> &indices);
    /// Marks landmarks as missing on this specimen, which removes their positions, or removes these
    /// marks.
    geometry::Check setMissing(const std::vector<std::size_t> &indices, bool isMissing = true);
    /// Passes over a landmark to place: it comes again after the others. A landmark that is skipped
    /// already, or marked as missing, does not change.
    geometry::Check skip(std::size_t index);
    /// Removes positions, and marks as missing or skipped: all are to be placed.
    geometry::Check placeAgain(const std::vector<std::size_t> &indices);
    geometry::Check reorder(std::size_t from, std::size_t to);
    /// @param order  a permutation of the indices
    geometry::Check arrange(const std::vector<std::size_t> &order);

    /// Its name for texts; "point 3" for one without.
    static QString shownNameOf(const std::vector<Landmark> &landmarks, std::size_t index);

    /// Updates the selection after a change of the list.
    /// @return the changes of the selection
    Changes follow(const std::vector<Landmark> &before, const std::vector<Landmark> &after);

private:
    /// Changes single landmarks.
    template <class Change>
    geometry::Check edit(const std::vector<std::size_t> &indices, const QString &one, const QString &several,
                         const Change &change, const QString &mergeKey = {});
    /// @return whether the selection differs
    bool take(std::vector<std::size_t> indices, std::optional<std::size_t> current,
              std::optional<std::size_t> nextUnplaced);
    /// Keeps the order of a selection: added indices follow the present ones.
    void orderSelection(const std::vector<std::size_t> &indices, std::optional<std::size_t> current);
    std::string freeName() const;

    SceneDocument &m_document;
    ChangeNotifier &m_changes;
    std::vector<std::size_t> m_selection;
    std::vector<std::size_t> m_order; ///< the same indices, as they were selected
    std::optional<std::size_t> m_current;
    std::optional<std::size_t> m_nextUnplaced;
};

} // namespace unprojector::gui
