#pragma once

#include "core/geometry/camera.h"
#include "core/geometry/view_volume.h"
#include "gui/view/painters/face_painter.h"
#include "gui/view/painters/line_painter.h"

#include <array>
#include <vector>

namespace unprojector::gui {

// The shapes of the second view in addition to the scene: the first view's camera and its view
// volume.

/// Red, green, blue, opacity.
namespace observer_color {
constexpr glm::vec4 kNearPlane{0.08f, 0.40f, 0.80f, 1.0f};
constexpr glm::vec4 kFarPlane{0.85f, 0.44f, 0.04f, 1.0f};
constexpr glm::vec4 kRay{0.85f, 0.10f, 0.30f, 1.0f};
constexpr glm::vec4 kEdge{0.27f, 0.30f, 0.34f, 1.0f};
} // namespace observer_color

/// A camera of about one unit, eye axes: the eye at the origin, the body behind it.
std::vector<Face> cameraFaces(float opacity);
std::vector<LineSegment> cameraLines(float opacity);

/// Three lines from the origin with a letter at each tip; the letters face the observer.
/// @param tips      the ends of the lines
/// @param letters   of "sufxyz"
/// @param side, upward  the observer's axes in the space of the tips, half a letter's height long
std::vector<LineSegment> letteredAxes(const glm::dvec3 &origin, const std::array<glm::dvec3, 3> &tips,
                                      const char *letters, const glm::dvec3 &side, const glm::dvec3 &upward,
                                      float opacity);

/// The four edges from the near to the far plane.
std::vector<LineSegment> sideEdges(const std::array<geometry::EyePoint, 8> &corners);
/// The edges from the eye to the corners of the projection window.
std::vector<LineSegment> edgesFromEye(const std::array<geometry::EyePoint, 8> &corners, float opacity);

/// The corners of the near (0) or far (4) plane in order around it.
std::array<glm::dvec3, 4> planeCorners(const std::array<geometry::EyePoint, 8> &corners, std::size_t first);
std::vector<LineSegment> outline(const std::array<glm::dvec3, 4> &corners, const glm::vec4 &color);

/// The parts of the lines inside the planes.
std::vector<LineSegment> clippedLines(const std::vector<LineSegment> &lines, const std::array<glm::dvec4, 6> &planes,
                                      float opacity);

} // namespace unprojector::gui
