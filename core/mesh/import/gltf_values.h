#pragma once

#include "core/mesh/import/gltf_file.h"

#include <glm/vec3.hpp>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace unprojector::mesh::reader {

/// The elements of an accessor: so many numbers each. Patches of sparse ones are applied.
class GltfValues {
public:
    /// @param accessor  of the file
    /// Throws Failure (Malformed) where it goes beyond its bytes.
    GltfValues(GltfFile &file, const Json &accessor);

    std::size_t count() const { return m_count; }
    /// Numbers in an element: 3 of a VEC3.
    std::size_t components() const { return m_components; }
    bool areIntegers() const { return m_type != kFloat; }

    /// A number of an element; integers that stand for shares of one are turned into them.
    double at(std::size_t element, std::size_t component) const;
    /// The numbers of an element of three.
    /// @pre components() is 3
    glm::dvec3 vectorAt(std::size_t element) const { return {at(element, 0), at(element, 1), at(element, 2)}; }
    /// An integer of an element, as it is in the file.
    /// @pre areIntegers()
    std::int64_t integerAt(std::size_t element, std::size_t component) const;

private:
    static constexpr int kFloat = 5126;

    const std::uint8_t *placeOf(std::size_t element, std::size_t component) const
    {
        return m_bytes.data() + element * m_stride + component * m_componentBytes;
    }
    void readSparse(GltfFile &file, const Json &accessor, const Json &sparse);

    int m_type;
    std::size_t m_componentBytes;
    std::size_t m_components;
    std::size_t m_count;
    std::size_t m_stride;
    bool m_isNormalized = false;
    std::span<const std::uint8_t> m_bytes;
    std::vector<std::uint8_t> m_owned; ///< m_bytes of a sparse accessor, or of one without a view
};

} // namespace unprojector::mesh::reader
