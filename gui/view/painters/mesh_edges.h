#pragma once

#include "gui/view/painters/gpu_model.h"

#include <QCoreApplication>
#include <QOpenGLExtraFunctions>
#include <QOpenGLShaderProgram>
#include <QString>

#include <glm/vec4.hpp>

namespace unprojector::gui {

/// Gives the mesh shader the corners of its triangles, as textures over the mesh's own buffers: a
/// pixel then computes its distance to the edges. That takes no more memory, and its time depends
/// on the pixels, not on the number of triangles. All calls need the OpenGL context current.
class MeshEdges : protected QOpenGLExtraFunctions {
    Q_DECLARE_TR_FUNCTIONS(unprojector::gui::MeshEdges)
public:
    void initialize();
    void release();

    /// Returns whether the driver takes textures as large as this mesh's buffers.
    bool canTake(const GpuMesh &mesh) const;
    /// A sentence for the user on a mesh that is too large.
    QString refusal(const QString &model) const;

    /// Sets the shader's corners and sizes.
    /// @param program  bound, with the edges
    /// @param viewport  x, y, width, height, device pixels
    /// @param pixelRatio  lines are one logical pixel wide
    void begin(QOpenGLShaderProgram &program, const GpuMesh &mesh, const glm::vec4 &viewport, double pixelRatio);
    /// Sets the drawn part.
    /// @param vertexNumbers  name of the buffer that is drawn from; 0: vertices are in their order
    /// @param firstTriangle  in it
    void setPart(QOpenGLShaderProgram &program, unsigned vertexNumbers, std::size_t firstTriangle);
    void end();

private:
    void bindTexture(unsigned unit, unsigned texture, GLenum format, unsigned buffer);

    GLint m_mostNumbers = 0; ///< in one texture
    unsigned m_coordinates = 0, m_vertexNumbers = 0;
};

} // namespace unprojector::gui
