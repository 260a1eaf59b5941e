#pragma once

#include "core/geometry/camera_motion.h"
#include "core/unproject/pick.h"
#include "gui/document/scene_document.h"

#include <QString>

#include <cstddef>
#include <vector>

namespace unprojector::gui {

// Looking around in a document. Each function is undoable, and does nothing if it would give an
// invalid setup or change nothing.

/// @param mergeKey  see EditLabel
void setCamera(SceneDocument &document, const geometry::LookAt &camera, const QString &mergeKey = {});
void setProjection(SceneDocument &document, const geometry::Projection &projection, const QString &mergeKey = {});
void setView(SceneDocument &document, const geometry::LookAt &camera, const geometry::Projection &projection,
             const QString &mergeKey = {});
/// Fits all visible objects into the view, as large as possible; without any object, the landmarks.
void fitAll(SceneDocument &document);
/// Fits one object, hidden or not. @pre index < objects().size()
void fitObject(SceneDocument &document, std::size_t index);
/// Shows all visible objects as large as possible, in the view direction of another camera and with
/// its projection.
void fitAllFrom(SceneDocument &document, const geometry::LookAt &camera, const geometry::Projection &projection);
/// Returns to the camera that the scene opened with.
void goHome(SceneDocument &document);
/// Switches from a perspective to glOrtho and back; the image stays the same at centerDistance.
void switchProjection(SceneDocument &document);

/// Shows these objects as another scene, from a home view in front and a little above that fits
/// them.
void openObjects(SceneDocument &document, std::vector<scene::SceneObject> objects);
void openObjects(SceneDocument &document, std::vector<scene::SceneObject> objects, const geometry::LookAt &home);

/// The distance in front of the eye at which two projections agree: the distance of the camera's
/// centre. With a nearer picked point instead, everything behind it would become larger than the
/// view.
double centerDistance(const geometry::LookAt &camera);

/// The world point that navigation turns about: the surface under the pointer. On the background,
/// the point of the pointer's ray at the centre's distance. If nothing could be unprojected, the
/// camera's centre.
geometry::WorldPoint pivotOf(const geometry::LookAt &camera, const geometry::Result<unproject::Pick> &pick);

} // namespace unprojector::gui
