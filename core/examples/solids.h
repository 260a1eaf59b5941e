#pragma once

#include "core/mesh/mesh.h"

#include <glm/vec3.hpp>

#include <array>
#include <cstddef>
#include <vector>

namespace unprojector::examples {

// Solids centred on their origin, closed, counter-clockwise from outside, uncoloured. Lengths and
// radii must be positive. The vertices lie on the ideal surface, so a rounded solid's volume is a
// little less than the ideal one's.

/// The number of vertices of each face of cubeMesh; they follow each other face by face.
inline constexpr std::size_t kVerticesPerCubeFace = 4;

/// A cube with flat normals: 6 faces in the order +x, -x, +y, -y, +z, -z, 12 triangles.
mesh::Mesh cubeMesh(double edgeLength);

/// A torus around the z axis, smooth: 2 ringSegments tubeSegments triangles. If ringSegments is a
/// multiple of 4, vertices lie on the extremes of x and y. ringRadius, to the middle of the tube,
/// must exceed tubeRadius; at least 3 segments each.
mesh::Mesh torusMesh(double ringRadius, double tubeRadius, int ringSegments, int tubeSegments);

/// A sphere, smooth: an icosahedron whose triangles are split in four `subdivisions` times. Its 20
/// * 4^subdivisions triangles have about the same size; unlike a grid of longitudes it has no
/// poles. Vertices lie on all six extremes from one subdivision on.
mesh::Mesh sphereMesh(double radius, int subdivisions);

/// A cone, apex up: apex (0, height / 2, 0), base a disc in y = -height / 2. A smooth side and a
/// flat base; 2 segments triangles, at least 3 segments.
mesh::Mesh coneMesh(double baseRadius, double height, int segments);

/// The control points of a bicubic Bézier patch, [v][u].
using BezierPatch = std::array<std::array<glm::dvec3, 4>, 4>;

/// The teapot's 32 patches, y up, spout towards +x, handle towards -x, standing on y = 0. In every
/// patch dP/du x dP/dv points out of the pot. They are in the published order: four patches each of
/// rim, upper body, lower body, handle, spout, knob, lid and bottom.
///
/// Source: named in resources/examples/utah_teapot.json
std::vector<BezierPatch> utahTeapotPatches();

/// The teapot in triangles: every patch is split into divisionsPerSide^2 quadrangles,
/// counter-clockwise from outside, with the surface's own normals. At the knob's top and the
/// bottom's centre a whole patch edge is one point and dP/du is zero. There the normal is the
/// limit, straight up and straight down, and triangles without area are left out.
///
/// The pot is not closed, as in 1975: there is a slit of 0.1 between lid and rim, the handle and
/// the spout end open inside the body, and the spout's mouth is open. Elsewhere neighbouring
/// patches meet in the same floats.
///
/// @param divisionsPerSide  at least 2, or tubes would be flat; 10 gives 6320 triangles (64 n^2 - 8
///         n)
mesh::Mesh utahTeapotMesh(int divisionsPerSide = 10);

/// A head for placing landmarks: no real person's, made of formulas. An egg of 0.78 × 1 × 0.95 half
/// axes, below the ears 1.05 instead of 1, with a face of soft bumps and hollows: brows, lids,
/// nose, lips, chin and ears. y up, looking along +z, about 2 high and 1.8 wide, the origin in the
/// middle between the ears. One closed smooth mesh, its left a mirror image of its right,
/// counter-clockwise from outside, uncoloured; its triangles are smallest at the nose.
mesh::Mesh headMesh();

} // namespace unprojector::examples
