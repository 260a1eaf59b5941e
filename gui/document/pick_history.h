#pragma once

#include "gui/document/document_change.h"
#include "gui/document/kept_pick.h"

#include <QObject>

#include <cstddef>
#include <vector>

namespace unprojector::gui {

class SceneDocument;

/// A pick in the list of picks.
struct EarlierPick {
    int number = 0; ///< from 1, in the order of clicks in this scene
    KeptPick kept;
    ObjectList objects;  ///< the list that the indices of the pick refer to
    bool isLost = false; ///< its object was removed; undoing the removal restores it
};

/// The last picks of a scene. Listens to the document: a click adds a pick, a drag removes the pick
/// of its press, and another scene empties the list. Picks follow their objects as the shown pick
/// does.
class PickHistory : public QObject {
    Q_OBJECT
public:
    /// The length of the list; the oldest picks are dropped first.
    static constexpr std::size_t kMost = 20;

    /// @param document  outlives the list
    explicit PickHistory(SceneDocument &document, QObject *parent = nullptr);

    /// The picks whose objects exist, the oldest first.
    std::vector<EarlierPick> picks() const;
    /// The number of the pick that the document shows; 0: none.
    int shownNumber() const { return m_shown; }
    /// Shows a pick again.
    /// @param number  of one of picks(); any other is ignored
    void show(int number);

signals:
    /// Emitted when the list or one of its picks changes, or the document shows another pick.
    void changed();

private:
    void follow(Changes changes);
    /// @param areOthers  objects were added, removed or reordered; else indices stay valid
    void followObjects(bool areOthers);
    /// Adds the document's pick, or updates it if it is in the list.
    void takePick();
    void takeBack();

    SceneDocument &m_document;
    std::vector<EarlierPick> m_picks;
    int m_lastNumber = 0;
    int m_shown = 0;
    bool m_isRepeat = false; ///< the last click repeated the one before: it gets no row
};

} // namespace unprojector::gui
