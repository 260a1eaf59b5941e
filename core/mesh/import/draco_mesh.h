#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace unprojector::mesh::reader {

inline constexpr const char *kDracoExtension = "KHR_draco_mesh_compression";

/// Whether the program is built with Draco.
bool hasDraco();

/// How many vertices and triangles a mesh has.
struct DracoCounts {
    std::uint64_t vertices = 0;
    std::uint64_t triangles = 0;
};

/// An attribute that is asked for: its number in the data, and the type of its numbers as glTF has it.
struct DracoRequest {
    std::uint64_t id;
    int componentType;
};

/// The numbers of an attribute, for each vertex in turn.
struct DracoValues {
    std::size_t components = 0;
    std::vector<std::uint8_t> bytes;
};

/// A list of triangles that was unpacked.
struct DracoMesh {
    DracoCounts counts;
    std::vector<std::uint8_t> indices;   ///< three of 32 bits a triangle
    std::vector<DracoValues> attributes; ///< in the order of the requests
};

/// Unpacks the data of KHR_draco_mesh_compression. Positions that were rounded when they were packed are as Draco makes them.
/// @param expected  by the file: damaged data could ask for any amount of memory
/// Throws Failure (Malformed) where they are damaged, are not of the version that glTF has, or do not have the counts that
/// are expected, or the attributes.
/// @pre hasDraco()
DracoMesh unpackedDraco(std::span<const std::uint8_t> bytes, std::span<const DracoRequest> requests,
                        const DracoCounts &expected);

} // namespace unprojector::mesh::reader
