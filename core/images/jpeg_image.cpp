// Colors from JPEG, by libjpeg.

#include "core/base/translation.h"
#include "core/images/exif_orientation.h"
#include "core/images/formats.h"

#include <csetjmp>
#include <cstdio> // jpeglib.h needs it

#include <jpeglib.h>

#include <jerror.h>

namespace unprojector::images {
using base::tr;
namespace {

/// libjpeg's reader. Its errors jump (longjmp) to the latest setjmp: each function that calls
/// libjpeg has one, and no object there needs a destructor.
class JpegReader {
    static constexpr int kExifMarker = JPEG_APP0 + 1;
    static constexpr unsigned kLongestSegment = 0xffff;

public:
    explicit JpegReader(ImageBytes &bytes) : m_bytes(bytes)
    {
        m_decoder.err = jpeg_std_error(&m_errors);
        m_errors.error_exit = onError;
        m_errors.emit_message = onMessage;
        m_errors.output_message = [](j_common_ptr) {};
        m_decoder.client_data = this;
        m_source.init_source = [](j_decompress_ptr) {};
        m_source.term_source = [](j_decompress_ptr) {};
        m_source.fill_input_buffer = onFill;
        m_source.skip_input_data = onSkip;
        m_source.resync_to_restart = jpeg_resync_to_restart;
    }
    ~JpegReader() { jpeg_destroy_decompress(&m_decoder); }
    JpegReader(const JpegReader &) = delete;
    JpegReader &operator=(const JpegReader &) = delete;

    bool readHeader()
    {
        if (setjmp(m_jump) != 0)
            return false;
        jpeg_create_decompress(&m_decoder);
        m_decoder.client_data = this;
        m_decoder.src = &m_source;
        jpeg_save_markers(&m_decoder, kExifMarker, kLongestSegment);
        jpeg_read_header(&m_decoder, TRUE);
        return true;
    }
    PixelSize size() const { return {m_decoder.image_width, m_decoder.image_height}; }
    bool isOfInks() const { return m_decoder.num_components == 4; }

    bool start()
    {
        if (setjmp(m_jump) != 0)
            return false;
        m_decoder.out_color_space = JCS_RGB;
        jpeg_start_decompress(&m_decoder);
        return true;
    }
    bool readRow(std::uint8_t *row)
    {
        if (setjmp(m_jump) != 0)
            return false;
        JSAMPROW rows = row;
        jpeg_read_scanlines(&m_decoder, &rows, 1);
        return !m_isEnded && !m_lacksData;
    }

    /// The first warning; empty if there is none.
    const std::string &warning() const { return m_warning; }
    std::optional<int> orientation() const
    {
        for (auto marker = m_decoder.marker_list; marker != nullptr; marker = marker->next) {
            if (const auto orientation = exifOrientation({marker->data, marker->data_length}))
                return orientation;
        }
        return std::nullopt;
    }

    /// The error; missing pixels are one too, although libjpeg fills them with gray.
    ImageError error()
    {
        if (m_isEnded)
            return tooShort(size());
        if (m_lacksData)
            return damaged(m_warning);
        char message[JMSG_LENGTH_MAX] = "libjpeg";
        m_errors.format_message(reinterpret_cast<j_common_ptr>(&m_decoder), message);
        return damaged(message);
    }

private:
    [[noreturn]] static void onError(j_common_ptr decoder)
    {
        std::longjmp(static_cast<JpegReader *>(decoder->client_data)->m_jump, 1);
    }
    static void onMessage(j_common_ptr decoder, int level)
    {
        constexpr int kWarning = -1;
        if (level != kWarning)
            return;
        auto &self = *static_cast<JpegReader *>(decoder->client_data);
        std::array<char, JMSG_LENGTH_MAX> message{};
        self.m_errors.format_message(decoder, message.data());
        const bool isMissing = self.m_errors.msg_code == JWRN_HIT_MARKER;
        if (self.m_warning.empty() || (isMissing && !self.m_lacksData))
            self.m_warning = message.data();
        self.m_lacksData = self.m_lacksData || isMissing;
    }
    static boolean onFill(j_decompress_ptr decoder)
    {
        auto &self = *static_cast<JpegReader *>(decoder->client_data);
        std::size_t count = self.m_bytes.readSome(reinterpret_cast<char *>(self.m_buffer.data()), self.m_buffer.size());
        if (count == 0) {
            self.m_isEnded = true;
            self.m_buffer[0] = 0xff;
            self.m_buffer[1] = JPEG_EOI;
            count = 2;
        }
        self.m_source.next_input_byte = self.m_buffer.data();
        self.m_source.bytes_in_buffer = count;
        return TRUE;
    }
    static void onSkip(j_decompress_ptr decoder, long count)
    {
        auto &self = *static_cast<JpegReader *>(decoder->client_data);
        auto left = static_cast<std::size_t>(std::max(count, 0L));
        while (left > self.m_source.bytes_in_buffer && !self.m_isEnded) {
            left -= self.m_source.bytes_in_buffer;
            onFill(decoder);
        }
        left = std::min(left, self.m_source.bytes_in_buffer);
        self.m_source.next_input_byte += left;
        self.m_source.bytes_in_buffer -= left;
    }

    ImageBytes &m_bytes;
    jpeg_decompress_struct m_decoder{};
    jpeg_error_mgr m_errors{};
    jpeg_source_mgr m_source{};
    std::jmp_buf m_jump;
    std::array<JOCTET, 16384> m_buffer{};
    bool m_isEnded = false;
    bool m_lacksData = false; ///< the pixels end before the image does
    std::string m_warning;
};

} // namespace

Colors readJpegColors(ImageBytes &bytes, const ImageRequest &request)
{
    JpegReader reader(bytes);
    if (!reader.readHeader())
        return reader.error();
    ColorImage image;
    image.size = reader.size();
    if (reader.isOfInks())
        return ImageError{tr("the JPEG has the four inks of printing; convert it to red, green and blue")};
    if (auto refused = sizeRefusal(image.size, request))
        return *refused;
    if (!reader.start())
        return reader.error();
    constexpr std::size_t kChannels = 3;
    image.colors = std::make_unique_for_overwrite<std::uint8_t[]>(kChannels * image.size.pixels());
    for (std::size_t j = 0; j < image.size.height; ++j) {
        if (!reader.readRow(image.colors.get() + j * kChannels * image.size.width))
            return reader.error();
        request.onRead(image.size.width);
    }
    if (!reader.warning().empty())
        image.notes.push_back(tr("the JPEG has a fault (%1); some of its colors may be wrong", reader.warning()));
    if (const std::optional<int> orientation = reader.orientation(); orientation && *orientation != 1)
        image.notes.push_back(tr("the JPEG is to be shown turned or mirrored (Exif orientation %1); its pixels are "
                                 "used as stored",
                                 *orientation));
    return image;
}

} // namespace unprojector::images
