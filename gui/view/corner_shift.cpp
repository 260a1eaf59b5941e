#include "gui/view/corner_shift.h"

#include "core/unproject/depth_sample.h"
#include "gui/view/painters/gl_errors.h"
#include "gui/view/painters/shader.h"

#include <QOpenGLBuffer>
#include <QOpenGLShaderProgram>
#include <QOpenGLVertexArrayObject>
#include <QString>

#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <optional>

namespace unprojector::gui {
namespace {

constexpr int kSize = 32; ///< of the test image, pixels

/// A depth-only framebuffer, bound while this lives.
class DepthPicture {
public:
    explicit DepthPicture(QOpenGLExtraFunctions &gl) : m_gl(gl)
    {
        gl.glGetIntegerv(GL_FRAMEBUFFER_BINDING, &m_boundBefore);
        gl.glGetIntegerv(GL_VIEWPORT, m_viewportBefore.data());
        gl.glGenRenderbuffers(1, &m_depths);
        gl.glBindRenderbuffer(GL_RENDERBUFFER, m_depths);
        gl.glRenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT24, kSize, kSize);
        gl.glBindRenderbuffer(GL_RENDERBUFFER, 0);
        gl.glGenFramebuffers(1, &m_framebuffer);
        gl.glBindFramebuffer(GL_FRAMEBUFFER, m_framebuffer);
        gl.glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, m_depths);
        constexpr GLenum kNothing = GL_NONE;
        gl.glDrawBuffers(1, &kNothing);
        gl.glReadBuffer(GL_NONE);
        gl.glViewport(0, 0, kSize, kSize);
        gl.glDepthRangef(0.0f, 1.0f);
        gl.glDisable(GL_SCISSOR_TEST);
        gl.glEnable(GL_DEPTH_TEST); // without it no depth is written
        gl.glDepthFunc(GL_ALWAYS);
        gl.glDepthMask(GL_TRUE);
    }
    ~DepthPicture()
    {
        m_gl.glDisable(GL_DEPTH_TEST);
        m_gl.glBindFramebuffer(GL_FRAMEBUFFER, static_cast<GLuint>(m_boundBefore));
        m_gl.glViewport(m_viewportBefore[0], m_viewportBefore[1], m_viewportBefore[2], m_viewportBefore[3]);
        m_gl.glDeleteFramebuffers(1, &m_framebuffer);
        m_gl.glDeleteRenderbuffers(1, &m_depths);
    }
    DepthPicture(const DepthPicture &) = delete;
    DepthPicture &operator=(const DepthPicture &) = delete;

    bool isComplete() const { return m_gl.glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE; }
    double depthAt(int x, int y) const
    {
        std::uint32_t depth = 0;
        m_gl.glReadPixels(x, y, 1, 1, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT, &depth);
        return depth / 4294967295.0;
    }

private:
    QOpenGLExtraFunctions &m_gl;
    GLint m_boundBefore = 0;
    std::array<GLint, 4> m_viewportBefore{};
    GLuint m_framebuffer = 0, m_depths = 0;
};

std::optional<double> largestShift(QOpenGLExtraFunctions &gl, double grid)
{
    clearErrors(gl);
    const DepthPicture picture(gl);
    if (!picture.isComplete())
        return std::nullopt;
    const auto program = loadProgram(QStringLiteral("face"));
    QOpenGLVertexArrayObject vertexArray;
    QOpenGLBuffer buffer(QOpenGLBuffer::VertexBuffer);
    vertexArray.create();
    buffer.create();
    vertexArray.bind();
    buffer.bind();
    program->bind();
    gl.glEnableVertexAttribArray(0);
    gl.glVertexAttribPointer(0, 4, GL_FLOAT, GL_FALSE, 0, nullptr);
    gl.glVertexAttrib4f(1, 1.0f, 1.0f, 1.0f, 1.0f);

    // The depth rises by 0.8 over the width: 1/512 of a pixel is 800 steps of 24 bits.
    constexpr double kLow = 2.0, kHigh = 30.0, kSlope = 0.8 / kSize, kAtLeft = 0.1;
    constexpr int kPlaces = 12, kRead = 8;
    double largest = 0.0;
    for (int place = 1; place <= kPlaces; ++place) {
        // Spread over a pixel, and without a rounding in single precision.
        const double shift = std::floor(std::fmod(place * 0.6180339887, 1.0) * 16384.0) / 16384.0;
        std::array<float, 12> corners;
        for (std::size_t k = 0; k < 3; ++k) {
            const double x = (k == 1 ? kHigh : kLow) + shift, y = (k == 2 ? kHigh : kLow) + shift;
            const auto put = [grid](double position) {
                return grid > 0.0 ? std::round(position * grid) / grid : position;
            };
            corners[4 * k] = static_cast<float>(put(x) * 2.0 / kSize - 1.0);
            corners[4 * k + 1] = static_cast<float>(put(y) * 2.0 / kSize - 1.0);
            corners[4 * k + 2] = static_cast<float>((kAtLeft + kSlope * x) * 2.0 - 1.0);
            corners[4 * k + 3] = 1.0f;
        }
        buffer.allocate(corners.data(), static_cast<int>(sizeof corners));
        gl.glDrawArrays(GL_TRIANGLES, 0, 3);
        const double expected = kAtLeft + kSlope * (kRead + 0.5);
        largest = std::max(largest, std::abs(picture.depthAt(kRead, kRead) - expected) / kSlope);
    }
    program->release();
    buffer.release();
    vertexArray.release();
    return gl.glGetError() == GL_NO_ERROR ? std::optional(largest) : std::nullopt;
}

} // namespace

double measuredCornerShift(QOpenGLExtraFunctions &gl, double grid)
{
    const auto text = [&gl](GLenum name) { return QByteArray(reinterpret_cast<const char *>(gl.glGetString(name))); };
    static std::map<std::pair<QByteArray, double>, double> known;
    const auto [entry, isNew] = known.try_emplace({text(GL_VERSION) + text(GL_RENDERER), grid}, 0.0);
    if (isNew) {
        const std::optional<double> largest = largestShift(gl, grid);
        constexpr double kNothing = 0x1p-14;
        if (!largest)
            entry->second = unproject::kCornerShiftPixels;
        else if (*largest > kNothing)
            entry->second = std::exp2(std::ceil(std::log2(*largest)));
    }
    return entry->second;
}

} // namespace unprojector::gui
