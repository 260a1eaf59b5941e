#include "gui/view/frame.h"

#include "gui/view/corner_shift.h"
#include "gui/view/painters/gl_errors.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <cstring>

namespace unprojector::gui {
using namespace geometry;
using namespace unproject;

namespace {

constexpr std::array<GLenum, 2> kColorsAlone{GL_COLOR_ATTACHMENT0, GL_NONE};
constexpr std::array<GLenum, 2> kColorsAndObjects{GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT1};

} // namespace

void Frame::initialize()
{
    initializeOpenGLFunctions();
    m_cornerShift.reset();
    glGenBuffers(1, &m_requestBuffer);
    glBindBuffer(GL_PIXEL_PACK_BUFFER, m_requestBuffer);
    glBufferData(GL_PIXEL_PACK_BUFFER, sizeof(Raw), nullptr, GL_STREAM_READ);
    glBindBuffer(GL_PIXEL_PACK_BUFFER, 0);
    std::array<GLint, 2> viewport{};
    GLint texture = 0, buffer = 0;
    glGetIntegerv(GL_MAX_VIEWPORT_DIMS, viewport.data());
    glGetIntegerv(GL_MAX_TEXTURE_SIZE, &texture);
    glGetIntegerv(GL_MAX_RENDERBUFFER_SIZE, &buffer);
    m_largestSide = std::min({viewport[0], viewport[1], texture, buffer});
    // A minimal framebuffer shows what the driver supports.
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
    m_setup.reset();
}

bool Frame::allocate(int widthPixels, int heightPixels)
{
    constexpr std::int64_t kMostPixels = std::int64_t{1} << 26; // more would take gigabytes
    if (std::int64_t{widthPixels} * heightPixels > kMostPixels)
        return false;
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
    // The format of QOpenGLWidget's own framebuffer, so that depths can be copied there as they
    // are.
    m_depths =
        attached(GL_DEPTH_STENCIL_ATTACHMENT, GL_DEPTH24_STENCIL8, GL_DEPTH_STENCIL, GL_UNSIGNED_INT_24_8, GL_NEAREST);
    glBindTexture(GL_TEXTURE_2D, 0);
    glDrawBuffers(2, kColorsAndObjects.data());
    GLint depthBits = 0, depthType = GL_UNSIGNED_NORMALIZED;
    const bool isComplete = glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
    if (isComplete) {
        glGetFramebufferAttachmentParameteriv(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_FRAMEBUFFER_ATTACHMENT_DEPTH_SIZE,
                                              &depthBits);
        // The driver may give more than requested, as floats.
        glGetFramebufferAttachmentParameteriv(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT,
                                              GL_FRAMEBUFFER_ATTACHMENT_COMPONENT_TYPE, &depthType);
    }
    glBindFramebuffer(GL_FRAMEBUFFER, static_cast<GLuint>(boundBefore));
    if (!isComplete || glGetError() != GL_NO_ERROR) {
        releaseTextures(); // a framebuffer that cannot be drawn into is not kept
        clearErrors(*this);
        return false;
    }
    if (depthType == GL_FLOAT)
        m_depthFormat = DepthFormat::floatingPoint();
    else
        m_depthFormat = DepthFormat(depthBits > 0 ? depthBits : 24);
    m_widthPixels = widthPixels;
    m_heightPixels = heightPixels;
    return true;
}

/// Binds the frame and sets all state for drawing into it; other drawing in between sets its own.
void Frame::bind()
{
    glGetIntegerv(GL_FRAMEBUFFER_BINDING, &m_boundBefore);
    glBindFramebuffer(GL_FRAMEBUFFER, m_framebuffer);
    glDisable(GL_SCISSOR_TEST);
    glDisable(GL_BLEND);
    glDisable(GL_DITHER); // dithering would change object ids
    glDepthMask(GL_TRUE);
    glViewport(m_begun->x, m_begun->y, m_begun->width, m_begun->height);
    glDepthRangef(m_begun->depthAtNear, m_begun->depthAtFar);
}

bool Frame::begin(const Drawable &drawable, const QColor &around)
{
    dropRequest();
    m_setup.reset();
    if (!allocate(drawable.setup.surface.widthPixels, drawable.setup.surface.heightPixels))
        return false;
    m_begun = drawable;
    m_isPaused = false;
    bind();
    const std::array<GLfloat, 4> cleared{around.redF(), around.greenF(), around.blueF(), around.alphaF()};
    glDrawBuffers(2, kColorsAndObjects.data());
    glClearBufferfv(GL_COLOR, 0, cleared.data());
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
    m_setup = m_begun->setup;
    m_begun.reset();
}

Frame::Block Frame::blockAround(const DevicePixel &pixel) const
{
    const Surface &surface = m_setup->surface;
    assert(pixel.i >= 0 && pixel.i < surface.widthPixels && pixel.j >= 0 && pixel.j < surface.heightPixels);
    const int row = framebufferRow(surface, pixel);
    Block block;
    block.column = std::max(pixel.i - 1, 0);
    block.row = std::max(row - 1, 0);
    block.width = std::min(pixel.i + 1, surface.widthPixels - 1) - block.column + 1;
    block.height = std::min(row + 1, surface.heightPixels - 1) - block.row + 1;
    block.middle = static_cast<std::size_t>((row - block.row) * block.width + pixel.i - block.column);
    return block;
}

/// The targets are addresses, or offsets in the buffer bound to GL_PIXEL_PACK_BUFFER.
void Frame::readBlock(const Block &block, void *depths, void *objects)
{
    GLint boundBefore = 0;
    glGetIntegerv(GL_FRAMEBUFFER_BINDING, &boundBefore);
    glBindFramebuffer(GL_FRAMEBUFFER, m_framebuffer);
    glReadBuffer(GL_COLOR_ATTACHMENT1);
    glPixelStorei(GL_PACK_ALIGNMENT, 4);
    const auto read = [&](GLenum format, GLenum type, void *target) {
        glReadPixels(block.column, block.row, block.width, block.height, format, type, target);
    };
    // Fixed point as integers, because a float cannot hold every step of 24 bits.
    read(GL_DEPTH_COMPONENT, m_depthFormat.isFloat ? GL_FLOAT : GL_UNSIGNED_INT, depths);
    if (m_ids == ObjectIds::Integers)
        read(GL_RED_INTEGER, GL_UNSIGNED_INT, objects);
    else
        read(GL_RGBA, GL_UNSIGNED_BYTE, objects);
    glBindFramebuffer(GL_FRAMEBUFFER, static_cast<GLuint>(boundBefore));
}

std::uint32_t Frame::idOf(std::uint32_t raw) const
{
    if (m_ids == ObjectIds::Integers)
        return raw;
    const auto bytes = std::bit_cast<std::array<std::uint8_t, 4>>(raw);
    std::uint32_t id = 0;
    for (std::size_t byte = 4; byte-- > 0;)
        id = id << 8 | bytes[byte];
    return id;
}

double Frame::depthOf(std::uint32_t raw) const
{
    if (m_depthFormat.isFloat)
        return static_cast<double>(std::bit_cast<float>(raw));
    const double steps = std::ldexp(1.0, m_depthFormat.bits) - 1.0;
    return std::round(raw / 4294967295.0 * steps) / steps;
}

DepthSample Frame::decoded(const Raw &raw, const Block &block) const
{
    const DepthRange &range = m_setup->depthRange;
    const std::size_t middle = block.middle;
    const std::uint32_t id = idOf(raw.objects[middle]);
    if (id == 0)
        return {range.atFar, std::nullopt, m_depthFormat};
    const double depth = depthOf(raw.depths[middle]);
    // The steeper of both sides: a triangle smaller than a pixel is at least as steep as the step
    // to the next pixel.
    const auto slopeTo = [&](bool isBefore, bool isAfter, std::size_t step) {
        std::optional<double> slope;
        const auto add = [&](std::size_t index) {
            if (idOf(raw.objects[index]) == id)
                slope = std::max(slope.value_or(0.0), std::abs(depthOf(raw.depths[index]) - depth));
        };
        if (isBefore)
            add(middle - step);
        if (isAfter)
            add(middle + step);
        return slope;
    };
    const auto width = static_cast<std::size_t>(block.width), height = static_cast<std::size_t>(block.height);
    const std::size_t column = middle % width, row = middle / width;
    const std::optional<double> alongX = slopeTo(column > 0, column + 1 < width, 1),
                                alongY = slopeTo(row > 0, row + 1 < height, width);
    // Rounding to whole steps can leave the range, where no surface was drawn: clamping is more
    // accurate.
    const auto [lowest, highest] = std::minmax(range.atNear, range.atFar);
    DepthSample sample{std::clamp(depth, lowest, highest), static_cast<std::size_t>(id - 1), m_depthFormat};
    if (alongX && alongY)
        sample.slope = DepthSlope{*alongX, *alongY};
    sample.cornerShiftPixels = m_cornerShift.value_or(kCornerShiftPixels);
    return sample;
}

/// Deferred until a depth is needed: a program that only shows an image need not wait for it.
void Frame::measureCorners()
{
    if (!m_cornerShift)
        m_cornerShift = measuredCornerShift(*this);
}

double Frame::cornerShiftPixels()
{
    measureCorners();
    return m_cornerShift.value_or(kCornerShiftPixels);
}

std::optional<DepthSample> Frame::sample(const DevicePixel &pixel)
{
    if (!m_setup)
        return std::nullopt;
    measureCorners();
    clearErrors(*this);
    Raw raw;
    const Block block = blockAround(pixel);
    readBlock(block, raw.depths.data(), raw.objects.data());
    if (glGetError() != GL_NO_ERROR)
        return std::nullopt;
    return decoded(raw, block);
}

void Frame::request(const DevicePixel &pixel)
{
    dropRequest();
    if (!m_setup)
        return;
    measureCorners();
    clearErrors(*this);
    glBindBuffer(GL_PIXEL_PACK_BUFFER, m_requestBuffer);
    m_requested = blockAround(pixel);
    readBlock(m_requested, reinterpret_cast<void *>(offsetof(Raw, depths)),
              reinterpret_cast<void *>(offsetof(Raw, objects)));
    glBindBuffer(GL_PIXEL_PACK_BUFFER, 0);
    if (glGetError() != GL_NO_ERROR)
        return;
    m_fence = glFenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0);
    glFlush(); // the fence would otherwise never be reached
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
            sample = decoded(raw, m_requested);
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
