#pragma once

#include "core/geometry/spaces.h"

#include <QOpenGLExtraFunctions>
#include <QOpenGLShaderProgram>
#include <QOpenGLVertexArrayObject>

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>

#include <memory>

namespace unprojector::gui {

/// The marks of points, of constant size. Picked: a ring with a dot. Background: the ring alone.
/// Given, the user's point: a square on its corner. Wrong: a cross. Right: a square.
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
