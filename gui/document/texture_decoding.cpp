#include "gui/document/texture_decoding.h"

#include "core/base/translation.h"
#include "gui/text/error_text.h"

#include <QBuffer>
#include <QByteArray>
#include <QImage>
#include <QImageReader>

#include <cstring>
#include <memory>
#include <utility>

namespace unprojector::gui {
using namespace base;
using namespace mesh;

namespace {

/// Images with more pixels are not even decoded to be scaled down: that would take gigabytes.
constexpr qint64 kMostPixels = qint64{1} << 28;

std::shared_ptr<const Image> imageFrom(const QImage &picture)
{
    // An image's first row is its bottom one, as in texture coordinates and OpenGL.
    const QImage upright = picture.mirrored().convertToFormat(QImage::Format_RGBA8888);
    auto image = std::make_shared<Image>();
    image->widthPixels = upright.width();
    image->heightPixels = upright.height();
    const std::size_t rowBytes = 4 * static_cast<std::size_t>(upright.width());
    image->rgba.resize(rowBytes * static_cast<std::size_t>(upright.height()));
    for (int row = 0; row < upright.height(); ++row)
        std::memcpy(image->rgba.data() + rowBytes * static_cast<std::size_t>(row), upright.constScanLine(row),
                    rowBytes);
    return image;
}

void decode(Texture &texture, std::vector<Note> &notes)
{
    const std::string name = pathText(texture.file.filename()).toStdString();
    QByteArray bytes = QByteArray::fromRawData(reinterpret_cast<const char *>(texture.encoded.data()),
                                               static_cast<qsizetype>(texture.encoded.size()));
    QBuffer buffer(&bytes);
    buffer.open(QIODevice::ReadOnly);
    QImageReader reader(&buffer);
    QSize size = reader.size();
    const bool isTooLarge = qint64{size.width()} * size.height() > kMostPixels;
    const bool isScaledDown = size.width() > kMostTexturePixels || size.height() > kMostTexturePixels;
    if (isScaledDown) {
        size.scale(kMostTexturePixels, kMostTexturePixels, Qt::KeepAspectRatio);
        size = size.expandedTo(QSize(1, 1));
        reader.setScaledSize(size);
    }
    QImage picture = isTooLarge ? QImage() : reader.read();
    // Some formats don't state their size before decoding.
    if (picture.width() > kMostTexturePixels || picture.height() > kMostTexturePixels)
        picture = picture.scaled(kMostTexturePixels, kMostTexturePixels, Qt::KeepAspectRatio, Qt::SmoothTransformation);
    if (picture.isNull()) {
        notes.push_back(
            {marked("the image \"%1\" is damaged, too large or of an unknown format: its surfaces are shown "
                    "without it; convert it to PNG or JPEG, or make it smaller"),
             {name}});
    } else {
        texture.image = imageFrom(picture);
        if (isScaledDown)
            notes.push_back({marked(texture.image->widthPixels == 1
                                        ? "the image \"%1\" is too large and is shown with a width of %2 pixel"
                                        : "the image \"%1\" is too large and is shown with a width of %2 pixels"),
                             {name, std::to_string(texture.image->widthPixels)}});
    }
    texture.encoded = {};
}

} // namespace

void decodeTextures(Model &model, const std::function<bool()> &goOn)
{
    // Qt's limit is too low: 128 MB are an image of 5,800 by 5,800 pixels. kMostPixels replaces it.
    QImageReader::setAllocationLimit(0);
    bool isAnyUnusable = false;
    for (Texture &texture : model.textures) {
        if (!goOn())
            return;
        if (texture.encoded.empty())
            continue;
        decode(texture, model.notes);
        isAnyUnusable = isAnyUnusable || !texture.image;
    }
    if (isAnyUnusable && !QImageReader::supportedImageFormats().contains("jpeg"))
        model.notes.push_back(
            {marked("JPEG is not supported here: Qt's plugin for it is missing; convert the file to PNG")});
}

} // namespace unprojector::gui
