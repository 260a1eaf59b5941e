#pragma once

#include "core/scene/scene.h"

#include <QFlags>

#include <cstddef>
#include <optional>
#include <vector>

namespace unprojector::gui {

/// What of a document is other than before, so that everybody looks only at what concerns them.
enum class Change {
    Objects = 0x01,    ///< which objects there are, and in which order
    Placement = 0x02,  ///< where an object stands
    Visibility = 0x40, ///< which objects are hidden
    Names = 0x80,      ///< what an object is called
    ClipPlanes = 0x04, ///< those that cut and those that are switched off
    Setup = 0x08,      ///< camera, projection, viewport, depth range, the window's size, or the rules they follow
    Pick = 0x10,       ///< the picked point
    Snap = 0x200,      ///< what clicks take on the meshes
    Ray = 0x100,       ///< what the ray of the picked point meets, found after the pick was told
    Landmarks = 0x400, ///< the placed points: which there are, where, and what is said of them
    LandmarkSelection = 0x800, ///< which of them are selected, and which one waits for its place
    Curves =
        0x1000, ///< how the curves between points go: worked out after the points were told, or to be worked out anew
    GivenPoint = 0x2000,  ///< the point that is followed besides the clicks
    Conventions = 0x4000, ///< in whose conventions matrices and points are shown
    WrongPoints = 0x8000, ///< those that are marked beside the right ones
    History = 0x20        ///< what can be undone and what is saved: isModified and isEdited may be other than before
};
Q_DECLARE_FLAGS(Changes, Change)

/// All that a view of the scene shows; the mark of the pick lies over it.
constexpr Changes kVisibleChanges{Change::Objects, Change::Placement, Change::Visibility, Change::ClipPlanes,
                                  Change::Setup};

/// Whether it is the same object, wherever it stands and whether or not it is hidden.
bool isSameObject(const scene::SceneObject &a, const scene::SceneObject &b);
/// Where an object of one list is in another one, by all that is known of it, or by its place where only its name is new.
/// @pre index < before.size()
std::optional<std::size_t> indexAfter(const std::vector<scene::SceneObject> &before, std::size_t index,
                                      const std::vector<scene::SceneObject> &after);
/// Setup, ClipPlanes, GivenPoint and Conventions, or nothing where both settings are the same.
Changes changesBetween(const scene::SceneSettings &a, const scene::SceneSettings &b);
/// Of two lists of objects: Objects with what follows from that; or Placement, Visibility and Names, or nothing where both
/// are the same.
Changes changesBetween(const std::vector<scene::SceneObject> &a, const std::vector<scene::SceneObject> &b);

/// Whether two looks at a scene differ by no more than rounding: a camera that is asked to go where it stands.
bool isSameLook(const scene::SceneSettings &a, const scene::SceneSettings &b);

} // namespace unprojector::gui

// In no namespace, as Qt's own are: these would hide those.
Q_DECLARE_OPERATORS_FOR_FLAGS(unprojector::gui::Changes)
