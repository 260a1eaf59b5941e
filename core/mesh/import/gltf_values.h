#pragma once

#include "core/mesh/import/gltf_file.h"

#include <glm/vec3.hpp>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace unprojector::mesh::reader {

/// The elements of an accessor, each with components() numbers. Sparse patches are applied.
class GltfValues {
public:
    /// @param accessor  of the file
    /// Throws Damage if it exceeds its bytes.
    GltfValues(GltfFile &file, const Json &accessor);

    std::size_t count() const { return m_count; }
    /// The number of components of an element: 3 for a VEC3.
    std::size_t components() const { return m_components; }
    bool areIntegers() const { return m_type != kFloat; }

    /// A number of an element; normalized integers are converted to their share of 1.
    double at(std::size_t element, std::size_t component) const;
    /// The three numbers of an element.
    /// @pre components() is 3
    glm::dvec3 vectorAt(std::size_t element) const { return {at(element, 0), at(element, 1), at(element, 2)}; }
    /// An integer of an element, as in the file.
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
    std::vector<std::uint8_t> m_owned; ///< backs m_bytes for a sparse accessor, or one without a view
};

} // namespace unprojector::mesh::reader
