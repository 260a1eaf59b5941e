// Stub for builds without libtiff.

#include "core/images/formats.h"

namespace unprojector::images {

Numbers readTiff(ImageBytes &, const ImageRequest &)
{
    return noLibrary("TIFF", "libtiff", ".npy, PFM");
}

} // namespace unprojector::images
