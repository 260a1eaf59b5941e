#pragma once

#include <glm/vec3.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace unprojector::mesh_import {

/// Appends the triangles of a simple polygon, which may be concave and need not be quite flat, as corners counted
/// from 0 within the polygon. The winding is kept; a polygon of n corners always gives n - 2 triangles.
/// @param corners  fewer than three give nothing
void triangulatePolygon(std::span<const glm::vec3> corners, std::vector<std::uint32_t> &triangles);

} // namespace unprojector::mesh_import
