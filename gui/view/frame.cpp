#include "gui/view/frame.h"

#include "gui/painters/gl_errors.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <cstring>

namespace unprojector::gui {
namespace {

constexpr std::array<GLenum, 2> kColorsAlone{GL_COLOR_ATTACHMENT0, GL_NONE};
constexpr std::array<GLenum, 2> kColorsAndObjects{GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT1};

} // namespace

void Frame::initialize()
{
    initializeOpenGLFunctions();
    glGenBuffers(1, &m_requestBuffer);
    glBindBuffer(GL_PIXEL_PACK_BUFFER, m_requestBuffer);
    glBufferData(GL_PIXEL_PACK_BUFFER, sizeof(Raw), nullptr, GL_STREAM_READ);
    glBindBuffer(GL_PIXEL_PACK_BUFFER, 0);
    // The smallest framebuffer tells what the driver has.
    m_ids = ObjectIds::Integers;
    if (qgetenv("UNPROJECTOR_OBJECT_IDS") == "colors" || !allocate(1, 1))
        m_ids = ObjectIds::Colors;
    releaseTextures();
}

void Frame::release()
{
    dropRequest();
    releaseTextures();
    glDeleteBuffers(1, &m_requestBuffer);
    m_requestBuffer = 0;
}

void Frame::releaseTextures()
{
    const std::array<GLuint, 3> textures{m_colors, m_objects, m_depths};
    glDeleteTextures(static_cast<GLsizei>(textures.size()), textures.data());
    glDeleteFramebuffers(1, &m_framebuffer);
    m_framebuffer = m_colors = m_objects = m_depths = 0;
    m_widthPixels = m_heightPixels = 0;
    m_picture.reset();
}

bool Frame::allocate(int widthPixels, int heightPixels)
{
    if (m_framebuffer && m_widthPixels == widthPixels && m_heightPixels == heightPixels)
        return true;
    releaseTextures();
    clearErrors(*this);
    GLint boundBefore = 0;
    glGetIntegerv(GL_FRAMEBUFFER_BINDING, &boundBefore);
    glGenFramebuffers(1, &m_framebuffer);
    glBindFramebuffer(GL_FRAMEBUFFER, m_framebuffer);
    const auto attached = [&](GLenum attachment, GLint internalFormat, GLenum format, GLenum type, GLint filter) {
        GLuint texture = 0;
        glGenTextures(1, &texture);
        glBindTexture(GL_TEXTURE_2D, texture);
        glTexImage2D(GL_TEXTURE_2D, 0, internalFormat, widthPixels, heightPixels, 0, format, type, nullptr);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, filter);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, filter);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
        glFramebufferTexture2D(GL_FRAMEBUFFER, attachment, GL_TEXTURE_2D, texture, 0);
        return texture;
    };
    m_colors = attached(GL_COLOR_ATTACHMENT0, GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE, GL_LINEAR);
    m_objects = m_ids == ObjectIds::Integers
                    ? attached(GL_COLOR_ATTACHMENT1, GL_R32UI, GL_RED_INTEGER, GL_UNSIGNED_INT, GL_NEAREST)
                    : attached(GL_COLOR_ATTACHMENT1, GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE, GL_NEAREST);
    m_depths = attached(GL_DEPTH_ATTACHMENT, GL_DEPTH_COMPONENT24, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT, GL_NEAREST);
    glBindTexture(GL_TEXTURE_2D, 0);
    glDrawBuffers(2, kColorsAndObjects.data());
    GLint depthBits = 0;
    const bool isComplete = glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
    if (isComplete) {
        glGetFramebufferAttachmentParameteriv(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_FRAMEBUFFER_ATTACHMENT_DEPTH_SIZE,
                                              &depthBits);
    }
    glBindFramebuffer(GL_FRAMEBUFFER, static_cast<GLuint>(boundBefore));
    if (!isComplete || glGetError() != GL_NO_ERROR) {
        releaseTextures(); // one that cannot be drawn into is not kept
        clearErrors(*this);
        return false;
    }
    m_depthBits = depthBits > 0 ? depthBits : 24;
    m_widthPixels = widthPixels;
    m_heightPixels = heightPixels;
    return true;
}

/// Binds the frame and sets all that drawing into it needs; what else is drawn in between sets its own.
void Frame::bind()
{
    glGetIntegerv(GL_FRAMEBUFFER_BINDING, &m_boundBefore);
    glBindFramebuffer(GL_FRAMEBUFFER, m_framebuffer);
    glDisable(GL_SCISSOR_TEST);
    glDisable(GL_BLEND);
    glDisable(GL_DITHER); // an object's number must come out as it went in
    glDepthMask(GL_TRUE);
    glViewport(m_begun->x, m_begun->y, m_begun->width, m_begun->height);
    glDepthRangef(m_begun->depthAtNear, m_begun->depthAtFar);
}

bool Frame::begin(const Drawable &drawable)
{
    dropRequest();
    m_picture.reset();
    if (!allocate(drawable.picture.surface.widthPixels, drawable.picture.surface.heightPixels))
        return false;
    m_begun = drawable;
    m_isPaused = false;
    bind();
    constexpr std::array<GLfloat, 4> kAround{0.80f, 0.82f, 0.84f, 1.0f};
    glDrawBuffers(2, kColorsAndObjects.data());
    glClearBufferfv(GL_COLOR, 0, kAround.data());
    if (m_ids == ObjectIds::Integers)
        glClearBufferuiv(GL_COLOR, 1, std::array<GLuint, 4>{}.data());
    else
        glClearBufferfv(GL_COLOR, 1, std::array<GLfloat, 4>{}.data());
    glClearBufferfv(GL_DEPTH, 0, &drawable.depthAtFar);
    glDrawBuffers(2, kColorsAlone.data());
    glDisable(GL_DEPTH_TEST);
    return true;
}

