#pragma once

#include "core/geometry/setup.h"

#include <glm/vec3.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace unprojector::geometry {

/// Finds the camera that shows points as large as the viewport lets it, looking where a given one looks: as near as can be
/// in a perspective, with the smallest window in a box. What counts is where each point is seen, not the ball or the box
/// about all of them.
class Framing {
public:
    /// How much of the viewport is filled: of its width or of its height.
    static constexpr double kFilled = 0.9;

    /// @pre the setup is valid and by parameters
    explicit Framing(const Setup &setup);

    void add(const WorldPoint &point);
    /// Those points of a list that are named by the indices, as those of triangles are; all of them without indices.
    /// @pre every index is below positions.size()
    void add(const glm::dmat4 &worldFromSource, std::span<const glm::vec3> positions,
             std::span<const std::uint32_t> indices);

    /// The picture with the camera, and in a box with the window, that shows all points that were added, their middle in
    /// its middle. Of a single point it shows the surroundings, one world unit wide, and without any those of the origin.
    /// Near and far stay as they are.
    Setup setup() const;

private:
    /// What is measured of a point: along the picture's axes, and from the rims of the filled part of the window.
    enum Measure { Side, Upward, Forward, FromLeft, FromRight, FromBottom, FromTop };
    static constexpr std::size_t kMeasures = 7;

    void add(const std::array<double, kMeasures> &measures);
    double middle(Measure measure) const { return (m_lowest[measure] + m_highest[measure]) / 2.0; }
    double extent(Measure measure) const { return m_highest[measure] - m_lowest[measure]; }
    double size() const;
    Setup framed() const;

    Setup m_setup;
    EyeFrame m_frame;
    glm::dvec2 m_low, m_high;                   ///< rims of the filled part, at a distance of 1; of a box in eye units
    glm::dvec2 m_shear{0.0};                    ///< of an oblique projection
    std::array<glm::dvec4, kMeasures> m_planes; ///< a measure of a world point is its product with one of these
    std::array<double, kMeasures> m_lowest, m_highest;
};

} // namespace unprojector::geometry
