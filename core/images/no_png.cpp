// Stub for builds without libpng.

#include "core/images/formats.h"

namespace unprojector::images {

Numbers readPng(ImageBytes &, const ImageRequest &)
{
    return noLibrary("PNG", "libpng", ".npy, PFM");
}

Colors readPngColors(ImageBytes &, const ImageRequest &)
{
    return noLibrary("PNG", "libpng", "JPEG");
}

} // namespace unprojector::images
