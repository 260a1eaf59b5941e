#pragma once

#include "core/scene/scene.h"

#include <QFlags>

namespace unprojector::gui {
using namespace geometry;
using namespace scene;

/// What of a document is other than before, so that everybody looks only at what concerns them.
enum class Change {
    Objects = 0x01,    ///< which objects there are, and in which order
    Placement = 0x02,  ///< where an object stands
    ClipPlanes = 0x04, ///< those that cut and those that are switched off
    Picture = 0x08,    ///< camera, projection, viewport, depth range, the window's size, or the rules they follow
    Pick = 0x10,       ///< the picked point
    History = 0x20     ///< what can be undone and what is saved: isModified and isEdited may be other than before
};
Q_DECLARE_FLAGS(Changes, Change)

/// All that a view of the scene shows; the mark of the pick lies over it.
constexpr Changes kSeen{Change::Objects, Change::Placement, Change::ClipPlanes, Change::Picture};

/// Whether it is the same object, wherever it stands.
bool isSameObject(const SceneObject &a, const SceneObject &b);
/// Picture and ClipPlanes, or nothing where both settings are the same.
Changes changesBetween(const SceneSettings &a, const SceneSettings &b);
/// Objects or Placement, or nothing where both lists are the same.
Changes changesBetween(const std::vector<SceneObject> &a, const std::vector<SceneObject> &b);

/// Whether two looks at a scene differ by no more than rounding: a camera that is asked to go where it stands.
bool isSameLook(const SceneSettings &a, const SceneSettings &b);

} // namespace unprojector::gui

// In no namespace, as Qt's own are: these would hide those.
Q_DECLARE_OPERATORS_FOR_FLAGS(unprojector::gui::Changes)
