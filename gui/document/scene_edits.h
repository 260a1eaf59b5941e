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

/// A camera given as matrices or by another program; empty parts stay as they are.
struct GivenCamera {
    std::optional<geometry::Lens> projection{};
    std::optional<glm::dmat4> eyeFromWorld{};
    std::optional<geometry::Viewport> viewport{};
    std::optional<geometry::Surface> size{}; ///< of an image: the view gets it, and the viewport fills it
};

/// The settings with a given camera (withSetup).
/// @param setup  of these settings
/// @return the errors of byParameters
geometry::Result<scene::SceneSettings> withCamera(const scene::SceneSettings &settings, geometry::Setup setup,
                                                  const GivenCamera &given);

/// Sets a given camera.
/// @return the errors of withCamera and setupOf
geometry::Check editCamera(SceneDocument &document, const GivenCamera &given, const EditLabel &label);
/// Sets a projection, a view or both, given as matrices.
inline geometry::Check editMatrices(SceneDocument &document, const std::optional<geometry::Lens> &projection,
                                    const std::optional<glm::dmat4> &eyeFromWorld, const EditLabel &label)
{
    return editCamera(document, {projection, eyeFromWorld}, label);
}

} // namespace unprojector::gui
