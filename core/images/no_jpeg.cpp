// Stub for builds without libjpeg.

#include "core/images/formats.h"

namespace unprojector::images {

Colors readJpegColors(ImageBytes &, const ImageRequest &)
{
    return noLibrary("JPEG", "libjpeg", "PNG");
}

} // namespace unprojector::images
