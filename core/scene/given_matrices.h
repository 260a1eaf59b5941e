#pragma once

#include "core/scene/scene.h"

namespace unprojector::scene {

/// The settings with the projection and the camera of a picture. Matrices are kept as they are; the numbers of a projection
/// that comes as a matrix hold as they stand. The depth range stays, but for what reversed matrices make of it.
/// @return the errors of byParameters
geometry::Result<SceneSettings> withSetup(SceneSettings settings, geometry::Setup given);

/// Settings that the user changed to others: a depth range that was set by hand is not the one that a reversed matrix, which
/// has ended, had turned round.
SceneSettings afterChange(const SceneSettings &before, SceneSettings settings);

} // namespace unprojector::scene
