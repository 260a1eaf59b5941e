#pragma once

#include "gui/document/scene_document.h"
#include "gui/view/observer_picture.h"
#include "gui/view/painters/face_painter.h"
#include "gui/view/painters/line_painter.h"
#include "gui/view/painters/pick_painter.h"

#include <QOpenGLExtraFunctions>

#include <optional>
#include <vector>

namespace unprojector::gui {

/// World size of the camera's sign at a point of the picture: always as many pixels, because it is a sign, not a thing.
double cameraSignSize(const geometry::Setup &observer, const geometry::WorldPoint &point);

/// What View from Outside draws over the objects: ground, clip planes, the view volume, the camera's sign, the points and the
/// ray. All calls need the OpenGL context current.
class ObserverOverlay : protected QOpenGLExtraFunctions {
public:
    /// @param document  outlives it
    explicit ObserverOverlay(const SceneDocument &document) : m_document(document) {}

    void initialize();
    void release();

    /// Onto a framebuffer that has the objects' colours and depths; it leaves the depths as they are.
    /// @param hotPlane       the plane that a hand drags or may drag
    /// @param hasCameraAxes  whether the axes s, u and f stand at the camera's sign
    void draw(const ObserverPicture &p, std::optional<geometry::ClipPlane> hotPlane, bool hasCameraAxes);

private:
    void drawGround(const ObserverPicture &p);
    void drawClipPlanes(const ObserverPicture &p);
    void drawVolume(const ObserverPicture &p, std::optional<geometry::ClipPlane> hotPlane);
    void drawCamera(const ObserverPicture &p, bool hasAxes);
    void drawPick(const ObserverPicture &p);
    void drawWrong(const ObserverPicture &p);
    /// Where they are hidden, the lines show faintly.
    void drawLines(const ObserverPicture &p, const std::vector<LineSegment> &lines, const glm::dmat4 &clipFromSource,
                   double widthLogical);

    const SceneDocument &m_document;
    LinePainter m_lines;
    FacePainter m_faces;
    PickPainter m_points;
};

} // namespace unprojector::gui
