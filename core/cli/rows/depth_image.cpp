#include "core/cli/rows/depth_image.h"

#include "core/text/translation.h"

#include <charconv>
#include <string_view>

namespace unprojector::cli {
using namespace images;
using geometry::Result;
using text::tr;
namespace {

std::optional<std::size_t> sideOf(std::string_view text)
{
    std::size_t side = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), side);
    if (error != std::errc{} || end != text.data() + text.size() || side == 0 || side > kMostSide)
        return std::nullopt;
    return side;
}

std::optional<ImageSize> sizeOf(const std::string &text)
{
    const std::size_t cross = text.find('x');
    if (cross == std::string::npos)
        return std::nullopt;
    const auto width = sideOf(std::string_view(text).substr(0, cross));
    const auto height = sideOf(std::string_view(text).substr(cross + 1));
    if (!width || !height)
        return std::nullopt;
    return ImageSize{*width, *height};
}

/// Reads an image by one of the readers, and prints what it reports.
template <class Image>
std::optional<Image> readImage(const std::string &file, const ImageRequest &request,
                               Result<Image, ImageError> (*reader)(ImageBytes &, const ImageRequest &))
{
    ByteSource source(file);
    if (!source.isOpen())
        return std::nullopt;
    ImageBytes bytes([&](char *target, std::size_t count) { return source.read(target, count); },
                     [&](std::uint64_t position) { return source.seek(position); }, source.size());
    Result<Image, ImageError> image = reader(bytes, request);
    if (source.hasFailed() || !image) {
        complain(source.name() + ": "
                 + (source.hasFailed() ? tr("reading stopped at an error") : image.error().reason));
        return std::nullopt;
    }
    for (const std::string &note : image->notes)
        complain(source.name() + ": " + note);
    return std::move(image).value();
}

} // namespace

std::optional<NumberImage> readDepthImage(const std::string &file, const std::string &sizeText, const ImageSize &window,
                                          const std::function<void(std::size_t)> &onRead)
{
    ImageRequest request;
    if (!sizeText.empty()) {
        request.rawSize = sizeOf(sizeText);
        if (!request.rawSize) {
            complain(tr("%1: give width and height in pixels, as in 1920x1080", "--size " + sizeText));
            return std::nullopt;
        }
    }
    request.onRead = onRead;
    request.refusal = [&](const ImageSize &size) -> std::optional<ImageError> {
        if (request.rawSize && *request.rawSize != size)
            return ImageError{
                tr("the image has %1 pixels, not %2", images::sizeText(size), images::sizeText(*request.rawSize))};
        if (size != window)
            return ImageError{tr("the image has %1 pixels, the scene's window %2 pixels", images::sizeText(size),
                                 images::sizeText(window))};
        return std::nullopt;
    };
    return readImage(file, request, readNumberImage);
}

std::optional<ColorImage> readColors(const std::string &file, const ImageSize &window)
{
    ImageRequest request;
    request.onRead = [](std::size_t) {};
    request.refusal = [&](const ImageSize &size) -> std::optional<ImageError> {
        if (size == window)
            return std::nullopt;
        return ImageError{tr("the colors have %1 pixels, the depths %2 pixels; give colors of the same camera and size",
                             images::sizeText(size), images::sizeText(window))};
    };
    return readImage(file, request, readColorImage);
}

} // namespace unprojector::cli
