// OpenEXR, by its library.

#include "core/base/text_scanner.h"
#include "core/base/translation.h"
#include "core/images/formats.h"

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfIO.h>
#include <ImfInputPart.h>
#include <ImfMultiPartInputFile.h>
#include <ImfPartType.h>

#include <exception>
#include <limits>
#include <stdexcept>

namespace unprojector::images {
using base::Error;
using base::tr;
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

/// A channel of a file of one or more parts.
struct Choice {
    int part = 0;
    std::string channel; ///< "ViewLayer.Depth.Z"

    /// The layers, in small letters: "viewlayer.depth".
    std::string layers() const
    {
        const std::size_t dot = channel.rfind('.');
        return dot == channel.npos ? std::string() : base::lowerCase(channel.substr(0, dot));
    }
    /// The part of the name behind the layers, in small letters: "z".
    std::string lastName() const { return base::lowerCase(channel.substr(channel.rfind('.') + 1)); }
};

/// The channels that are no deep data.
struct Channels {
    std::vector<Choice> all;
    std::string names;

    explicit Channels(Imf::MultiPartInputFile &file)
    {
        for (int part = 0; part < file.parts(); ++part) {
            const Imf::Header &header = file.header(part);
            if (header.hasType() && Imf::isDeepData(header.type()))
                continue;
            for (auto it = header.channels().begin(); it != header.channels().end(); ++it) {
                all.push_back({part, it.name()});
                names += (names.empty() ? "" : ", ") + std::string(it.name());
            }
        }
    }

    /// The channels that may hold the depths: those of the first of these groups that has any. Several of them are
    /// certain only where they have the same numbers.
    ///
    ///   named depth, or of a layer of that name; Z without a layer
    ///   with "depth" in the name; Z of a layer, but Blender's Mist
    ///   all but A: gray
    ///
    /// A channel Z that has X and Y beside it belongs to a vector: a normal, a position.
    std::vector<Choice> ofDepth() const
    {
        if (all.size() == 1)
            return all;
        std::array<std::vector<Choice>, 3> groups;
        for (const Choice &choice : all) {
            const std::string layers = choice.layers(), last = choice.lastName();
            if (last == "a" || isOfVector(choice))
                continue;
            const std::string path = '.' + layers + '.' + last + '.';
            const bool isNamed = path.find(".depth.") != path.npos || (layers.empty() && last == "z");
            const bool isLike = path.find("depth") != path.npos || (last == "z" && layers.find("mist") == layers.npos);
            groups[isNamed ? 0 : isLike ? 1 : 2].push_back(choice);
        }
        const auto found = std::ranges::find_if(groups, [](const auto &group) { return !group.empty(); });
        return found == groups.end() ? std::vector<Choice>() : *found;
    }

private:
    bool isOfVector(const Choice &choice) const
    {
        std::string axes = "xyz";
        if (axes.find(choice.lastName()) == axes.npos)
            return false;
        for (const Choice &other : all) {
            if (other.part == choice.part && other.layers() == choice.layers())
                std::erase(axes, other.lastName().size() == 1 ? other.lastName().front() : '\0');
        }
        return axes.empty();
    }
};

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

/// The numbers of a channel in its frame, which is the display window.
/// @param notes  the image's first ones
NumberImage readChannel(Imf::MultiPartInputFile &file, const Choice &choice, const ImageRequest &request,
                        std::vector<std::string> notes = {})
{
    const Imf::Header &header = file.header(choice.part);
    const Imath::Box2i frame = header.displayWindow(), data = header.dataWindow();
    NumberImage image;
    image.notes = std::move(notes);
    image.size = {static_cast<std::size_t>(frame.max.x - frame.min.x + 1),
                  static_cast<std::size_t>(frame.max.y - frame.min.y + 1)};
    checkSize(image.size, request);
    const Imf::Channel &channel = header.channels()[choice.channel.c_str()];
    if (channel.xSampling != 1 || channel.ySampling != 1)
        throw Error{
            tr("the channel %1 of the OpenEXR image has fewer numbers than pixels; write one a pixel", choice.channel)};
    if (data.min.x > frame.min.x || data.min.y > frame.min.y || data.max.x < frame.max.x || data.max.y < frame.max.y)
        image.notes.push_back(tr("the OpenEXR image has pixels only in a part of its frame; the others are NaN"));
    Imf::InputPart part(file, choice.part);
    if (channel.type == Imf::UINT) {
        image.greatest = std::numeric_limits<unsigned>::max();
        readRows<unsigned, double>(part, choice.channel, image, request);
    } else {
        readRows<float, float>(part, choice.channel, image, request);
    }
    return image;
}

bool haveSameNumbers(const NumberImage &a, const NumberImage &b)
{
    if (a.size != b.size || a.numbers.index() != b.numbers.index())
        return false;
    return std::visit(
        [&]<class Array>(const Array &numbers) {
            const auto isSame = [](auto x, auto y) { return x == y || (x != x && y != y); }; // NaN is NaN
            return std::equal(numbers.get(), numbers.get() + a.size.pixels(), std::get<Array>(b.numbers).get(), isSame);
        },
        a.numbers);
}

NumberImage read(ImageBytes &bytes, const ImageRequest &request)
{
    constexpr int kMost = static_cast<int>(kMostSide);
    Imf::Header::setMaxImageSize(kMost, kMost);
    Stream stream(bytes);
    Imf::MultiPartInputFile file(stream);
    const Channels channels(file);
    if (channels.all.empty())
        throw Error{tr("the OpenEXR image has only deep data, several depths a pixel; write one depth a pixel")};
    if (!request.channel.empty()) {
        const auto asked = std::ranges::find(channels.all, request.channel, &Choice::channel);
        if (asked == channels.all.end())
            throw Error{tr("the OpenEXR image has the channels %1, not %2", channels.names, request.channel)};
        return readChannel(file, *asked, request);
    }
    const Error uncertain{
        tr("the OpenEXR image has the channels %1; give the one of depth by %2", channels.names, request.channelName)};
    std::vector<Choice> choices = channels.ofDepth();
    if (choices.empty())
        throw uncertain;
    const Choice used = choices.back(); // R of B, G, R
    choices.pop_back();
    std::vector<std::string> notes;
    if (channels.all.size() > 1)
        notes.push_back(tr("of the channels %1, %2 is used", channels.names, used.channel));
    NumberImage image = readChannel(file, used, request, std::move(notes));
    ImageRequest silent;
    silent.check = request.check;
    const auto isSame = [&](const Choice &other) {
        try {
            return haveSameNumbers(image, readChannel(file, other, silent));
        } catch (const Error &) {
            return false;
        }
    };
    if (!std::ranges::all_of(choices, isSame))
        throw uncertain;
    return image;
}

} // namespace

NumberImage readExr(ImageBytes &bytes, const ImageRequest &request)
{
    bytes.allowPositions();
    try {
        return read(bytes, request);
    } catch (const std::exception &error) {
        throw damaged(error.what());
    }
}

} // namespace unprojector::images
