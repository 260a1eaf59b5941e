#pragma once

#include "gui/document/change_notifier.h"
#include "gui/document/kept_pick.h"
#include "gui/document/ray_casters.h"

#include <QObject>

#include <cstdint>
#include <optional>
#include <vector>

namespace unprojector::gui {

class SceneDocument;

/// A point that another program has got, and the right one of its click, as both are marked in the views. World space.
struct WrongPointMark {
    geometry::WorldPoint got;
    std::optional<geometry::WorldPoint> right;
    friend bool operator==(const WrongPointMark &, const WrongPointMark &) = default;
};

/// The pick of a document: the result of the last click, with the answer of its ray, which comes once the clicked models are
/// prepared. Neither saved nor undone; it follows its object through every change of the list of objects.
class Picks : public QObject {
    Q_OBJECT
public:
    /// @param changes  reports what changes here
    Picks(const SceneDocument &document, ChangeNotifier &changes);

    /// The picked surface or background; nothing before the first click, in another scene, and while the object that was
    /// hit is removed.
    const std::optional<unproject::Pick> &pick() const { return m_picked.pick; }
    /// What the ray of the pick meets on the meshes; null without a pick.
    const PickedRay *pickedRay() const { return m_picked.pick ? &m_picked.ray : nullptr; }
    std::optional<geometry::WorldPoint> pickedPoint() const { return gui::pickedPoint(m_picked); }
    SinceClick sinceClick() const;

    /// Unprojects a click or the pointer's position. It is not kept.
    geometry::Result<unproject::Pick> unprojected(const unproject::PixelClick &click) const;
    /// Keeps a click as the pick. `failed` reports one that could not be unprojected, and the last pick stays.
    void setPick(const geometry::Result<unproject::Pick> &pick);
    const KeptPick &keptPick() const { return m_picked; }
    /// Shows an earlier pick again, or none.
    /// @param kept  of this scene, with the objects that it has now
    void show(KeptPick kept);
    /// The same, as if the last click had not been: a drag has followed its press.
    void putBack(KeptPick kept);
    void clearPick() { show({}); }
    /// The objects that the indices of the pick refer to.
    const ObjectList &objectList() const { return m_objects; }

    /// What clicks take on the meshes. The pick stays as it was taken.
    ray::Snap snap() const { return m_snap; }
    void setSnap(ray::Snap snap);
    /// The rays of the picture as it is now; null while a model is not prepared for them. Valid until the next change.
    const ray::SceneRays *rays() const;
    /// The setup is another one.
    void forgetRays() { m_rays.reset(); }
    /// Prepares the models for rays.
    RayCasters &rayCasters() { return m_casters; }

    /// The points that other programs have got: marked while the doctor shows them.
    const std::vector<WrongPointMark> &wrongPoints() const { return m_wrongPoints; }
    void markWrongPoints(std::vector<WrongPointMark> points);

    /// Follows a change of the document.
    /// @param objects  as they are now
    /// @param changes  of the document
    /// @return the changes of the pick
    Changes follow(const ObjectList &objects, Changes changes);

signals:
    /// A click could not be unprojected; the last pick stays.
    void failed(const unprojector::geometry::Error &error);
    /// The last click counts no more; an earlier pick, or none, is about to be shown.
    void takenBack();

private:
    /// A pick whose object was removed.
    struct Lost {
        KeptPick kept;
        ObjectList objects; ///< before the removal: with its object the pick comes back
    };

    /// Prepares the models that rays can meet, those of a pick that waits for its answer included.
    void prepareRays();
    /// Asks what the ray of the pick meets, where that is not known yet.
    /// @return whether more is known now
    bool askRay();

    const SceneDocument &m_document;
    ChangeNotifier &m_changes;
    ObjectList m_objects;
    KeptPick m_picked;
    std::optional<Lost> m_lost;
    std::uint64_t m_clicks = 0; ///< so many were kept
    RayCasters m_casters;
    mutable std::optional<ray::SceneRays> m_rays; ///< of the picture, once they were asked for
    ray::Snap m_snap = ray::Snap::Surface;
    std::vector<WrongPointMark> m_wrongPoints;
};

} // namespace unprojector::gui
