// OpenEXR, by its library.

#include "core/images/formats.h"
#include "core/text/translation.h"

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfIO.h>
#include <ImfInputPart.h>
#include <ImfMultiPartInputFile.h>
#include <ImfPartType.h>

#include <cctype>
#include <exception>
#include <limits>
#include <stdexcept>

namespace unprojector::images {
using text::tr;
namespace {

/// The bytes as OpenEXR reads them. Its errors are exceptions.
class Stream : public Imf::IStream {
public:
    explicit Stream(ImageBytes &bytes) : Imf::IStream(""), m_bytes(bytes) {}

    bool read(char target[], int count) override
    {
        if (!m_bytes.read(target, static_cast<std::size_t>(count)))
            throw std::runtime_error("end of file");
        return m_bytes.position() < m_bytes.size();
    }
    std::uint64_t tellg() override { return m_bytes.position(); }
    void seekg(std::uint64_t position) override { m_bytes.moveTo(position); }
    void clear() override {}

private:
    ImageBytes &m_bytes;
};

/// The part of a channel's name behind the layers, in small letters: "z" of "ViewLayer.Depth.Z".
std::string lastName(const std::string &channel)
{
    std::string name = channel.substr(channel.rfind('.') + 1);
    std::ranges::transform(name, name.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return name;
}

/// A channel of a file of one or more parts.
struct Choice {
    int part = 0;
    std::string channel;
};

/// All channels that are no deep data, and the one of depth among them: named Z or depth, else V,
/// R or Y.
struct Channels {
    std::vector<Choice> all;
    std::optional<Choice> depth;
    std::string names;
};

/// @param asked  the name of the channel to use; empty: by the rule above
Channels channelsOf(Imf::MultiPartInputFile &file, const std::string &asked)
{
    Channels result;
    for (int part = 0; part < file.parts(); ++part) {
        const Imf::Header &header = file.header(part);
        if (header.hasType() && Imf::isDeepData(header.type()))
            continue;
        for (auto it = header.channels().begin(); it != header.channels().end(); ++it) {
            result.all.push_back({part, it.name()});
            result.names += (result.names.empty() ? "" : ", ") + std::string(it.name());
        }
    }
    if (!asked.empty()) {
        const auto found = std::ranges::find(result.all, asked, &Choice::channel);
        if (found != result.all.end())
            result.depth = *found;
        return result;
    }
    for (const std::string name : {"z", "depth", "v", "r", "y"}) {
        for (const Choice &choice : result.all) {
            if (!result.depth && (lastName(choice.channel) == name || result.all.size() == 1))
                result.depth = choice;
        }
    }
    return result;
}

/// Reads the rows of a part. Pixels that it has beyond the image's frame are left out; those that
/// it lacks are NaN.
/// @tparam Number  float, also for half floats, or the whole numbers
template <class Number, class Stored>
void readRows(Imf::InputPart &part, const std::string &channel, NumberImage &image, const ImageRequest &request)
{
    const Imath::Box2i data = part.header().dataWindow(), frame = part.header().displayWindow();
    auto numbers = std::make_unique_for_overwrite<Stored[]>(image.size.pixels());
    std::fill_n(numbers.get(), image.size.pixels(), std::numeric_limits<Stored>::quiet_NaN());
    const auto dataWidth = static_cast<std::size_t>(data.max.x - data.min.x + 1);
    std::vector<Number> row(dataWidth);
    // The slice's base is the pixel (0, 0); rows at a distance of 0 bytes all go into `row`.
    constexpr auto kType = std::is_same_v<Number, float> ? Imf::FLOAT : Imf::UINT;
    constexpr std::ptrdiff_t kBytes = sizeof(Number);
    Imf::FrameBuffer buffer;
    buffer.insert(channel,
                  Imf::Slice(kType, reinterpret_cast<char *>(row.data()) - data.min.x * kBytes, sizeof(Number), 0));
    part.setFrameBuffer(buffer);
    for (int y = frame.min.y; y <= frame.max.y; ++y) {
        request.onRead(image.size.width);
        if (y < data.min.y || y > data.max.y)
            continue;
        part.readPixels(y, y);
        const int from = std::max(data.min.x, frame.min.x), to = std::min(data.max.x, frame.max.x);
        for (int x = from; x <= to; ++x)
            numbers[static_cast<std::size_t>(y - frame.min.y) * image.size.width
                    + static_cast<std::size_t>(x - frame.min.x)] =
                static_cast<Stored>(row[static_cast<std::size_t>(x - data.min.x)]);
    }
    image.numbers = std::move(numbers);
}

Numbers read(ImageBytes &bytes, const ImageRequest &request)
{
    constexpr int kMost = static_cast<int>(kMostSide);
    Imf::Header::setMaxImageSize(kMost, kMost);
    Stream stream(bytes);
    Imf::MultiPartInputFile file(stream);
    const Channels channels = channelsOf(file, request.channel);
    if (channels.all.empty())
        return ImageError{tr("the OpenEXR image has only deep data, several depths a pixel; write one depth a pixel")};
    if (!channels.depth && !request.channel.empty())
        return ImageError{tr("the OpenEXR image has the channels %1, not %2", channels.names, request.channel)};
    if (!channels.depth)
        return ImageError{
            tr("the OpenEXR image has the channels %1; give the one of depth by --channel NAME", channels.names)};
    const Imf::Header &header = file.header(channels.depth->part);
    const Imath::Box2i frame = header.displayWindow(), data = header.dataWindow();
    NumberImage image;
    image.size = {static_cast<std::size_t>(frame.max.x - frame.min.x + 1),
                  static_cast<std::size_t>(frame.max.y - frame.min.y + 1)};
    if (auto refused = sizeRefusal(image.size, request))
        return *refused;
    const Imf::Channel &channel = header.channels()[channels.depth->channel.c_str()];
    if (channel.xSampling != 1 || channel.ySampling != 1)
        return ImageError{tr("the channel %1 of the OpenEXR image has fewer numbers than pixels; write one a pixel",
                             channels.depth->channel)};
    if (channels.all.size() > 1 && request.channel.empty())
        image.notes.push_back(tr("of the channels %1, %2 is used", channels.names, channels.depth->channel));
    if (data.min.x > frame.min.x || data.min.y > frame.min.y || data.max.x < frame.max.x || data.max.y < frame.max.y)
        image.notes.push_back(tr("the OpenEXR image has pixels only in a part of its frame; the others are NaN"));
    Imf::InputPart part(file, channels.depth->part);
    if (channel.type == Imf::UINT) {
        image.greatest = std::numeric_limits<unsigned>::max();
        readRows<unsigned, double>(part, channels.depth->channel, image, request);
    } else {
        readRows<float, float>(part, channels.depth->channel, image, request);
    }
    return image;
}

} // namespace

Numbers readExr(ImageBytes &bytes, const ImageRequest &request)
{
    bytes.allowPositions();
    try {
        return read(bytes, request);
    } catch (const std::exception &error) {
        return damaged(error.what());
    }
}

} // namespace unprojector::images
