#pragma once

#include <cstddef>
#include <cstdint>
#include <mutex>
#include <vector>

namespace unprojector::mesh {

struct Mesh;

/// A hash of a vertex's exact position.
std::uint64_t placeHash(const Mesh &mesh, std::size_t vertex);

/// Numbers a mesh's vertices by position, in the order of first occurrence. Uses all cores.
/// @param numbers  one a vertex
/// @return the number of different positions
std::size_t numberPlaces(const Mesh &mesh, std::vector<std::uint32_t> &numbers);

/// The numbers of a mesh that is too large to merge its equal vertices at import, computed on first
/// use. Many threads may ask at once.
class SoupNumbers {
public:
    /// @param mesh  the same at every call
    const std::vector<std::uint32_t> &of(const Mesh &mesh) { return numbered(mesh).m_numbers; }
    std::size_t placeCount(const Mesh &mesh) { return numbered(mesh).m_count; }

private:
    SoupNumbers &numbered(const Mesh &mesh)
    {
        std::call_once(m_once, [&] { m_count = numberPlaces(mesh, m_numbers); });
        return *this;
    }

    std::once_flag m_once;
    std::vector<std::uint32_t> m_numbers;
    std::size_t m_count = 0;
};

} // namespace unprojector::mesh
