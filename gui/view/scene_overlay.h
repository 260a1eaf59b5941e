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

/// The mesh element that a click at a position would snap to; nothing if that is the surface
/// itself.
std::optional<SnapMark> snapMarkAt(const SceneDocument &document, const geometry::WidgetPoint &position);

/// Draws what lies over the objects and cannot be clicked: ground, axes, clip planes, curves, the
/// pick, the snap mark, the directions of the axes in the corner and the crosshair of the keys. All
/// calls need the OpenGL context current.
class SceneOverlay : protected QOpenGLExtraFunctions {
public:
    void initialize();
    void release();

    /// Draws onto a framebuffer that has the objects' colours and depths; doesn't change the
    /// depths.
    /// @param marks      which of these are drawn
    /// @param crosshair  the pixel that keys pick at, if it is shown
    /// @param mark       the snap mark, if it is shown
    void draw(const SceneDocument &document, const PictureMarks &marks,
              const std::optional<geometry::DevicePixel> &crosshair, const std::optional<SnapMark> &mark);

    /// The side of the square, in device pixels, for the directions of the axes in the lower left
    /// corner of the viewport; 0 if that is too small.
    static int axesSide(const geometry::Drawable &drawn);
    /// The same square in logical pixels of the view.
    static QRectF axesBox(const geometry::Drawable &drawn);

private:
    void drawClipPlanes(const SceneDocument &document, const glm::dmat4 &clipFromWorld);
    /// The curves between landmarks: solid where visible, faint behind surfaces.
    void drawCurves(const SceneDocument &document, const glm::dmat4 &clipFromWorld);
    void drawPick(const SceneDocument &document, const glm::dmat4 &clipFromWorld);
    void drawMark(const SnapMark &mark, const geometry::Setup &g, const glm::dmat4 &clipFromWorld);
    /// Draws the axes in the corner of the viewport, if it is large enough.
    void drawAxes(const geometry::EyeFrame &frame, const geometry::Drawable &drawn);
    void drawCrosshair(const geometry::DevicePixel &pixel, const geometry::Surface &surface);

    LinePainter m_lines;
    FacePainter m_faces;
    PickPainter m_pick;
};

/// The rectangles that letters avoid: the axes in the corner, and a widget over the upper right
/// corner. Logical pixels.
/// @param corner  of the widget; empty: there is none
std::vector<QRectF> takenCorners(const SceneDocument &document, const QRectF &corner);

} // namespace unprojector::gui
