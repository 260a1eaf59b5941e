#include "gui/view/painters/mesh_edges.h"

#include <algorithm>
#include <array>

namespace unprojector::gui {
namespace {

// Texture unit 0 has the image of the model.
constexpr unsigned kCoordinatesUnit = 1, kVertexNumbersUnit = 2;

} // namespace

void MeshEdges::initialize()
{
    initializeOpenGLFunctions();
    glGetIntegerv(GL_MAX_TEXTURE_BUFFER_SIZE, &m_mostNumbers);
    glGenTextures(1, &m_coordinates);
    glGenTextures(1, &m_vertexNumbers);
}

void MeshEdges::release()
{
    const std::array<GLuint, 2> textures{m_coordinates, m_vertexNumbers};
    glDeleteTextures(static_cast<GLsizei>(textures.size()), textures.data());
    m_coordinates = m_vertexNumbers = 0;
}

bool MeshEdges::canTake(const GpuMesh &mesh) const
{
    const std::size_t numbers = std::max(3 * mesh.source->positions.size(), mesh.elementCount);
    return numbers <= static_cast<std::size_t>(std::max(m_mostNumbers, 0));
}

QString MeshEdges::refusal(const QString &model) const
{
    return tr("The edges of %1 are not drawn: the graphics driver takes at most %2 numbers of a mesh.")
        .arg(model)
        .arg(m_mostNumbers);
}

void MeshEdges::bindTexture(unsigned unit, unsigned texture, GLenum format, unsigned buffer)
{
    glActiveTexture(GL_TEXTURE0 + unit);
    glBindTexture(GL_TEXTURE_BUFFER, texture);
    glTexBuffer(GL_TEXTURE_BUFFER, format, buffer);
    glActiveTexture(GL_TEXTURE0);
}

void MeshEdges::begin(QOpenGLShaderProgram &program, const GpuMesh &mesh, const glm::vec4 &viewport, double pixelRatio)
{
    bindTexture(kCoordinatesUnit, m_coordinates, GL_R32F, mesh.positionBuffer);
    program.setUniformValue("coordinates", static_cast<GLint>(kCoordinatesUnit));
    program.setUniformValue("vertexNumbers", static_cast<GLint>(kVertexNumbersUnit));
    program.setUniformValue("viewportMiddle", viewport.x + 0.5f * viewport.z, viewport.y + 0.5f * viewport.w);
    program.setUniformValue("viewportHalf", 0.5f * viewport.z, 0.5f * viewport.w);
    program.setUniformValue("edgeScale", static_cast<GLfloat>(std::max(1.0, pixelRatio)));
}

void MeshEdges::setPart(QOpenGLShaderProgram &program, unsigned vertexNumbers, std::size_t firstTriangle)
{
    if (vertexNumbers)
        bindTexture(kVertexNumbersUnit, m_vertexNumbers, GL_R32UI, vertexNumbers);
    program.setUniformValue("firstTriangle", static_cast<GLint>(firstTriangle));
}

void MeshEdges::end()
{
    for (const unsigned unit : {kCoordinatesUnit, kVertexNumbersUnit}) {
        glActiveTexture(GL_TEXTURE0 + unit);
        glBindTexture(GL_TEXTURE_BUFFER, 0);
    }
    glActiveTexture(GL_TEXTURE0);
}

} // namespace unprojector::gui
