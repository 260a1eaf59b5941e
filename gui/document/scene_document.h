#pragma once

#include "core/geometry/camera_motion.h"
#include "core/scene/scene.h"
#include "core/unproject/pick.h"

#include <QObject>
#include <QString>
#include <QUndoStack>

#include <cstdint>
#include <optional>
#include <vector>

namespace unprojector::gui {
using namespace geometry;
using namespace scene;
using namespace unproject;

struct SceneState;

/// The one owner of the scene, the undo stack and the picked point. Widgets show it and ask it to change; it unprojects.
class SceneDocument : public QObject {
    Q_OBJECT
public:
    explicit SceneDocument(QObject *parent = nullptr);

    const Scene &scene() const { return m_scene; }
    const std::vector<SceneObject> &objects() const { return m_scene.objects; }
    /// The picture of the scene in the view's window, always valid.
    const Picture &geometry() const { return m_unprojector->picture(); }
    /// The same, prepared for clicks.
    const Unprojector &unprojector() const { return *m_unprojector; }
    /// The picked surface or background; nothing before the first click and after a change of the scene.
    const std::optional<Pick> &pick() const { return m_pick; }
    QUndoStack &undoStack() { return m_undoStack; }

    /// Whether anything, the camera included, is other than when the scene was opened or marked as saved. What was undone
    /// is not.
    bool isModified() const { return !m_undoStack.isClean(); }
    /// Whether there is more than a look around: a number, a transform, a clip plane was changed by the user.
    bool isEdited() const { return m_edit != m_savedEdit; }
    /// The scene as it is now is on the disk.
    void markSaved();
    /// The scene as it is now is nowhere else: it was recovered.
    void markUnsaved();

    /// Around all objects, world space.
    const Box &bounds() const { return m_bounds; }
    /// The drawn ground: a square at the lowest height of the objects, world space.
    const Box &ground() const { return m_ground; }
    /// Distance of two ground lines: 1, 2 or 5 times a power of ten, world units.
    double groundSpacing() const { return m_groundSpacing; }

    /// Shows another scene. The pick and the undo stack go.
    /// @return the errors of pictureOf; then nothing changed
    Check open(Scene scene);
    /// The same objects from a home view in front and a little above that fits them.
    void setObjects(std::vector<SceneObject> objects);
    void setObjects(std::vector<SceneObject> objects, const LookAt &home);

    /// Makes the scene another one, undoably. It is an edit: the user's work, not only a look around.
    /// @param text      what the user did, for the undo menu: "Near"
    /// @param mergeKey  changes with the same key, one right after the other, are undone as one; empty: never merged
    /// @return the errors of pictureOf; then nothing changed: the last good view stays
    Check change(Scene scene, const QString &text, const QString &mergeKey = {});

    /// The view's size changed. Not undoable.
    void setSurface(const Surface &surface);

    // Looking around. Each is undoable, and ignored where it would leave no valid picture.
    void setCamera(const LookAt &camera, const QString &mergeKey = {});
    void setProjection(const Projection &projection, const QString &mergeKey = {});
    void setView(const LookAt &camera, const Projection &projection, const QString &mergeKey = {});
    void fit();
    void goHome();
    /// From a perspective to glOrtho and back, the picture equal at `pivotDistance`.
    void switchProjection();

    /// Distance in front of the eye where two projections are to agree: the picked point's, else the centre's.
    double pivotDistance() const;

    /// Unprojects a click and keeps it as the pick.
    void pickAt(const WidgetPoint &position, const DepthSample &sample);
    void clearPick();
    /// Unprojects without keeping, for the pointer's readout.
    Result<Pick> unprojected(const WidgetPoint &position, const DepthSample &sample) const;
    /// The world point that navigation turns about when the pointer is at this sample: the surface there, else the
    /// point of the pointer's ray at the centre's distance.
    WorldPoint pivotAt(const WidgetPoint &position, const DepthSample &sample) const;

signals:
    /// Other models are shown; geometryChanged follows.
    void objectsChanged();
    /// The scene or the picture of it changed in any way.
    void geometryChanged();
    /// The scene was changed, undone, redone, opened, or marked: isModified and isEdited may be other than before.
    void stateChanged();
    void pickChanged();
    /// A click that could not be unprojected, with the reason; the last pick stays.
    void pickFailed(const unprojector::geometry::Error &error);

private:
    friend class SceneChange;

    /// Takes a scene as it is, if its picture is valid.
    Check apply(Scene scene);
    /// Takes a scene undoably, as made by the edit of that number.
    Check record(Scene scene, std::uint64_t edit, const QString &text, const QString &mergeKey);
    Check look(Scene scene, const QString &text, const QString &mergeKey = {});
    Check restore(const SceneState &state);
    void updateGround();

    Scene m_scene;
    Surface m_surface{1, 1, 1.0};
    std::optional<Unprojector> m_unprojector; ///< of the picture of the scene in the view's window
    std::optional<Pick> m_pick;
    Box m_bounds;
    Box m_ground;
    double m_groundSpacing = 1.0;
    QUndoStack m_undoStack;
    std::uint64_t m_edit = 0; ///< the number of the edit that made the scene
    std::uint64_t m_lastEdit = 0;
    std::optional<std::uint64_t> m_savedEdit = 0; ///< none: no state of the scene is on the disk
};

} // namespace unprojector::gui
