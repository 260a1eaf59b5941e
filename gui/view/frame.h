#pragma once

#include "core/geometry/drawable.h"
#include "core/unproject/pick.h"
#include "gui/view/painters/object_ids.h"

#include <QColor>
#include <QOpenGLExtraFunctions>

#include <array>
#include <cstdint>
#include <optional>

namespace unprojector::gui {

/// A framebuffer of our own: the colour, the depth and the object of every pixel, one sample each, and the picture that
/// they were drawn with. Whether there is a surface under a pixel is told by the object, never by comparing depths.
/// All calls need the OpenGL context current.
///
/// The environment variable UNPROJECTOR_OBJECT_IDS=colors makes it take the way back of drivers that have no framebuffers
/// of integers.
class Frame : protected QOpenGLExtraFunctions {
public:
    void initialize();
    void release();

    /// How objects are written into the frame: valid from initialize() on.
    ObjectIds ids() const { return m_ids; }

    /// The longest side that OpenGL draws, pixels: valid from initialize() on.
    int largestSide() const { return m_largestSide; }

    /// Makes the frame as large as the picture, clears it and binds it for drawing. Until beginObjects() only colours are
    /// written: what is drawn lies behind every object and is no surface to click. The depth is cleared to that of the far
    /// plane.
    /// @param around  the colour of what the viewport leaves of the surface
    /// @return false when OpenGL gives no such framebuffer; then nothing is bound, and there is nothing to end
    bool begin(const geometry::Drawable &drawable, const QColor &around = QColor(0xcc, 0xd1, 0xd6));
    /// From now on objects are drawn: colour, depth and object id. After pause() they are drawn on.
    void beginObjects();
    /// What was bound before is drawn into for a while; nothing of the frame is to be read yet.
    void pause();
    /// What was bound before is drawn into again.
    void end();

    /// The picture that was drawn; nothing before the first.
    const std::optional<geometry::Setup> &setup() const { return m_setup; }
    unsigned framebuffer() const { return m_framebuffer; }
    unsigned colors() const { return m_colors; }
    unsigned depths() const { return m_depths; }

    /// DepthSample::cornerShiftPixels of this renderer; the context must be current.
    double cornerShiftPixels();
    /// What was drawn at a pixel, with the slope that the same object's pixels beside it show. Waits until it is drawn.
    /// @pre the pixel lies inside the picture, if there is one
    /// @return nothing without a picture, and when OpenGL reports an error
    std::optional<unproject::DepthSample> sample(const geometry::DevicePixel &pixel);

    /// Asks for a sample without waiting. There is one request at a time: another one, or another picture, drops it.
    /// @pre the pixel lies inside the picture, if there is one
    void request(const geometry::DevicePixel &pixel);
    /// Nobody waits for the sample any more: nothing is requested.
    void dropRequest();
    bool isRequested() const { return m_fence != nullptr; }
    /// The sample that was asked for, once it has come; then nothing is requested any more. When OpenGL reports an
    /// error, nothing comes, and nothing is requested any more.
    std::optional<unproject::DepthSample> takeRequested();

private:
    static constexpr std::size_t kBlock = 3; ///< pixels are read with those around them
    /// As glReadPixels writes them, one after the other.
    struct Raw {
        std::array<std::uint32_t, kBlock * kBlock> depths{}; ///< of 2^32 - 1, or the bits of floats
        std::array<std::uint32_t, kBlock * kBlock> objects{};
    };
    /// The part of a block that lies in the picture, framebuffer rows counted from the bottom.
    struct Block {
        int column = 0, row = 0, width = 0, height = 0;
        std::size_t middle = 0; ///< place of the pixel itself
    };

    void bind();
    bool allocate(int widthPixels, int heightPixels);
    void releaseTextures();
    void measureCorners();
    Block blockAround(const geometry::DevicePixel &pixel) const;
    void readBlock(const Block &block, void *depths, void *objects);
    std::uint32_t idOf(std::uint32_t raw) const;
    double depthOf(std::uint32_t raw) const;
    unproject::DepthSample decoded(const Raw &raw, const Block &block) const;

    ObjectIds m_ids = ObjectIds::Integers;
    unsigned m_framebuffer = 0;
    unsigned m_colors = 0, m_objects = 0, m_depths = 0; ///< textures
    int m_widthPixels = 0, m_heightPixels = 0;
    int m_largestSide = 0;
    unproject::DepthFormat m_depthFormat;
    std::optional<double> m_cornerShift; ///< measuredCornerShift, once pixels are read
    int m_boundBefore = 0;
    std::optional<geometry::Drawable> m_begun;
    bool m_isPaused = false;
    std::optional<geometry::Setup> m_setup;
    unsigned m_requestBuffer = 0;
    Block m_requested;
    GLsync m_fence = nullptr;
};

} // namespace unprojector::gui
