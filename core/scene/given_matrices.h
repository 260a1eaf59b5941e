#pragma once

#include "core/scene/scene.h"

#include <optional>

namespace unprojector::scene {

/// The matrix that a scene's projection is given by; null where it is given by parameters, or has been changed since.
const MatrixProjection *givenProjection(const SceneSettings &settings);
/// The same of the view: eyeFromWorld.
const glm::dmat4 *givenView(const SceneSettings &settings);

/// Takes a projection, a view or both from matrices, which the settings keep as they are. What is none stays; the
/// projection's numbers then hold as they stand.
/// @param picture  that the settings have in their window
/// @return the errors of byParameters
Result<SceneSettings> withMatrices(SceneSettings settings, Picture picture,
                                   const std::optional<MatrixProjection> &projection,
                                   const std::optional<glm::dmat4> &eyeFromWorld);

/// Settings that the user changed to others: a depth range that was set by hand is not the one that a reversed matrix, which
/// no longer counts, had turned round, so that matrix is forgotten.
SceneSettings afterChange(const SceneSettings &before, SceneSettings settings);

} // namespace unprojector::scene
