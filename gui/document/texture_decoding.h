#pragma once

#include "core/mesh/mesh.h"

#include <functional>

namespace unprojector::gui {

/// A texture is at most so wide and so high, in pixels; a larger one is scaled down.
constexpr int kMostTexturePixels = 8192;

/// Decodes a model's textures. What is scaled down or cannot be decoded is added to the model's notes. For any thread.
/// @param goOn  asked before each texture
void decodeTextures(mesh::Model &model, const std::function<bool()> &goOn);

} // namespace unprojector::gui
