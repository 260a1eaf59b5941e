// Colors from JPEG, by libjpeg.

#include "core/base/translation.h"
#include "core/images/formats.h"

#include <csetjmp>
#include <cstdio> // jpeglib.h needs it

#include <jpeglib.h>

#include <jerror.h>

namespace unprojector::images {
using base::tr;
namespace {

/// The orientation of an Exif segment: 1 is upright, 2 to 8 are turned or mirrored.
/// @param segment  the content of a JPEG's APP1, beginning with "Exif"
/// @return nothing for another segment, one without an orientation, or a damaged one
std::optional<unsigned> exifOrientation(std::span<const std::uint8_t> segment)
{
    constexpr std::array<std::uint8_t, 6> kStart{'E', 'x', 'i', 'f', 0, 0};
    if (segment.size() <= kStart.size() || !std::equal(kStart.begin(), kStart.end(), segment.begin()))
        return std::nullopt;
    // The numbers of a TIFF; 0 behind its end.
    const std::span<const std::uint8_t> tiff = segment.subspan(kStart.size());
    const std::endian order = !tiff.empty() && tiff[0] == 'M' ? std::endian::big : std::endian::little;
    const auto numberAt = [&]<class Number>(std::size_t at, Number) -> std::size_t {
        return at + sizeof(Number) <= tiff.size() ? base::numberAt<Number>(tiff.data() + at, order) : 0;
    };
    const auto of16 = [&](std::size_t at) { return numberAt(at, std::uint16_t{}); };
    constexpr unsigned kOrientation = 0x0112, kShort = 3;
    constexpr std::size_t kEntry = 12;
    const std::size_t directory = numberAt(4, std::uint32_t{}), count = of16(directory);
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t entry = directory + 2 + i * kEntry, value = of16(entry + 8);
        if (of16(entry) == kOrientation && of16(entry + 2) == kShort && value >= 1 && value <= 8)
            return value;
    }
    return std::nullopt;
}

/// libjpeg's reader.
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

    void readHeader()
    {
        run([this] {
            jpeg_create_decompress(&m_decoder);
            m_decoder.client_data = this;
            m_decoder.src = &m_source;
            jpeg_save_markers(&m_decoder, kExifMarker, kLongestSegment);
            jpeg_read_header(&m_decoder, TRUE);
        });
    }
    PixelSize size() const { return {m_decoder.image_width, m_decoder.image_height}; }
    bool isOfInks() const { return m_decoder.num_components == 4; }

    void start()
    {
        run([this] {
            m_decoder.out_color_space = JCS_RGB;
            jpeg_start_decompress(&m_decoder);
        });
    }
    /// Missing pixels are an error too, although libjpeg fills them with gray.
    void readRow(std::uint8_t *row)
    {
        run([this, row] {
            JSAMPROW rows = row;
            jpeg_read_scanlines(&m_decoder, &rows, 1);
        });
        if (m_isEnded || m_lacksData)
            fail();
    }

    /// The first warning; empty if there is none.
    const std::string &warning() const { return m_warning; }
    std::optional<unsigned> orientation() const
    {
        for (auto marker = m_decoder.marker_list; marker != nullptr; marker = marker->next) {
            if (const auto orientation = exifOrientation({marker->data, marker->data_length}))
                return orientation;
        }
        return std::nullopt;
    }

private:
    /// Calls libjpeg, whose errors jump (longjmp) back here: no object of a step needs a destructor.
    template <class Step>
    void run(const Step &step)
    {
        if (setjmp(m_jump) != 0)
            fail();
        step();
    }
    [[noreturn]] void fail()
    {
        if (m_isEnded)
            throw tooShort(size());
        if (m_lacksData)
            throw damaged(m_warning);
        char message[JMSG_LENGTH_MAX] = "libjpeg";
        m_errors.format_message(reinterpret_cast<j_common_ptr>(&m_decoder), message);
        throw damaged(message);
    }
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

ColorImage readJpegColors(ImageBytes &bytes, const ImageRequest &request)
{
    JpegReader reader(bytes);
    reader.readHeader();
    ColorImage image;
    image.size = reader.size();
    if (reader.isOfInks())
        throw base::Error{tr("the JPEG has the four inks of printing; convert it to red, green and blue")};
    checkSize(image.size, request);
    reader.start();
    constexpr std::size_t kChannels = 3;
    image.colors = std::make_unique_for_overwrite<std::uint8_t[]>(kChannels * image.size.pixels());
    for (std::size_t j = 0; j < image.size.height; ++j) {
        reader.readRow(image.colors.get() + j * kChannels * image.size.width);
        request.onRead(image.size.width);
    }
    if (!reader.warning().empty())
        image.notes.push_back(tr("the JPEG has a fault (%1); some of its colors may be wrong", reader.warning()));
    if (const auto orientation = reader.orientation(); orientation && *orientation != 1)
        image.notes.push_back(tr("the JPEG is to be shown turned or mirrored (Exif orientation %1); its pixels are "
                                 "used as stored",
                                 *orientation));
    return image;
}

} // namespace unprojector::images
