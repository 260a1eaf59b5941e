#pragma once

#include "core/geometry/camera_motion.h"
#include "core/unproject/pick.h"
#include "gui/document/scene_document.h"

#include <QString>

#include <cstddef>
#include <vector>

namespace unprojector::gui {

// Looking around in a document. Each is undoable, and ignored where it would leave no valid picture or changes nothing.

/// @param mergeKey  see EditLabel
void setCamera(SceneDocument &document, const geometry::LookAt &camera, const QString &mergeKey = {});
void setProjection(SceneDocument &document, const geometry::Projection &projection, const QString &mergeKey = {});
void setView(SceneDocument &document, const geometry::LookAt &camera, const geometry::Projection &projection,
             const QString &mergeKey = {});
/// Shows all objects that are not hidden as large as the picture lets them be; without any object, the landmarks.
void fitAll(SceneDocument &document);
/// The same of one object, hidden or not. @pre index < objects().size()
void fitObject(SceneDocument &document, std::size_t index);
/// Back to the camera that the scene opened with.
void goHome(SceneDocument &document);
/// From a perspective to glOrtho and back, the picture equal at centerDistance.
void switchProjection(SceneDocument &document);

/// Shows these objects as another scene, from a home view in front and a little above that fits them.
void openObjects(SceneDocument &document, std::vector<scene::SceneObject> objects);
void openObjects(SceneDocument &document, std::vector<scene::SceneObject> objects, const geometry::LookAt &home);

/// Distance in front of the eye where two projections are to agree: that of the camera's centre, about which the picture
/// is made. A picked point that is nearer would make everything behind it larger than the view.
double centerDistance(const geometry::LookAt &camera);

/// The world point that navigation turns about with the pointer there: the surface; on the background the point of
/// the pointer's ray at the centre's distance; where nothing could be unprojected the camera's centre.
geometry::WorldPoint pivotOf(const geometry::LookAt &camera, const geometry::Result<unproject::Pick> &pick);

} // namespace unprojector::gui
