#include "core/cli/rows/depth_image.h"

#include "core/base/translation.h"

#include <cstdint>
#include <utility>

namespace unprojector::cli {
using namespace images;
using base::tr;
namespace {

/// Reads an image by one of the readers, and prints its notes.
template <class Image>
Image readImage(const std::string &file, const ImageRequest &request,
                base::Expected<Image, base::Error> (*reader)(ImageBytes &, const ImageRequest &))
{
    ByteSource source(file);
    ImageBytes bytes([&](char *target, std::size_t count) { return source.read(target, count); },
                     [&](std::uint64_t position) { return source.seek(position); }, source.size());
    base::Expected<Image, base::Error> image = reader(bytes, request);
    if (source.hasFailed() || !image)
        refuse(source.name() + ": " + (source.hasFailed() ? tr("reading stopped at an error") : image.error().text));
    for (const std::string &note : image->notes)
        complain(source.name() + ": " + note);
    return std::move(image).value();
}

} // namespace

NumberImage readDepthImage(const std::string &file, const DepthImageChoices &choices, const PixelSize &window,
                           const std::function<void(std::size_t)> &onRead)
{
    ImageRequest request;
    request.rawSize = choices.size;
    request.channel = choices.channel;
    request.byteOrder = choices.byteOrder;
    request.onRead = onRead;
    request.check = [&](const PixelSize &size) {
        if (request.rawSize && *request.rawSize != size)
            throw base::Error{tr("the image has %1 pixels, not %2", sizeText(size), sizeText(*request.rawSize))};
        if (size != window)
            throw base::Error{
                tr("the image has %1 pixels, the scene's window %2 pixels", sizeText(size), sizeText(window))};
    };
    return readImage(file, request, readNumberImage);
}

ColorImage readColors(const std::string &file, const PixelSize &window)
{
    ImageRequest request;
    request.check = [&](const PixelSize &size) {
        if (size != window)
            throw base::Error{
                tr("the colors have %1 pixels, the depths %2 pixels; give colors of the same camera and size",
                   sizeText(size), sizeText(window))};
    };
    return readImage(file, request, readColorImage);
}

} // namespace unprojector::cli
