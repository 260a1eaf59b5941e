#pragma once

#include "core/mesh/mesh.h"

namespace unprojector::examples {

/// A head for placing landmarks: no real person's, made of formulas. An egg of 0.78 × 1 × 0.95 half
/// axes, below the ears 1.05 instead of 1, with a face of soft bumps and hollows: brows, lids,
/// nose, lips, chin and ears. y up, looking along +z, about 2 high and 1.8 wide, the origin in the
/// middle between the ears. One closed smooth mesh, its left a mirror image of its right,
/// counter-clockwise from outside, uncoloured; its triangles are smallest at the nose.
mesh::Mesh headMesh();

} // namespace unprojector::examples
