#pragma once

#include "core/geometry/setup.h"

#include <glm/vec3.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace unprojector::geometry {

/// Finds the camera that shows points as large as the viewport allows, with the view direction of a
/// given one. A perspective moves as near as possible; a box gets the smallest window. The
/// projected positions of the points count, not the ball or box about all of them.
class Framing {
public:
    /// The share of the viewport's width or height that is filled.
    static constexpr double kFilled = 0.9;

    /// @pre the setup is valid and by parameters
    explicit Framing(const Setup &setup);

    void add(const WorldPoint &point);
    /// Adds the points of a list that the indices name, as triangles' indices do; without indices
    /// all points.
    /// @pre every index is below positions.size()
    void add(const glm::dmat4 &worldFromSource, std::span<const glm::vec3> positions,
             std::span<const std::uint32_t> indices);

    /// The setup whose camera, and for a box whose window, shows all added points, their middle in
    /// the middle of the view. A single point is shown with its surroundings, one world unit wide;
    /// without any point, the origin is. Near and far stay unchanged.
    Setup setup() const;

private:
    /// Measures of a point: along the view's axes, and from the edges of the filled part of the
    /// window.
    enum Measure { Side, Upward, Forward, FromLeft, FromRight, FromBottom, FromTop };
    static constexpr std::size_t kMeasures = 7;

    void add(const std::array<double, kMeasures> &measures);
    double middle(Measure measure) const { return (m_lowest[measure] + m_highest[measure]) / 2.0; }
    double extent(Measure measure) const { return m_highest[measure] - m_lowest[measure]; }
    double size() const;
    Setup framed() const;

    Setup m_setup;
    EyeFrame m_frame;
    glm::dvec2 m_low, m_high; ///< edges of the filled part, at a distance of 1; a box's are in eye units
    glm::dvec2 m_shear{0.0};  ///< shear of an oblique projection
    std::array<glm::dvec4, kMeasures> m_planes; ///< a measure of a world point is its product with one of these
    std::array<double, kMeasures> m_lowest, m_highest;
};

} // namespace unprojector::geometry
