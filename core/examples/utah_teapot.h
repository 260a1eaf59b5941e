#pragma once

#include "core/mesh/mesh.h"

#include <glm/vec3.hpp>

#include <array>
#include <vector>

namespace unprojector::examples {

/// The control points of a bicubic Bézier patch, [v][u].
using BezierPatch = std::array<std::array<glm::dvec3, 4>, 4>;

/// The teapot's 32 patches, y up, spout towards +x, handle towards -x, standing on y = 0. In every
/// patch dP/du x dP/dv points out of the pot. They are in the published order: four patches each of
/// rim, upper body, lower body, handle, spout, knob, lid and bottom.
///
/// Source: M. Newell, The Utilization of Procedure Models in Digital Image Synthesis, PhD thesis,
///         University of Utah, 1975: 28 patches, without the bottom. The bottom is from the list of
///         32 patches and 306 vertices (290 different points) published since F. Crow, The Origins
///         of the Teapot, IEEE CG&A 7(1), 1987. The heights are the usual ones, after J. Blinn
///         lowered the pot by the factor 1.3; multiply y by 1.3 for the proportions of Newell's
///         porcelain pot. The published list has z up: its (x, y, z) is (x, z, -y) here. Lengths
///         are the list's.
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

} // namespace unprojector::examples
