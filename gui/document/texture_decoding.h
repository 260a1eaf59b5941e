#pragma once

#include "core/mesh/mesh.h"

#include <functional>

namespace unprojector::gui {

/// The largest width and height of a texture, in pixels; a larger one is scaled down.
constexpr int kMostTexturePixels = 8192;

/// Decodes a model's textures. Adds a note to the model for each one that is scaled down or cannot
/// be decoded. For any thread.
/// @param goOn  asked before each texture
void decodeTextures(mesh::Model &model, const std::function<bool()> &goOn);

} // namespace unprojector::gui
