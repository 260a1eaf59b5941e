#pragma once

#include "core/scene/scene.h"

#include <optional>

namespace unprojector::scene {

/// The settings with the projection and the camera of a setup. Matrices are kept unchanged. A
/// projection given as a matrix or as a pinhole turns off fitting to the viewport and the objects. The depth range
/// stays, except that a reversed matrix flips it.
/// @return the errors of byParameters
geometry::Result<SceneSettings> withSetup(SceneSettings settings, geometry::Setup given);

/// The settings after a change by the user. A depth range that the user set is no longer marked as
/// flipped by a reversed matrix that has been replaced.
SceneSettings afterChange(const SceneSettings &before, SceneSettings settings);

/// The projection that another program gave: a matrix, or a camera matrix as a pinhole.
std::optional<geometry::Lens> givenLens(const SceneSettings &settings);

} // namespace unprojector::scene
