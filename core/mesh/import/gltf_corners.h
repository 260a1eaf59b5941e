#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace unprojector::mesh::reader {

/// The assembly of a glTF primitive's vertices into triangles, lines or points.
class GltfCorners {
public:
    enum Mode { Points = 0, Lines, LineLoop, LineStrip, Triangles, TriangleStrip, TriangleFan };

    GltfCorners(std::uint64_t mode, std::size_t count) : m_mode(static_cast<Mode>(mode)), m_count(count) {}

    bool areTriangles() const { return m_mode >= Triangles; }
    std::size_t triangleCount() const
    {
        return !areTriangles() || m_count < 3 ? 0 : m_mode == Triangles ? m_count / 3 : m_count - 2;
    }
    /// The number of corners at the end that make no whole triangle.
    std::size_t leftOver() const
    {
        const std::size_t triangles = triangleCount();
        const std::size_t used = m_mode == Triangles ? 3 * triangles : triangles > 0 ? triangles + 2 : 0;
        return areTriangles() ? m_count - used : 0;
    }
    /// The number of points or lines.
    std::size_t otherCount() const
    {
        switch (m_mode) {
        case Points:
        case LineLoop: return m_count;
        case Lines: return m_count / 2;
        case LineStrip: return m_count > 0 ? m_count - 1 : 0;
        default: return 0;
        }
    }
    std::array<std::size_t, 3> ofTriangle(std::size_t t) const
    {
        if (m_mode == Triangles)
            return {3 * t, 3 * t + 1, 3 * t + 2};
        if (m_mode == TriangleFan)
            return {t + 1, t + 2, 0};
        // Every second triangle of a strip winds the other way round.
        return t % 2 == 0 ? std::array{t, t + 1, t + 2} : std::array{t, t + 2, t + 1};
    }

private:
    Mode m_mode;
    std::size_t m_count;
};

} // namespace unprojector::mesh::reader
