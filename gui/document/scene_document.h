#pragma once

#include "core/geometry/camera_motion.h"
#include "core/scene/opening_view.h"
#include "core/scene/scene.h"
#include "core/unproject/pick.h"
#include "gui/document/document_change.h"
#include "gui/document/object_names.h"
#include "gui/document/picked_ray.h"
#include "gui/document/ray_casters.h"
#include "gui/document/scene_change.h"
#include "gui/document/scene_points.h"

#include <QObject>
#include <QString>
#include <QUndoStack>

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace unprojector::gui {
using namespace geometry;
using namespace scene;
using namespace unproject;

class SceneCurves;

/// What the user did, as the undo menu says it.
struct Deed {
    QString text;          ///< "Near"
    QString mergeKey = {}; ///< deeds with the same key, one right after the other, are undone as one; empty: never
};

/// What is other than it was at the click of the pick.
struct SinceClick {
    bool isOtherPicture = false; ///< camera, projection, viewport, depth range or the window's size
    bool isObjectMoved = false;  ///< the object that was hit: the point is where its surface was
    bool isObjectHidden = false; ///< the object that was hit
    bool isCutAway = false;      ///< the point lies on the side of a clip plane where nothing is drawn

    bool isAnything() const { return isOtherPicture || isObjectMoved || isObjectHidden || isCutAway; }
};

/// A point that another program has got, and the right one of its click, as both are marked in the views. World space.
struct WrongPointMark {
    WorldPoint got;
    std::optional<WorldPoint> right;
    friend bool operator==(const WrongPointMark &, const WrongPointMark &) = default;
};

/// The one owner of the scene, the undo stack and the picked point. Widgets show it and ask it to change; it unprojects.
class SceneDocument : public QObject {
    Q_OBJECT
public:
    explicit SceneDocument(QObject *parent = nullptr);
    /// Tells nobody of its end.
    ~SceneDocument() override;

    const Scene &scene() const { return m_scene; }
    const std::vector<SceneObject> &objects() const { return m_scene.objects; }
    /// The placed points, world space.
    const landmarks::LandmarkSet &landmarkSet() const { return m_scene.landmarks; }
    const std::vector<landmarks::Landmark> &landmarks() const { return m_scene.landmarks.landmarks; }
    /// What is done to them one by one, and which of them are selected.
    ScenePoints &points() { return m_points; }
    const ScenePoints &points() const { return m_points; }
    /// The lines on the surface between them.
    SceneCurves &curves() { return *m_curves; }
    const SceneCurves &curves() const { return *m_curves; }
    /// The picture of the scene in the view's window, always valid.
    const Picture &geometry() const { return m_unprojector->picture(); }
    /// The same, prepared for clicks.
    const Unprojector &unprojector() const { return *m_unprojector; }
    /// The picked surface or background; nothing before the first click, in another scene, and while the object that was
    /// hit is not in it.
    const std::optional<Pick> &pick() const { return m_picked.pick; }
    /// What the ray of the pick meets on the meshes; null without a pick.
    const PickedRay *pickedRay() const { return m_picked.pick ? &m_picked.ray : nullptr; }
    /// The one point that the pick stands for: what the mode of clicks took on the mesh, else the surface by the formula. Nothing
    /// where there is neither.
    std::optional<WorldPoint> pickedPoint() const;
    /// What the rays of the picture meet, as it is now; null while a model is not prepared for them. Until the next change.
    const ray::SceneRays *rays() const;
    /// What clicks take on the meshes. The pick stays as it was taken.
    ray::Snap snap() const { return m_snap; }
    void setSnap(ray::Snap snap);
    /// What prepares the models for rays.
    RayCasters &rayCasters() { return m_casters; }
    SinceClick sinceClick() const;
    /// Where the given point lies in the picture as it is now; nothing where there is none, or no world point of it.
    std::optional<WorldPoint> givenWorld() const;
    /// What other programs have got: marked while somebody looks into it. Not of the scene: neither kept nor undone.
    const std::vector<WrongPointMark> &wrongPoints() const { return m_wrongPoints; }
    void markWrongPoints(std::vector<WrongPointMark> points);
    QUndoStack &undoStack() { return m_undoStack; }

    /// Whether anything, the camera included, is other than when the scene was opened or marked as saved. What was undone
    /// is not.
    bool isModified() const { return !m_undoStack.isClean(); }
    /// Whether there is more than a look around: a number, a transform, a clip plane was changed by the user.
    bool isEdited() const { return m_state.edit != m_savedEdit; }
    /// The scene as it is now is on the disk.
    void markSaved();
    /// The scene as it is now is nowhere else: it was recovered.
    void markUnsaved();

    /// Around all objects that are not hidden, world space.
    const Box &bounds() const { return m_bounds; }
    /// The drawn ground: a square at the lowest height of the objects, world space.
    const Box &ground() const { return m_ground.box; }
    /// Distance of two ground lines: 1, 2 or 5 times a power of ten, world units.
    double groundSpacing() const { return m_ground.spacing; }

    /// Shows another scene. The pick and the undo stack go.
    /// @return the errors of pictureOf; then nothing changed
    Check open(Scene scene);
    // Each change is undoable. Where the picture would not be valid, the error of pictureOf is returned and nothing
    // changes: the last good view stays.

    /// The user's work: changes anything of the scene as one edit. What follows from the objects (landmarks on them, a pick)
    /// goes with them; semilandmarks follow from the landmarks of their curve: curves().
    Check edit(const Deed &deed, const std::function<void(Scene &)> &change);
    /// Looking around: changes how the scene is shown. Ignored where it would leave no valid picture or changes nothing.
    void look(const Deed &deed, const std::function<void(SceneSettings &)> &change);

    /// The view's size changed. Not undoable.
    void setSurface(const Surface &surface);

    /// Unprojects a click or the pointer's position. It is not kept.
    Result<Pick> unprojected(const PixelClick &click) const;
    /// Keeps a click as the pick. Of one that could not be unprojected `pickFailed` tells why, and the last pick stays.
    void setPick(const Result<Pick> &pick);
    /// unprojected() and setPick() of the pixel that a position lies in.
    void pickAt(const WidgetPoint &position, const DepthSample &sample);
    const KeptPick &keptPick() const { return m_picked; }
    /// Shows an earlier pick again, or none: as if nothing had been picked since.
    /// @param kept  of this scene, with the objects that it has now
    void putBack(const KeptPick &kept);
    void clearPick() { putBack({}); }

signals:
    /// Another scene is shown. Told before what of it has changed.
    void opened();
    /// Told once for all that was done together, when all of it is in place.
    void changed(unprojector::gui::Changes changes);
    /// A click that could not be unprojected, with the reason; the last pick stays.
    void pickFailed(const unprojector::geometry::Error &error);

private:
    friend class SceneChange;
    friend class ScenePoints;
    friend class SceneCurves;

    /// Gathers what changes while one of them lives; the last tells it. Nobody hears of a half-made change.
    class Telling {
    public:
        explicit Telling(SceneDocument &document);
        ~Telling();
        Telling(const Telling &) = delete;
        Telling &operator=(const Telling &) = delete;

    private:
        SceneDocument &m_document;
    };
    void tell(Changes changes);
    bool isCutAway(const Pick &pick) const;
    /// worldFromObject of the object of a pick, the identity where it has none.
    glm::dmat4 placementOf(const Pick &pick) const;
    /// Puts a state in place, if its picture is valid.
    /// @return what is other than before, not told yet; the errors of pictureOf
    Result<Changes> take(const SceneState &state);
    /// Takes a state undoably, if it is another one.
    Check record(SceneState state, const Deed &deed);
    /// A pick knows its object by its place in the list, goes with it and comes back with it.
    /// @param before  the objects that the pick's place is of
    /// @return whether it is another pick now
    bool followObjects(const std::shared_ptr<const std::vector<SceneObject>> &before);
    /// Prepares the models that rays can meet, those of a pick that waits for its answer included.
    void prepareRays();
    /// Asks what the ray of the pick meets, where that is not known yet.
    /// @return whether more is known now
    bool answerRay();
    /// @param objects  that the hit's place is of
    MetPlace metPlace(const ray::SceneHit &hit, const std::vector<SceneObject> &objects) const;
    /// For undo and redo; told when the stack has come to its new place.
    void restore(const SceneState &state);

    Scene m_scene; ///< m_state in one piece
    SceneState m_state;
    Surface m_surface{1, 1, 1.0};
    std::optional<Unprojector> m_unprojector; ///< of the picture of the scene in the view's window
    KeptPick m_picked;
    /// The pick whose object was taken out, and the objects before that: with the object it comes back.
    KeptPick m_lost;
    std::shared_ptr<const std::vector<SceneObject>> m_lostPickObjects;
    ScenePoints m_points;
    RayCasters m_casters;
    mutable std::optional<ray::SceneRays> m_rays; ///< of the picture, once somebody has asked
    ray::Snap m_snap = ray::Snap::Surface;
    std::vector<WrongPointMark> m_wrongPoints;
    Box m_bounds;
    Ground m_ground;
    std::uint64_t m_lastEdit = 0;
    std::optional<std::uint64_t> m_savedEdit = 0; ///< none: no state of the scene is on the disk
    Changes m_untold;
    int m_tellings = 0;
    QUndoStack m_undoStack;
    std::unique_ptr<SceneCurves> m_curves;
};

} // namespace unprojector::gui