void Frame::beginObjects()
{
    if (m_isPaused) {
        m_isPaused = false;
        bind();
    }
    glDrawBuffers(2, kColorsAndObjects.data());
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(m_begun->depthAtNear < m_begun->depthAtFar ? GL_LESS : GL_GREATER);
}

void Frame::pause()
{
    glDisable(GL_DEPTH_TEST);
    glBindFramebuffer(GL_FRAMEBUFFER, static_cast<GLuint>(m_boundBefore));
    m_isPaused = true;
}

void Frame::end()
{
    glDisable(GL_DEPTH_TEST);
    glBindFramebuffer(GL_FRAMEBUFFER, static_cast<GLuint>(m_boundBefore));
    m_picture = m_begun->picture;
    m_begun.reset();
}

/// The targets are addresses, or places in the buffer that is bound to GL_PIXEL_PACK_BUFFER.
void Frame::readPixel(const DevicePixel &pixel, void *depth, void *object)
{
    const Surface &surface = m_picture->surface;
    assert(pixel.i >= 0 && pixel.i < surface.widthPixels && pixel.j >= 0 && pixel.j < surface.heightPixels);
    const int row = framebufferRow(surface, pixel);
    GLint boundBefore = 0;
    glGetIntegerv(GL_FRAMEBUFFER_BINDING, &boundBefore);
    glBindFramebuffer(GL_FRAMEBUFFER, m_framebuffer);
    glReadBuffer(GL_COLOR_ATTACHMENT1);
    glPixelStorei(GL_PACK_ALIGNMENT, 4);
    // As integers, because a float cannot hold every step of 24 bits.
    glReadPixels(pixel.i, row, 1, 1, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT, depth);
    if (m_ids == ObjectIds::Integers)
        glReadPixels(pixel.i, row, 1, 1, GL_RED_INTEGER, GL_UNSIGNED_INT, object);
    else
        glReadPixels(pixel.i, row, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, object);
    glBindFramebuffer(GL_FRAMEBUFFER, static_cast<GLuint>(boundBefore));
}

DepthSample Frame::decoded(const Raw &raw) const
{
    std::uint32_t id = 0;
    if (m_ids == ObjectIds::Integers) {
        std::memcpy(&id, raw.object.data(), sizeof id);
    } else {
        for (std::size_t byte = 4; byte-- > 0;)
            id = id << 8 | raw.object[byte];
    }
    const DepthRange &range = m_picture->depthRange;
    if (id == 0)
        return {range.atFar, std::nullopt, m_depthBits};
    const double steps = std::ldexp(1.0, m_depthBits) - 1.0;
    const double depth = std::round(raw.depth / 4294967295.0 * steps) / steps;
    // Rounding to whole steps can lead out of the range, where no surface was drawn: its end is nearer to the truth.
    const auto [lowest, highest] = std::minmax(range.atNear, range.atFar);
    return {std::clamp(depth, lowest, highest), static_cast<std::size_t>(id - 1), m_depthBits};
}

std::optional<DepthSample> Frame::sample(const DevicePixel &pixel)
{
    if (!m_picture)
        return std::nullopt;
    clearErrors(*this);
    Raw raw;
    readPixel(pixel, &raw.depth, raw.object.data());
    if (glGetError() != GL_NO_ERROR)
        return std::nullopt;
    return decoded(raw);
}

void Frame::request(const DevicePixel &pixel)
{
    dropRequest();
    if (!m_picture)
        return;
    clearErrors(*this);
    glBindBuffer(GL_PIXEL_PACK_BUFFER, m_requestBuffer);
    readPixel(pixel, reinterpret_cast<void *>(offsetof(Raw, depth)), reinterpret_cast<void *>(offsetof(Raw, object)));
    glBindBuffer(GL_PIXEL_PACK_BUFFER, 0);
    if (glGetError() != GL_NO_ERROR)
        return;
    m_fence = glFenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0);
    glFlush(); // or the fence would never be reached
}

std::optional<DepthSample> Frame::takeRequested()
{
    if (!m_fence)
        return std::nullopt;
    const GLenum state = glClientWaitSync(m_fence, 0, 0);
    if (state == GL_TIMEOUT_EXPIRED)
        return std::nullopt;
    dropRequest();
    if (state == GL_WAIT_FAILED)
        return std::nullopt;
    std::optional<DepthSample> sample;
    glBindBuffer(GL_PIXEL_PACK_BUFFER, m_requestBuffer);
    if (const void *bytes = glMapBufferRange(GL_PIXEL_PACK_BUFFER, 0, sizeof(Raw), GL_MAP_READ_BIT)) {
        Raw raw;
        std::memcpy(&raw, bytes, sizeof raw);
        if (glUnmapBuffer(GL_PIXEL_PACK_BUFFER))
            sample = decoded(raw);
    }
    glBindBuffer(GL_PIXEL_PACK_BUFFER, 0);
    return sample;
}

void Frame::dropRequest()
{
    if (m_fence)
        glDeleteSync(m_fence);
    m_fence = nullptr;
}

} // namespace unprojector::gui
