#include "gui/view/painters/line_painter.h"

#include "gui/view/painters/shader.h"

#include <array>
#include <cstddef>
#include <utility>

namespace unprojector::gui {
namespace {

struct Vertex {
    glm::vec4 from; // clip space
    glm::vec4 to;   // clip space
    glm::vec4 color;
    glm::vec2 corner; // along the line: 0 or 1; across it: -1 or 1
};

/// Cuts off the part behind the near plane, which a division by w would fold over.
bool clipAtNearPlane(glm::dvec4 &from, glm::dvec4 &to)
{
    const double a = from.z + from.w;
    const double b = to.z + to.w;
    if (a < 0.0 && b < 0.0)
        return false;
    if (a < 0.0)
        from += (to - from) * (a / (a - b));
    else if (b < 0.0)
        to += (from - to) * (b / (b - a));
    return true;
}

} // namespace

void LinePainter::initialize()
{
    initializeOpenGLFunctions();
    m_program = loadProgram(QStringLiteral("line"));
    m_vertexArray.create();
    m_buffer.create();
    m_vertexArray.bind();
    m_buffer.bind();
    const auto attribute = [this](GLuint index, GLint size, std::size_t offset) {
        glEnableVertexAttribArray(index);
        glVertexAttribPointer(index, size, GL_FLOAT, GL_FALSE, sizeof(Vertex), reinterpret_cast<const void *>(offset));
    };
    attribute(0, 4, offsetof(Vertex, from));
    attribute(1, 4, offsetof(Vertex, to));
    attribute(2, 4, offsetof(Vertex, color));
    attribute(3, 2, offsetof(Vertex, corner));
    m_vertexArray.release();
    m_buffer.release();
}

void LinePainter::release()
{
    m_program.reset();
    m_vertexArray.destroy();
    m_buffer.destroy();
}

void LinePainter::draw(const std::vector<LineSegment> &segments, const glm::dmat4 &clipFromSource,
                       const glm::vec2 &viewportPixels, float widthPixels)
{
    static constexpr std::array<glm::vec2, 6> kCorners{{{0, -1}, {1, -1}, {1, 1}, {0, -1}, {1, 1}, {0, 1}}};
    std::vector<Vertex> vertices;
    vertices.reserve(segments.size() * kCorners.size());
    for (const LineSegment &segment : segments) {
        glm::dvec4 from = clipFromSource * glm::dvec4(segment.from, 1.0);
        glm::dvec4 to = clipFromSource * glm::dvec4(segment.to, 1.0);
        if (!clipAtNearPlane(from, to))
            continue;
        for (const glm::vec2 &corner : kCorners)
            vertices.push_back({glm::vec4(from), glm::vec4(to), segment.color, corner});
    }
    if (vertices.empty())
        return;

    glEnable(GL_BLEND);
    glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    m_program->bind();
    m_program->setUniformValue("viewportPixels", viewportPixels.x, viewportPixels.y);
    m_program->setUniformValue("halfWidth", widthPixels / 2.0f);
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
