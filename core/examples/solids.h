#pragma once

#include "core/mesh/mesh.h"

#include <cstddef>

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

} // namespace unprojector::examples
