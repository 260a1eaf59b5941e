#pragma once

#include "core/mesh/import/ply_body.h"
#include "core/mesh/import/ply_header.h"
#include "core/mesh/mesh.h"

#include <array>
#include <vector>

namespace unprojector::mesh::reader {

/// The properties that hold an element's colour.
struct PlyColor {
    explicit PlyColor(const PlyElement &element);
    bool isComplete() const { return channels[0] >= 0 && channels[1] >= 0 && channels[2] >= 0; }
    /// @param values  of the element, one a property
    glm::u8vec4 color(const PlyElement &element, const std::vector<double> &values) const;

    std::array<int, 4> channels; ///< indices of properties, or -1
};

/// Reads a PLY file's vertices into a mesh about an origin that keeps their digits.
/// Throws Damage.
void readPlyVertices(const PlyElement &element, PlyBody &body, PlyFormat format, Mesh &mesh, base::Reporter &progress);

} // namespace unprojector::mesh::reader
