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

/// A framebuffer with the colour, the depth and the object of every pixel, one sample each, and the
/// setup they were drawn with. The object, never a depth comparison, decides whether there is a
/// surface under a pixel. All calls need the OpenGL context current.
///
/// The environment variable UNPROJECTOR_OBJECT_IDS=colors forces the fallback for drivers without
/// integer framebuffers.
class Frame : protected QOpenGLExtraFunctions {
public:
    void initialize();
    void release();

    /// The encoding of objects in the frame: valid from initialize() on.
    ObjectIds ids() const { return m_ids; }

    /// The longest side that OpenGL can draw, pixels: valid from initialize() on.
    int largestSide() const { return m_largestSide; }

    /// Resizes the frame to the view, clears it and binds it for drawing. Until beginObjects() only
    /// colours are written: they are behind every object and not clickable. The depth is cleared to
    /// the far plane's.
    /// @param around  the colour of the surface outside the viewport
    /// @return false if OpenGL cannot create such a framebuffer; then nothing is bound, and end()
    /// must not be called
    bool begin(const geometry::Drawable &drawable, const QColor &around = QColor(0xcc, 0xd1, 0xd6));
    /// Starts the drawing of objects: colour, depth and object id. Continues after pause().
    void beginObjects();
    /// Binds the former framebuffer for a while; the frame must not be read yet.
    void pause();
    /// Ends the drawing and binds the former framebuffer.
    void end();

    /// The setup of the drawn frame; nothing before the first.
    const std::optional<geometry::Setup> &setup() const { return m_setup; }
    unsigned framebuffer() const { return m_framebuffer; }
    unsigned colors() const { return m_colors; }
    unsigned depths() const { return m_depths; }

    /// DepthSample::cornerShiftPixels of this renderer; the context must be current.
    double cornerShiftPixels();
    /// The sample at a pixel, with the slope from neighbouring pixels of the same object. Waits
    /// until the frame is drawn.
    /// @pre the pixel lies inside the frame, if there is one
    /// @return nothing without a frame, and if OpenGL reports an error
    std::optional<unproject::DepthSample> sample(const geometry::DevicePixel &pixel);

    /// Requests a sample without waiting. A new request or a new frame drops the former request.
    /// @pre the pixel lies inside the frame, if there is one
    void request(const geometry::DevicePixel &pixel);
    /// Drops the request.
    void dropRequest();
    bool isRequested() const { return m_fence != nullptr; }
    /// The requested sample, once it has arrived; this ends the request. If OpenGL reports an
    /// error, there is no sample, and the request ends too.
    std::optional<unproject::DepthSample> takeRequested();

private:
    static constexpr std::size_t kBlock = 3; ///< pixels are read with their neighbours
    /// The values as glReadPixels writes them, one after the other.
    struct Raw {
        std::array<std::uint32_t, kBlock * kBlock> depths{}; ///< of 2^32 - 1, or the bits of floats
        std::array<std::uint32_t, kBlock * kBlock> objects{};
    };
    /// The part of a block inside the frame, framebuffer rows counted from the bottom.
    struct Block {
        int column = 0, row = 0, width = 0, height = 0;
        std::size_t middle = 0; ///< index of the pixel itself
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
