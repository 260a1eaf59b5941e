#pragma once

#include "core/mesh/mesh.h"

#include <algorithm>
#include <cassert>
#include <cstdint>
#include <functional>
#include <limits>
#include <vector>

namespace unprojector::ray {

/// Numbers the triangles (or vertices, or points) of all meshes of a model consecutively from 0,
/// mesh by mesh.
class ElementNumbers {
public:
    struct Place {
        std::uint32_t mesh;
        std::uint32_t element; ///< index within the mesh
    };

    /// @param count  returns the number of elements of a mesh: &Mesh::triangleCount
    template <class Count>
    ElementNumbers(const std::vector<mesh::Mesh> &meshes, const Count &count)
    {
        std::size_t sum = 0;
        for (const mesh::Mesh &mesh : meshes) {
            m_starts.push_back(static_cast<std::uint32_t>(sum));
            sum += std::invoke(count, mesh);
        }
        assert(sum <= std::numeric_limits<std::uint32_t>::max());
        m_count = static_cast<std::uint32_t>(sum);
    }

    std::uint32_t count() const { return m_count; }
    std::uint32_t of(std::uint32_t mesh, std::uint32_t element) const { return m_starts[mesh] + element; }
    /// @pre number < count()
    Place place(std::uint32_t number) const
    {
        std::uint32_t mesh = 0;
        if (m_starts.size() > 1) { // the last that starts no later
            const auto after = std::upper_bound(m_starts.begin(), m_starts.end(), number);
            mesh = static_cast<std::uint32_t>(after - m_starts.begin()) - 1;
        }
        return {mesh, number - m_starts[mesh]};
    }

private:
    std::vector<std::uint32_t> m_starts; ///< the first number of each mesh
    std::uint32_t m_count = 0;
};

} // namespace unprojector::ray
