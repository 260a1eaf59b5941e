#pragma once

#include "core/scene/scene.h"

#include <QFlags>

#include <cstddef>
#include <optional>
#include <vector>

namespace unprojector::gui {

/// The parts of a document that changed, so that each receiver reacts only to its own.
enum class Change {
    Objects = 0x01,            ///< the list of objects or its order
    Placement = 0x02,          ///< an object's transform
    Visibility = 0x40,         ///< which objects are hidden
    Names = 0x80,              ///< an object's name
    ClipPlanes = 0x04,         ///< the clip planes, active or switched off
    Setup = 0x08,              ///< camera, projection, viewport, depth range, the window's size, or their conventions
    Pick = 0x10,               ///< the picked point
    Snap = 0x200,              ///< the snap mode of clicks
    Ray = 0x100,               ///< what the picked point's ray hits, found after the pick was reported
    Landmarks = 0x400,         ///< the landmarks: their list, positions and descriptions
    LandmarkSelection = 0x800, ///< the selected landmarks, and the one that is placed next
    Curves = 0x1000,           ///< the lines of curves: computed, or about to be computed again
    GivenPoint = 0x2000,       ///< the point that the user entered
    Conventions = 0x4000,      ///< the conventions of the shown matrices and points
    WrongPoints = 0x8000,      ///< the wrong points that are marked beside the right ones
    Preview = 0x10000, ///< the settings are shown for a while, or the scene's own again: see SceneDocument::preview
    History = 0x20     ///< undo steps and saved state: isModified and isEdited may have changed
};
Q_DECLARE_FLAGS(Changes, Change)

/// All changes that a view of the scene shows; the mark of the pick lies over it.
constexpr Changes kVisibleChanges{Change::Objects, Change::Placement, Change::Visibility, Change::ClipPlanes,
                                  Change::Setup};

/// Returns whether it is the same object, regardless of its transform and visibility.
bool isSameObject(const scene::SceneObject &a, const scene::SceneObject &b);
/// The index in `after` of an object of `before`, by all its properties, or by its position if only
/// its name is new.
/// @pre index < before.size()
std::optional<std::size_t> indexAfter(const std::vector<scene::SceneObject> &before, std::size_t index,
                                      const std::vector<scene::SceneObject> &after);
/// Setup, ClipPlanes, GivenPoint and Conventions, or nothing if both settings are the same.
Changes changesBetween(const scene::SceneSettings &a, const scene::SceneSettings &b);
/// The changes between two lists of objects: Objects with its consequences; or Placement,
/// Visibility and Names; or nothing if both are the same.
Changes changesBetween(const std::vector<scene::SceneObject> &a, const std::vector<scene::SceneObject> &b);

/// Returns whether two views of a scene differ by no more than rounding, as when a camera is sent
/// to where it stands.
bool isSameLook(const scene::SceneSettings &a, const scene::SceneSettings &b);

} // namespace unprojector::gui

// These operators are in no namespace, like Qt's own: operators in the namespace would hide Qt's.
Q_DECLARE_OPERATORS_FOR_FLAGS(unprojector::gui::Changes)
