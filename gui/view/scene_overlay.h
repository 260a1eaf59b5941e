#pragma once

#include "gui/document/scene_document.h"
#include "gui/painters/face_painter.h"
#include "gui/painters/line_painter.h"
#include "gui/painters/pick_painter.h"

#include <QOpenGLExtraFunctions>

namespace unprojector::gui {

/// What is drawn over the objects and cannot be clicked: ground, axes, clip planes, the picked point and the directions
/// of the axes in the corner. All calls need the OpenGL context current.
class SceneOverlay : protected QOpenGLExtraFunctions {
public:
    void initialize();
    void release();

    /// Onto a framebuffer that has the objects' colours and depths; it leaves the depths as they are.
    void draw(const SceneDocument &document);

private:
    void drawClipPlanes(const SceneDocument &document, const glm::dmat4 &clipFromWorld);
    void drawPick(const SceneDocument &document, const glm::dmat4 &clipFromWorld);
    void drawAxes(const EyeFrame &frame, const Surface &surface);

    LinePainter m_lines;
    FacePainter m_faces;
    PickPainter m_pick;
};

} // namespace unprojector::gui
