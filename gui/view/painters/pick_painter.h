#pragma once

#include "core/geometry/spaces.h"

#include <QOpenGLExtraFunctions>
#include <QOpenGLShaderProgram>
#include <QOpenGLVertexArrayObject>

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>

#include <memory>

namespace unprojector::gui {

/// The marks of points, of constant size: of the picked one a ring with a dot at the point itself, of a click on the background
/// the ring alone, of the given one a square on its corner, of a wrong one a cross, of the right one to that a square.
class PickPainter : protected QOpenGLExtraFunctions {
public:
    enum class Mark { Picked, Given, Wrong, Right, Background };

    void initialize();
    void release();
    /// @param pixelRatio  device pixels per logical pixel: the ring keeps its logical size
    void draw(const geometry::WorldPoint &point, const glm::dmat4 &clipFromWorld, const glm::vec2 &viewportPixels,
              float pixelRatio, Mark mark = Mark::Picked);

private:
    std::unique_ptr<QOpenGLShaderProgram> m_program;
    QOpenGLVertexArrayObject m_vertexArray;
};

} // namespace unprojector::gui
