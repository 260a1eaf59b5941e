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

/// The world size of the camera symbol at a point of the view: a constant number of pixels, because
/// it is a symbol, not an object.
double cameraSignSize(const geometry::Setup &observer, const geometry::WorldPoint &point);

/// Draws over the objects in View from Outside: ground, clip planes, the view volume, the camera
/// symbol, the points and the ray. All calls need the OpenGL context current.
class ObserverOverlay : protected QOpenGLExtraFunctions {
public:
    /// @param document  outlives it
    explicit ObserverOverlay(const SceneDocument &document) : m_document(document) {}

    void initialize();
    void release();

    /// Draws onto a framebuffer that has the objects' colours and depths; doesn't change the
    /// depths.
    /// @param hotPlane       the plane that is dragged or can be dragged
    /// @param hasCameraAxes  whether the axes s, u and f are drawn at the camera symbol
    void draw(const ObserverPicture &p, std::optional<geometry::ClipPlane> hotPlane, bool hasCameraAxes);

private:
    void drawGround(const ObserverPicture &p);
    void drawClipPlanes(const ObserverPicture &p);
    void drawVolume(const ObserverPicture &p, std::optional<geometry::ClipPlane> hotPlane);
    void drawCamera(const ObserverPicture &p, bool hasAxes);
    void drawPick(const ObserverPicture &p);
    void drawWrong(const ObserverPicture &p);
    /// Draws lines, faint where they are hidden.
    void drawLines(const ObserverPicture &p, const std::vector<LineSegment> &lines, const glm::dmat4 &clipFromSource,
                   double widthLogical);

    const SceneDocument &m_document;
    LinePainter m_lines;
    FacePainter m_faces;
    PickPainter m_points;
};

} // namespace unprojector::gui
