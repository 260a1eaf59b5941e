#include "gui/view/painters/face_painter.h"

#include "gui/view/painters/shader.h"

#include <cstddef>

namespace unprojector::gui {
namespace {

struct Vertex {
    glm::vec4 position; // clip space
    glm::vec4 color;
};

} // namespace

void FacePainter::initialize()
{
    initializeOpenGLFunctions();
    m_program = loadProgram(QStringLiteral("face"));
    m_vertexArray.create();
    m_buffer.create();
    m_vertexArray.bind();
    m_buffer.bind();
    const auto attribute = [this](GLuint index, std::size_t offset) {
        glEnableVertexAttribArray(index);
        glVertexAttribPointer(index, 4, GL_FLOAT, GL_FALSE, sizeof(Vertex), reinterpret_cast<const void *>(offset));
    };
    attribute(0, offsetof(Vertex, position));
    attribute(1, offsetof(Vertex, color));
    m_vertexArray.release();
    m_buffer.release();
}

void FacePainter::release()
{
    m_program.reset();
    m_vertexArray.destroy();
    m_buffer.destroy();
}

void FacePainter::draw(const std::vector<Face> &faces, const glm::dmat4 &clipFromSource)
{
    if (faces.empty())
        return;
    static constexpr std::array<std::size_t, 6> kTriangles{0, 1, 2, 0, 2, 3};
    std::vector<Vertex> vertices;
    vertices.reserve(faces.size() * 6);
    for (const Face &face : faces) {
        for (const std::size_t corner : kTriangles)
            vertices.push_back({glm::vec4(clipFromSource * glm::dvec4(face.corners[corner], 1.0)), face.color});
    }
    glEnable(GL_BLEND);
    glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    m_program->bind();
    m_vertexArray.bind();
    m_buffer.bind();
    m_buffer.allocate(vertices.data(), static_cast<int>(vertices.size() * sizeof(Vertex)));
    glDrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(vertices.size()));
    m_buffer.release();
    m_vertexArray.release();
    m_program->release();
    glDisable(GL_BLEND);
}

} // namespace unprojector::gui
