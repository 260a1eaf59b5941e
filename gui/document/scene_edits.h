#pragma once

#include "gui/document/object_names.h"
#include "gui/document/scene_document.h"

#include <QString>

#include <cstddef>
#include <optional>
#include <vector>

namespace unprojector::gui {

// Undoable edits of a document that take more than setting a member. An index refers to its
// objects.

/// Appends objects and makes their names unique. If not all are visible, the view shows everything
/// afterwards, near and far planes included. The pick stays.
/// @return the errors of setupOf; then nothing changed
geometry::Check addObjects(SceneDocument &document, std::vector<scene::SceneObject> objects);
geometry::Check removeObject(SceneDocument &document, std::size_t index);
/// Moves an object to another index of the list.
geometry::Check moveObject(SceneDocument &document, std::size_t from, std::size_t to);
geometry::Check setObjectHidden(SceneDocument &document, std::size_t index, bool isHidden);
geometry::Check showAllObjects(SceneDocument &document);
bool hasHiddenObjects(const scene::Scene &scene);
/// @param name  is trimmed; see faultOf
/// @return what is wrong with the name; then nothing changed
NameFault renameObject(SceneDocument &document, std::size_t index, const QString &name);

/// Replaces all landmarks. For edits of single ones see SceneLandmarks.
geometry::Check editLandmarks(SceneDocument &document, std::vector<landmarks::Landmark> landmarks,
                              const EditLabel &label);
geometry::Check editLandmarkSet(SceneDocument &document, landmarks::LandmarkSet set, const EditLabel &label);

/// Sets a projection, a view or both, from matrices or another program's camera (withSetup), and a viewport. With the
/// size of an image, the view gets this size in device pixels, and the viewport fills it.
/// @return the errors of byParameters and setupOf
geometry::Check editMatrices(SceneDocument &document, const std::optional<geometry::Lens> &projection,
                             const std::optional<glm::dmat4> &eyeFromWorld, const EditLabel &label,
                             const std::optional<geometry::Viewport> &viewport = std::nullopt,
                             const std::optional<geometry::Surface> &size = std::nullopt);

} // namespace unprojector::gui
