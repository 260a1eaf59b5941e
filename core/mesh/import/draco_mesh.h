#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace unprojector::mesh::reader {

inline constexpr const char *kDracoExtension = "KHR_draco_mesh_compression";

/// Returns whether the program is built with Draco.
bool hasDraco();

/// The numbers of vertices and triangles of a mesh.
struct DracoCounts {
    std::uint64_t vertices = 0;
    std::uint64_t triangles = 0;
};

/// A requested attribute: its number in the data, and its glTF component type.
struct DracoRequest {
    std::uint64_t id;
    int componentType;
};

/// The numbers of an attribute, vertex by vertex.
struct DracoValues {
    std::size_t components = 0;
    std::vector<std::uint8_t> bytes;
};

/// An unpacked list of triangles.
struct DracoMesh {
    DracoCounts counts;
    std::vector<std::uint8_t> indices;   ///< three of 32 bits a triangle
    std::vector<DracoValues> attributes; ///< in the order of the requests
};

/// Unpacks the data of KHR_draco_mesh_compression. Positions keep the rounding of the compression.
/// @param expected  by the file: damaged data could ask for any amount of memory
/// Throws Damage if the data are damaged or of another version than glTF's, or if they
/// lack the expected counts or attributes.
/// @pre hasDraco()
DracoMesh unpackedDraco(std::span<const std::uint8_t> bytes, std::span<const DracoRequest> requests,
                        const DracoCounts &expected);

} // namespace unprojector::mesh::reader
