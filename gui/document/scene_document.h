#pragma once

#include "core/scene/opening_view.h"
#include "core/scene/scene.h"
#include "core/unproject/unprojector.h"
#include "gui/document/change_notifier.h"
#include "gui/document/document_change.h"
#include "gui/document/object_names.h"
#include "gui/document/scene_change.h"
#include "gui/document/scene_landmarks.h"

#include <QObject>
#include <QUndoStack>

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace unprojector::gui {

class Picks;
class SceneCurves;

/// The owner of the scene and of its undo stack. Widgets show it and ask it to change.
class SceneDocument : public QObject {
    Q_OBJECT
public:
    explicit SceneDocument(QObject *parent = nullptr);
    /// Emits nothing.
    ~SceneDocument() override;

    const scene::Scene &scene() const { return m_scene; }
    const std::vector<scene::SceneObject> &objects() const { return m_scene.objects; }
    /// The placed landmarks, world space.
    const std::vector<landmarks::Landmark> &landmarks() const { return m_scene.landmarks.landmarks; }
    /// The setup of the scene in the view's window, always valid.
    const geometry::Setup &setup() const { return m_unprojector->setup(); }
    /// The scene, and its setup, as if no other settings were previewed: what is saved.
    scene::Scene ownScene() const;
    geometry::Setup ownSetup() const;
    /// The unprojector of that setup, prepared for clicks.
    const unproject::Unprojector &unprojector() const { return *m_unprojector; }
    /// The bounding box of all visible objects, world space.
    const geometry::Box &bounds() const { return m_bounds; }
    /// The drawn ground: a square at the lowest height of the objects, world space.
    const scene::Ground &ground() const { return m_ground; }

    /// Edits of single landmarks, and which of them are selected.
    SceneLandmarks &sceneLandmarks() { return m_sceneLandmarks; }
    const SceneLandmarks &sceneLandmarks() const { return m_sceneLandmarks; }
    /// The lines on the surface between them.
    SceneCurves &curves() { return *m_curves; }
    const SceneCurves &curves() const { return *m_curves; }
    /// The result of the last click.
    Picks &picks() { return *m_picks; }
    const Picks &picks() const { return *m_picks; }

    QUndoStack &undoStack() { return m_undoStack; }
    /// Returns whether anything, the camera included, has changed since the scene was opened or
    /// marked as saved. Undone changes don't count.
    bool isModified() const { return !m_undoStack.isClean(); }
    /// Returns whether the user changed more than the view: a number, a transform, a clip plane.
    bool isEdited() const { return m_state.edit != m_savedEdit; }
    /// Marks the current scene as saved on the disk.
    void markSaved();
    /// Marks the current scene as saved nowhere: it was recovered.
    void markUnsaved();

    /// Shows another scene. Clears the pick and the undo stack.
    /// @return the errors of setupOf; then nothing changed
    geometry::Check open(scene::Scene scene);
    // Each change is undoable. If the setup would be invalid, the functions return the error of
    // setupOf and change nothing: the last valid view stays.

    /// Applies the user's change of anything in the scene as one edit. Landmarks on the objects and
    /// the pick follow the objects; semilandmarks follow the landmarks of their curve: curves().
    geometry::Check edit(const EditLabel &label, const std::function<void(scene::Scene &)> &change);
    /// Changes how the scene is shown. Does nothing if the setup would be invalid or nothing
    /// changes.
    void look(const EditLabel &label, const std::function<void(scene::SceneSettings &)> &change);
    /// Shows other settings for a while, without a step of undo: only the views of the scene follow. An edit, undo, and
    /// another scene end it.
    /// @return the errors of setupOf; then nothing changed
    geometry::Check preview(const scene::SceneSettings &settings);
    /// Shows the scene's own settings again.
    void endPreview();
    /// Replaces the landmarks for a command of the undo stack, which reports the change: pushes no
    /// command itself.
    void restoreLandmarks(landmarks::LandmarkSet set);
    /// Sets the view's size, not undoably. A scene with a size of its own ignores the window's.
    void setSurface(const geometry::Surface &surface);
    /// Runs `draw` with the setup of another size, as for an exported image. Reports nothing.
    /// @return the errors of setupOf; then `draw` has not run
    geometry::Check drawAt(const geometry::Surface &surface, const std::function<void()> &draw);

signals:
    /// Emitted when another scene is shown, before `changed`.
    void opened();
    /// Emitted once for all changes made together, when all of them are applied.
    void changed(unprojector::gui::Changes changes);

private:
    /// What a preview hides.
    struct Own {
        scene::SceneSettings settings;
        geometry::Setup setup; ///< when the preview began
    };

    /// Applies a state if its setup is valid. Recomputes only what depends on the changed parts.
    /// @return the changes, not reported yet; the errors of setupOf
    geometry::Result<Changes> take(const SceneState &state);
    /// Takes the scene's own settings back after a preview.
    /// @return the changes, not reported yet
    Changes takeOwn();
    /// Applies a state undoably, if it differs.
    geometry::Check commit(const SceneState &state, const EditLabel &label);

    scene::Scene m_scene; ///< m_state as one value
    SceneState m_state;
    geometry::Surface m_widgetSurface{1, 1, 1.0};        ///< the room for the view
    std::optional<unproject::Unprojector> m_unprojector; ///< of the scene's setup in the view's window
    geometry::Box m_bounds;
    scene::Ground m_ground;
    std::uint64_t m_lastEdit = 0;
    std::optional<std::uint64_t> m_savedEdit = 0; ///< none: no state of the scene is saved
    std::optional<Own> m_own;                     ///< during a preview
    ChangeNotifier m_changes;
    QUndoStack m_undoStack;
    SceneLandmarks m_sceneLandmarks;
    std::unique_ptr<Picks> m_picks;
    std::unique_ptr<SceneCurves> m_curves;
};

} // namespace unprojector::gui
