#pragma once

#include "core/cameras/foreign_camera.h"
#include "core/geometry/setup.h"

#include <optional>
#include <string>

namespace unprojector::cli {

/// A lens that distorts the image of a scene's pinhole.
struct SceneLens {
    cameras::Distortion distortion;
    cameras::Intrinsics pinhole; ///< K of the scene
};

/// The lens of --distortion: coefficients "k1,k2,p1,p2,k3", or a file of a camera that has them.
/// Errors, and a K that differs from the scene's, are printed on stderr.
/// @param scene  its name, for messages
std::optional<SceneLens> sceneLens(const std::string &option, const geometry::Setup &setup, const std::string &scene);

} // namespace unprojector::cli
