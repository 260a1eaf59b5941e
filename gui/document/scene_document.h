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

/// A projection, and what of it follows something else.
struct ProjectionRule {
    Projection projection;
    bool followsViewport = true; ///< its proportions
    bool fitsObjects = true;     ///< its near and far planes
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
    const std::optional<GivenPoint> &givenPoint() const { return m_scene.givenPoint; }
    /// The matrix that the projection is given by, or none (any more).
    const MatrixProjection *givenProjection() const;
    /// The same of the view: eyeFromWorld.
    const glm::dmat4 *givenView() const;
    /// Where the given point lies in the picture as it is now; nothing where there is none, or no world point of it.
    std::optional<WorldPoint> givenWorld() const;
    /// What other programs have got: marked while somebody looks into it. Not of the scene: neither kept nor undone.
    const std::vector<WrongPointMark> &wrongPoints() const { return m_wrongPoints; }
    void markWrongPoints(std::vector<WrongPointMark> points);
    QUndoStack &undoStack() { return m_undoStack; }
    /// The language that deeds are named in, in words of its own.
    static QString language();
    /// The program speaks another one now: texts that are kept follow.
    void retranslate();

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
    /// Shows these objects as another scene, from a home view in front and a little above that fits them.
    void setObjects(std::vector<SceneObject> objects);
    void setObjects(std::vector<SceneObject> objects, const LookAt &home);

    // Edits: the user's work, not only a look around. Each is undoable. Where the picture would not be valid the error
    // of pictureOf is returned and nothing changes: the last good view stays.

    /// Puts objects after those that are there, under names of their own. Where they are not all in sight, the picture
    /// comes to show everything, near and far planes included. The pick stays.
    Check addObjects(std::vector<SceneObject> objects);
    /// @pre place < objects().size()
    Check removeObject(std::size_t place);
    /// Puts an object elsewhere in the list.
    /// @pre from, to < objects().size()
    Check moveObject(std::size_t from, std::size_t to);
    /// @pre place < objects().size()
    Check setObjectHidden(std::size_t place, bool isHidden);
    Check showAllObjects();
    bool hasHiddenObjects() const;
    /// @param name  blanks around it are taken off; see faultOf
    /// @return what is wrong with the name; then nothing changed
    /// @pre place < objects().size()
    NameFault renameObject(std::size_t place, const QString &name);
    /// @pre place < objects().size()
    Check editTransform(std::size_t place, std::vector<TransformStep> steps, const Deed &deed);
    Check editCamera(const LookAt &camera, const Deed &deed);
    Check editProjection(const ProjectionRule &rule, const Deed &deed);
    /// Takes a projection, a view or both from matrices, which the scene keeps as they are. What is none stays; the
    /// projection's numbers then hold as they stand.
    /// @return the errors of byParameters and pictureOf
    Check editMatrices(const std::optional<MatrixProjection> &projection, const std::optional<glm::dmat4> &eyeFromWorld,
                       const Deed &deed);
    /// Several settings as one edit; the points stay those that are placed.
    /// @return the errors of pictureOf: then none of them has changed, and there is nothing to redo
    Check editSettings(SceneSettings settings, const Deed &deed);
    Check editViewport(const ViewportRule &rule, const DepthRange &range, const Deed &deed);
    /// @param off  planes that are kept but do not cut; with the others no more than kMostClipPlanes
    Check editClipPlanes(std::vector<glm::dvec4> planes, std::vector<ClipPlaneOff> off, const Deed &deed);
    /// The point that is followed through the pipeline besides the clicks, or none.
    Check editGivenPoint(std::optional<GivenPoint> point, const Deed &deed);
    /// In whose conventions matrices and points are shown and written.
    Check editConventions(Api conventions, const Deed &deed);
    /// All placed points, for those that are there. What is done to single ones: points().
    Check editLandmarks(std::vector<landmarks::Landmark> landmarks, const Deed &deed);
    Check editLandmarkSet(landmarks::LandmarkSet set, const Deed &deed);

    /// The view's size changed. Not undoable.
    void setSurface(const Surface &surface);

    // Looking around. Each is undoable, and ignored where it would leave no valid picture or changes nothing.
    void setCamera(const LookAt &camera, const QString &mergeKey = {});
    void setProjection(const Projection &projection, const QString &mergeKey = {});
    void setView(const LookAt &camera, const Projection &projection, const QString &mergeKey = {});
    /// Shows all objects that are not hidden as large as the picture lets them be; without any object, the points.
    void fit();
    /// The same of one object, hidden or not. @pre place < objects().size()
    void fitObject(std::size_t place);
    void goHome();
    /// From a perspective to glOrtho and back, the picture equal at `centerDistance`.
    void switchProjection();

    /// Distance in front of the eye where two projections are to agree: that of the camera's centre, about which the picture
    /// is made. A picked point that is nearer would make everything behind it larger than the view.
    double centerDistance() const;

    /// Unprojects a click or the pointer's position. It is not kept.
    Result<Pick> unprojected(const WidgetPoint &position, const DepthSample &sample) const;
    /// Keeps a click as the pick. Of one that could not be unprojected `pickFailed` tells why, and the last pick stays.
    void setPick(const Result<Pick> &pick);
    /// unprojected() and setPick().
    void pickAt(const WidgetPoint &position, const DepthSample &sample) { setPick(unprojected(position, sample)); }
    const KeptPick &keptPick() const { return m_picked; }
    /// Shows an earlier pick again, or none: as if nothing had been picked since.
    /// @param kept  of this scene, with the objects that it has now
    void putBack(const KeptPick &kept);
    void clearPick() { putBack({}); }
    /// The world point that navigation turns about with the pointer there: the surface; on the background the point of
    /// the pointer's ray at the centre's distance; where nothing could be unprojected the camera's centre.
    WorldPoint pivotOf(const Result<Pick> &pick) const;

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
    /// The state as it is now, with other settings.
    SceneState with(SceneSettings settings) const;
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
    /// The settings that show all of these, of which the last `added` are new.
    SceneSettings showing(const std::vector<SceneObject> &objects, std::size_t added) const;
    Check edit(SceneSettings settings, const Deed &deed);
    Check edit(std::vector<SceneObject> objects, const Deed &deed);
    /// The state as it is now, edited, with other objects.
    SceneState with(std::vector<SceneObject> objects) const;
    void look(SceneSettings settings, const Deed &deed);
    /// Takes camera and projection of a picture, its near and far planes where nothing within these bounds is cut off.
    void showFramed(Picture picture, const Box &bounds);
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
