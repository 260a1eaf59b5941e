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

/// A point computed by another program, and the right point of its click, as both are marked in the
/// views. World space.
struct WrongPointMark {
    geometry::WorldPoint got;
    std::optional<geometry::WorldPoint> right;
    friend bool operator==(const WrongPointMark &, const WrongPointMark &) = default;
};

/// The pick of a document: the result of the last click, with its ray's answer, which arrives once
/// the clicked models are prepared. It is neither saved nor undone; it follows its object through
/// every change of the object list.
class Picks : public QObject {
    Q_OBJECT
public:
    /// @param changes  receives the changes of the pick
    Picks(const SceneDocument &document, ChangeNotifier &changes);

    /// The picked surface or background; nothing before the first click, in another scene, and
    /// while the hit object is removed.
    const std::optional<unproject::Pick> &pick() const { return m_picked.pick; }
    /// The hit of the pick's ray on the meshes; null without a pick.
    const PickedRay *pickedRay() const { return m_picked.pick ? &m_picked.ray : nullptr; }
    std::optional<geometry::WorldPoint> pickedPoint() const { return gui::pickedPoint(m_picked); }
    SinceClick sinceClick() const;

    /// Unprojects a click or the pointer's position, without keeping it.
    geometry::Result<unproject::Pick> unprojected(const unproject::PixelClick &click) const;
    /// Keeps a click as the pick. If it could not be unprojected, emits `failed` and keeps the last
    /// pick.
    void setPick(const geometry::Result<unproject::Pick> &pick);
    const KeptPick &keptPick() const { return m_picked; }
    /// Shows an earlier pick again, or none.
    /// @param kept  of this scene, with the objects that it has now
    void show(KeptPick kept);
    /// Shows an earlier pick and forgets the last click: a drag followed its press.
    void putBack(KeptPick kept);
    void clearPick() { show({}); }
    /// The objects that the indices of the pick refer to.
    const ObjectList &objectList() const { return m_objects; }

    /// The snap mode of clicks. It doesn't change the present pick.
    ray::Snap snap() const { return m_snap; }
    void setSnap(ray::Snap snap);
    /// The rays of the current setup; null while a model is not prepared for them. Valid until the
    /// next change.
    const ray::SceneRays *rays() const;
    /// Discards the cached rays: the setup has changed.
    void forgetRays() { m_rays.reset(); }
    /// Prepares the models for rays.
    RayCasters &rayCasters() { return m_casters; }

    /// The points computed by other programs: marked while the doctor shows them.
    const std::vector<WrongPointMark> &wrongPoints() const { return m_wrongPoints; }
    void markWrongPoints(std::vector<WrongPointMark> points);

    /// Follows a change of the document.
    /// @param objects  the current ones
    /// @param changes  of the document
    /// @return the changes of the pick
    Changes follow(const ObjectList &objects, Changes changes);

signals:
    /// Emitted when a click could not be unprojected; the last pick stays.
    void failed(const unprojector::geometry::Error &error);
    /// Emitted when the last click is withdrawn; an earlier pick, or none, is shown next.
    void takenBack();

private:
    /// A pick whose object was removed.
    struct Lost {
        KeptPick kept;
        ObjectList objects; ///< before the removal: the pick returns with its object
    };

    /// Prepares the models that rays can hit, including the models of a pick that waits for its
    /// answer.
    void prepareRays();
    /// Computes what the ray of the pick hits, if that is not known yet.
    /// @return whether more is known now
    bool askRay();

    const SceneDocument &m_document;
    ChangeNotifier &m_changes;
    ObjectList m_objects;
    KeptPick m_picked;
    std::optional<Lost> m_lost;
    std::uint64_t m_clicks = 0; ///< number of kept clicks
    RayCasters m_casters;
    mutable std::optional<ray::SceneRays> m_rays; ///< of the setup, created on demand
    ray::Snap m_snap = ray::Snap::Surface;
    std::vector<WrongPointMark> m_wrongPoints;
};

} // namespace unprojector::gui
