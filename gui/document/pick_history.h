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
    int number = 0; ///< from 1, in the order of the clicks of this scene
    KeptPick kept;
    ObjectList objects;  ///< the list that the indices of the pick refer to
    bool isLost = false; ///< its object was removed; it comes back with the object
};

/// The last picks of a scene. Listens to the document: a click adds a pick, a drag takes the pick of its press back, and another
/// scene empties the list. Picks follow their objects as the shown pick does.
class PickHistory : public QObject {
    Q_OBJECT
public:
    /// The list keeps so many picks; the oldest go first.
    static constexpr std::size_t kMost = 20;

    /// @param document  outlives the list
    explicit PickHistory(SceneDocument &document, QObject *parent = nullptr);

    /// The picks whose objects are there, the oldest first.
    std::vector<EarlierPick> picks() const;
    /// The number of the pick that the document shows; 0: none.
    int shownNumber() const { return m_shown; }
    /// Shows a pick again.
    /// @param number  of one of picks(); any other is ignored
    void show(int number);

signals:
    /// Other picks are in the list, they have changed, or the document shows another one.
    void changed();

private:
    void follow(Changes changes);
    /// @param areOthers  objects came, went or were moved in the list; else each has its place still
    void followObjects(bool areOthers);
    /// Adds the document's pick, or renews it where it is in the list.
    void takePick();
    void takeBack();

    SceneDocument &m_document;
    std::vector<EarlierPick> m_picks;
    int m_lastNumber = 0;
    int m_shown = 0;
    bool m_isRepeat = false; ///< the last click was the one before again: it has no row of its own
};

} // namespace unprojector::gui
