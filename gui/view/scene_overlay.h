#pragma once

#include "core/geometry/drawable.h"
#include "gui/document/scene_document.h"
#include "gui/view/painters/face_painter.h"
#include "gui/view/painters/line_painter.h"
#include "gui/view/painters/pick_painter.h"
#include "gui/view/painters/snap_shapes.h"
#include "gui/view/picture_options.h"

#include <QOpenGLExtraFunctions>
#include <QRectF>
#include <QSize>

#include <optional>
#include <vector>

namespace unprojector::gui {

/// What a click at a position would take of the meshes; nothing where that is the surface itself.
std::optional<SnapMark> snapMarkAt(const SceneDocument &document, const geometry::WidgetPoint &position);

/// What is drawn over the objects and cannot be clicked: ground, axes, clip planes, curves, the picked point, what a click would take,
/// the directions of the axes in the corner and the crosshair of the keys. All calls need the OpenGL context current.
class SceneOverlay : protected QOpenGLExtraFunctions {
public:
    void initialize();
    void release();

    /// Onto a framebuffer that has the objects' colours and depths; it leaves the depths as they are.
    /// @param marks      which of these are drawn
    /// @param crosshair  the pixel that keys pick at, where it is to be shown
    /// @param mark       what a click would take, where that is to be shown
    void draw(const SceneDocument &document, const PictureMarks &marks,
              const std::optional<geometry::DevicePixel> &crosshair, const std::optional<SnapMark> &mark);

    /// The side of the square, in device pixels, that the directions of the axes take in the lower left corner of the viewport; 0
    /// where that is too small.
    static int axesSide(const geometry::Drawable &drawn);
    /// The same square, logical pixels of the view.
    static QRectF axesBox(const geometry::Drawable &drawn);

private:
    void drawClipPlanes(const SceneDocument &document, const glm::dmat4 &clipFromWorld);
    /// The curves between placed points: where they are in sight, and faintly behind.
    void drawCurves(const SceneDocument &document, const glm::dmat4 &clipFromWorld);
    void drawPick(const SceneDocument &document, const glm::dmat4 &clipFromWorld);
    void drawMark(const SnapMark &mark, const geometry::Setup &g, const glm::dmat4 &clipFromWorld);
    /// In the corner of the viewport, where that is large enough.
    void drawAxes(const geometry::EyeFrame &frame, const geometry::Drawable &drawn);
    void drawCrosshair(const geometry::DevicePixel &pixel, const geometry::Surface &surface);

    LinePainter m_lines;
    FacePainter m_faces;
    PickPainter m_pick;
};

/// What letters keep clear of: the axes in the corner, and a widget over the upper right corner. Logical pixels.
/// @param corner  that the widget takes; empty: there is none
std::vector<QRectF> takenCorners(const SceneDocument &document, const QRectF &corner);

} // namespace unprojector::gui
