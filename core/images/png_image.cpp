// PNG, by libpng.

#include "core/base/translation.h"
#include "core/images/formats.h"

#include <png.h>

#include <csetjmp>

namespace unprojector::images {
using base::tr;
namespace {

/// libpng's reader.
class PngReader {
public:
    explicit PngReader(ImageBytes &bytes) : m_bytes(bytes)
    {
        m_png = png_create_read_struct(PNG_LIBPNG_VER_STRING, this, onError, onWarning);
        m_info = m_png != nullptr ? png_create_info_struct(m_png) : nullptr;
    }
    ~PngReader() { png_destroy_read_struct(&m_png, &m_info, nullptr); }
    PngReader(const PngReader &) = delete;
    PngReader &operator=(const PngReader &) = delete;

    void readHeader()
    {
        if (m_info == nullptr)
            throw damaged(m_error);
        run([this] {
            png_set_read_fn(m_png, this, onRead);
            png_set_user_limits(m_png, kMostSide, kMostSide);
            png_read_info(m_png, m_info);
        });
    }
    PixelSize size() const { return {png_get_image_width(m_png, m_info), png_get_image_height(m_png, m_info)}; }
    int bits() const { return png_get_bit_depth(m_png, m_info); }
    int colorType() const { return png_get_color_type(m_png, m_info); }

    /// Prepares for pixels of 8 or 16 bits in this machine's order, or for colors of 3 x 8 bits.
    void prepare(bool isForColors)
    {
        run([this, isForColors] {
            if (isForColors) {
                png_set_expand(m_png);
                png_set_scale_16(m_png);
                png_set_gray_to_rgb(m_png);
                png_set_strip_alpha(m_png);
            } else if (std::endian::native == std::endian::little) {
                png_set_swap(m_png);
            }
            m_passes = png_set_interlace_handling(m_png);
            png_read_update_info(m_png, m_info);
        });
    }

    std::size_t rowBytes() const { return png_get_rowbytes(m_png, m_info); }

    /// Reads all rows, and the end of the file.
    void readRows(std::uint8_t *pixels, const ImageRequest &request)
    {
        const PixelSize image = size();
        for (int pass = 0; pass < m_passes; ++pass) {
            for (std::size_t j = 0; j < image.height; ++j) {
                run([this, row = pixels + j * rowBytes()] { png_read_row(m_png, row, nullptr); });
                if (pass + 1 == m_passes)
                    request.onRead(image.width);
            }
        }
        run([this] { png_read_end(m_png, nullptr); });
    }

private:
    /// Calls libpng, whose errors jump (longjmp) back here: no object of a step needs a destructor.
    template <class Step>
    void run(const Step &step)
    {
        if (setjmp(png_jmpbuf(m_png)) != 0)
            throw m_isEnded ? tooShort(size()) : damaged(m_error);
        step();
    }

    static PngReader &self(png_structp png) { return *static_cast<PngReader *>(png_get_error_ptr(png)); }
    [[noreturn]] static void onError(png_structp png, png_const_charp message)
    {
        self(png).m_error = message;
        png_longjmp(png, 1);
    }
    static void onWarning(png_structp, png_const_charp) {} // about what is not a pixel
    static void onRead(png_structp png, png_bytep target, std::size_t count)
    {
        if (self(png).m_bytes.read(reinterpret_cast<char *>(target), count))
            return;
        self(png).m_isEnded = true;
        png_error(png, "end of file");
    }

    ImageBytes &m_bytes;
    png_structp m_png = nullptr;
    png_infop m_info = nullptr;
    std::string m_error = "libpng";
    int m_passes = 1;
    bool m_isEnded = false;
};

std::string kindOf(const PngReader &reader)
{
    switch (reader.colorType()) {
    case PNG_COLOR_TYPE_PALETTE: return tr("a palette of colors");
    case PNG_COLOR_TYPE_RGB: return tr("red, green and blue");
    case PNG_COLOR_TYPE_RGB_ALPHA: return tr("red, green, blue and opacity");
    case PNG_COLOR_TYPE_GRAY_ALPHA: return tr("gray and opacity");
    default: return tr("%1 bits a pixel", reader.bits());
    }
}

template <class Number>
void readGray(PngReader &reader, NumberImage &image, const ImageRequest &request)
{
    auto numbers = std::make_unique_for_overwrite<Number[]>(image.size.pixels());
    reader.readRows(reinterpret_cast<std::uint8_t *>(numbers.get()), request);
    image.greatest = kGreatest<Number>;
    image.numbers = std::move(numbers);
}

} // namespace

NumberImage readPng(ImageBytes &bytes, const ImageRequest &request)
{
    PngReader reader(bytes);
    reader.readHeader();
    NumberImage image;
    image.size = reader.size();
    if (reader.colorType() != PNG_COLOR_TYPE_GRAY || reader.bits() < 8)
        throw base::Error{tr("the PNG has %1; a depth image has 8 or 16 bits of gray", kindOf(reader))};
    checkSize(image.size, request);
    reader.prepare(false);
    if (reader.bits() == 16)
        readGray<std::uint16_t>(reader, image, request);
    else
        readGray<std::uint8_t>(reader, image, request);
    return image;
}

ColorImage readPngColors(ImageBytes &bytes, const ImageRequest &request)
{
    PngReader reader(bytes);
    reader.readHeader();
    ColorImage image;
    image.size = reader.size();
    checkSize(image.size, request);
    reader.prepare(true);
    constexpr std::size_t kChannels = 3;
    if (reader.rowBytes() != kChannels * image.size.width)
        throw damaged("libpng");
    image.colors = std::make_unique_for_overwrite<std::uint8_t[]>(kChannels * image.size.pixels());
    reader.readRows(image.colors.get(), request);
    return image;
}

} // namespace unprojector::images
