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

/// The one owner of the scene and of its undo stack. Widgets show it and ask it to change.
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
    /// The picture of the scene in the view's window, always valid.
    const geometry::Setup &setup() const { return m_unprojector->setup(); }
    /// The same, prepared for clicks.
    const unproject::Unprojector &unprojector() const { return *m_unprojector; }
    /// Around all objects that are not hidden, world space.
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
    /// Whether anything, the camera included, is other than when the scene was opened or marked as saved. What was undone
    /// is not.
    bool isModified() const { return !m_undoStack.isClean(); }
    /// Whether there is more than a look around: a number, a transform, a clip plane was changed by the user.
    bool isEdited() const { return m_state.edit != m_savedEdit; }
    /// The scene as it is now is on the disk.
    void markSaved();
    /// The scene as it is now is nowhere else: it was recovered.
    void markUnsaved();

    /// Shows another scene. The pick and the undo stack go.
    /// @return the errors of setupOf; then nothing changed
    geometry::Check open(scene::Scene scene);
    // Each change is undoable. Where the picture would not be valid, the error of setupOf is returned and nothing
    // changes: the last good view stays.

    /// The user's work: changes anything of the scene as one edit. What follows from the objects (landmarks on them, a pick)
    /// goes with them; semilandmarks follow from the landmarks of their curve: curves().
    geometry::Check edit(const EditLabel &label, const std::function<void(scene::Scene &)> &change);
    /// Looking around: changes how the scene is shown. Ignored where it would leave no valid picture or changes nothing.
    void look(const EditLabel &label, const std::function<void(scene::SceneSettings &)> &change);
    /// The view's size changed. Not undoable. It is the window's where the scene has no size of its own.
    void setSurface(const geometry::Surface &surface);
    /// Has the setup of another size while `draw` runs, as for a picture that is exported. Reports nothing.
    /// @return the errors of setupOf; then `draw` has not run
    geometry::Check drawAt(const geometry::Surface &surface, const std::function<void()> &draw);

signals:
    /// Another scene is shown. Emitted before `changed`.
    void opened();
    /// Emitted once for all that was done together, when all of it is in place.
    void changed(unprojector::gui::Changes changes);

private:
    /// Puts a state in place, if its picture is valid. Derives anew only what follows from what changed.
    /// @return the changes, not reported yet; the errors of setupOf
    geometry::Result<Changes> take(const SceneState &state);
    /// Takes a state undoably, if it is another one.
    geometry::Check commit(const SceneState &state, const EditLabel &label);

    scene::Scene m_scene; ///< m_state in one piece
    SceneState m_state;
    geometry::Surface m_widgetSurface{1, 1, 1.0};        ///< what the view has room for
    std::optional<unproject::Unprojector> m_unprojector; ///< of the picture of the scene in the view's window
    geometry::Box m_bounds;
    scene::Ground m_ground;
    std::uint64_t m_lastEdit = 0;
    std::optional<std::uint64_t> m_savedEdit = 0; ///< none: no state of the scene is on the disk
    ChangeNotifier m_changes;
    QUndoStack m_undoStack;
    SceneLandmarks m_sceneLandmarks;
    std::unique_ptr<Picks> m_picks;
    std::unique_ptr<SceneCurves> m_curves;
};

} // namespace unprojector::gui
