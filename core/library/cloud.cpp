#include "unprojector/cloud.h"

#include "core/base/path_text.h"
#include "core/base/translation.h"
#include "core/clouds/organized_cloud.h"
#include "core/images/number_image.h"
#include "core/library/internal.h"

#include <fstream>
#include <limits>
#include <system_error>
#include <utility>

namespace unprojector {
static_assert(int(DepthIs::Disparity) == int(clouds::DepthMeaning::Disparity));
namespace {

clouds::DepthValues::Type internalType(NumberType type)
{
    switch (type) {
    case NumberType::Uint8: return {false, std::numeric_limits<std::uint8_t>::max()};
    case NumberType::Uint16: return {false, std::numeric_limits<std::uint16_t>::max()};
    case NumberType::Int32: return {false, 0.0};
    case NumberType::Float32: return {true, 0.0};
    case NumberType::Float64: return {false, 0.0};
    }
    return {};
}

} // namespace

struct Cloud::Data {
    clouds::OrganizedCloud cloud;
    int width, height;
    bool canTakeFloats;
};

Result<Cloud> Cloud::of(const Setup &setup, const CloudOptions &options)
{
    const bool isOfWindow = options.depthIs == DepthIs::Buffer || options.depthIs == DepthIs::Range;
    if (isOfWindow && options.type == NumberType::Int32)
        return valueError(base::tr("window depths as whole numbers have 8 or 16 bits; give floats, or distances"));
    const clouds::DepthNumbers numbers{sameOf<clouds::DepthMeaning>(options.depthIs),
                                       true,
                                       options.scale,
                                       options.baseline,
                                       options.disparityOffset,
                                       options.noData};
    const auto cloud = clouds::OrganizedCloud::of(SetupAccess::of(setup), numbers, internalType(options.type),
                                                  sameOf<unproject::Method>(options.method));
    if (!cloud)
        return valueError(cloud.error());
    return Cloud(std::make_shared<const Data>(
        Data{*cloud, setup.width(), setup.height(),
             cloud->canTakeFloats()
                 && (options.type == NumberType::Float32 || options.type == NumberType::Uint8
                     || options.type == NumberType::Uint16)}));
}

int Cloud::width() const
{
    return m_data->width;
}

int Cloud::height() const
{
    return m_data->height;
}

void Cloud::row(std::size_t row, std::size_t first, std::vector<double> &numbers, double *points) const
{
    m_data->cloud.row(row, first, numbers, points);
}

void Cloud::row(std::size_t row, std::size_t first, std::vector<double> &numbers, float *points) const
{
    m_data->cloud.row(row, first, numbers, points);
}

void Cloud::row(std::size_t row, std::size_t first, std::span<const float> numbers, double *points) const
{
    m_data->cloud.row(row, first, numbers, points);
}

void Cloud::row(std::size_t row, std::size_t first, std::span<const float> numbers, float *points) const
{
    m_data->cloud.row(row, first, numbers, points);
}

bool Cloud::canTakeFloats() const
{
    return m_data->canTakeFloats;
}

void Cloud::count(std::size_t row, const std::vector<double> &numbers, CloudCounts &counts) const
{
    clouds::PixelCounts kinds{};
    m_data->cloud.count(row, numbers, kinds);
    const auto of = [&kinds](clouds::PixelKind kind) { return kinds[static_cast<std::size_t>(kind)]; };
    counts.kept += of(clouds::PixelKind::Kept);
    counts.zero += of(clouds::PixelKind::Zero);
    counts.notANumber += of(clouds::PixelKind::NotANumber);
    counts.infinite += of(clouds::PixelKind::Infinite);
    counts.negative += of(clouds::PixelKind::Negative);
    counts.beforeNear += of(clouds::PixelKind::BeforeNear);
    counts.atFar += of(clouds::PixelKind::AtFar);
    counts.outsideRange += of(clouds::PixelKind::OutsideRange);
    counts.noData += of(clouds::PixelKind::NoData);
}

Result<DepthImage> readDepth(const std::filesystem::path &file, const std::string &channel,
                             std::optional<std::endian> byteOrder)
{
    const std::string name = base::utf8FromPath(file);
    std::error_code code;
    if (!std::filesystem::exists(file, code))
        return Error{Error::Kind::MissingFile, name + ": " + base::tr("there is no such file")};
    const std::uintmax_t size = std::filesystem::file_size(file, code);
    std::ifstream stream(file, std::ios::binary);
    if (code || !stream)
        return Error{Error::Kind::File, name + ": " + base::tr("cannot be read")};
    images::ImageBytes bytes(
        [&stream](char *target, std::size_t count) {
            stream.read(target, static_cast<std::streamsize>(count));
            return static_cast<std::size_t>(stream.gcount());
        },
        [&stream](std::uint64_t position) {
            stream.clear();
            return static_cast<bool>(stream.seekg(static_cast<std::streamoff>(position)));
        },
        size);
    images::ImageRequest request;
    request.channel = channel;
    request.byteOrder = byteOrder;
    request.channelName = "channel";
    request.byteOrderName = "byte_order";
    const auto image = images::readNumberImage(bytes, request);
    if (!image)
        return valueError(name + ": " + image.error().text);
    DepthImage result{image->size.width, image->size.height, {}, {}};
    for (const std::string &note : image->notes)
        result.notes.push_back(name + ": " + note);
    std::visit(
        [&](const auto &numbers) {
            using Number = std::remove_cvref_t<decltype(numbers[0])>;
            std::vector<Number> rows;
            rows.reserve(image->size.pixels());
            for (std::size_t j = 0; j < image->size.height; ++j)
                rows.insert(rows.end(), numbers.get() + image->start(j),
                            numbers.get() + image->start(j) + image->size.width);
            result.numbers = std::move(rows);
        },
        image->numbers);
    return result;
}

} // namespace unprojector
