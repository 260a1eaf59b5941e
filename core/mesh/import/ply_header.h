#pragma once

#include <bit>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace unprojector::mesh::reader {

enum class PlyFormat { Ascii, LittleEndian, BigEndian };
constexpr std::endian orderOf(PlyFormat format)
{
    return format == PlyFormat::BigEndian ? std::endian::big : std::endian::little;
}
enum class PlyType { Int8, Uint8, Int16, Uint16, Int32, Uint32, Float32, Float64 };

std::size_t byteCount(PlyType type);
inline bool isFloating(PlyType type)
{
    return type == PlyType::Float32 || type == PlyType::Float64;
}

struct PlyProperty {
    std::string name;
    PlyType type = PlyType::Float32;
    bool isList = false;
    PlyType countType = PlyType::Uint8; ///< of a list's length
};

struct PlyElement {
    std::string name;
    std::size_t count = 0;
    std::vector<PlyProperty> properties;

    /// The property's index, or -1.
    int find(std::string_view property) const;
    bool hasLists() const;
    /// The minimum number of bytes that one element takes in the file.
    std::size_t leastBytes(PlyFormat format) const;
};

struct PlyHeader {
    PlyFormat format = PlyFormat::Ascii;
    std::vector<PlyElement> elements;
    std::string textureFile; ///< from "comment TextureFile …", or empty
    std::size_t bodyOffset = 0;
    std::size_t bodyLine = 1;

    const PlyElement *find(std::string_view element) const;
};

/// Parses the header. Throws Damage with the line; also if the declared elements
/// cannot fit into the file.
PlyHeader readPlyHeader(std::string_view file);

} // namespace unprojector::mesh::reader
