// Stub for builds without OpenEXR.

#include "core/images/formats.h"

namespace unprojector::images {

Numbers readExr(ImageBytes &, const ImageRequest &)
{
    return noLibrary("OpenEXR", "OpenEXR", ".npy, PFM");
}

} // namespace unprojector::images
