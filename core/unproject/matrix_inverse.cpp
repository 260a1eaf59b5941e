#include "core/unproject/matrix_inverse.h"

#include "core/geometry/condition_number.h"

#include <glm/matrix.hpp>

#include <cmath>

namespace unprojector::unproject {
using namespace geometry;
template <class Space, class Scalar>
Result<Point<Space>> unprojectByInverse(const glm::dmat4 &clipFromSpace, const Viewport &viewport,
                                        const DepthRange &range, const WindowPoint &window, NdcDepth ndcDepth)
{
    using Vec4 = glm::vec<4, Scalar>;
    using Mat4 = glm::mat<4, 4, Scalar>;

    if (const Check valid = check(viewport); !valid)
        return valid.error();
    if (const Check valid = check(range); !valid)
        return valid.error();
    for (const double value : {window.x, window.y, window.z}) {
        if (!std::isfinite(value))
            return Error{ErrorCode::NotFinite, value};
    }
    for (int column = 0; column < 4; ++column) {
        for (int row = 0; row < 4; ++row) {
            if (!std::isfinite(clipFromSpace[column][row]))
                return Error{ErrorCode::NotFinite, clipFromSpace[column][row]};
        }
    }
    if (isSingular(clipFromSpace))
        return Error{ErrorCode::SingularMatrix};

    const Scalar two = 2, one = 1;
    const Scalar fromNear = Scalar(window.z) - Scalar(range.atNear), depth = Scalar(range.atFar - range.atNear);
    const Vec4 ndc(two * (Scalar(window.x) - Scalar(viewport.x)) / Scalar(viewport.width) - one,
                   two * (Scalar(window.y) - Scalar(viewport.y)) / Scalar(viewport.height) - one,
                   ndcDepth == NdcDepth::ZeroToOne ? fromNear / depth : two * fromNear / depth - one, one);
    const Vec4 homogeneous = glm::inverse(Mat4(clipFromSpace)) * ndc;
    const Vec4 p = homogeneous / homogeneous.w;
    if (!(std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z)))
        return Error{ErrorCode::PointAtInfinity};
    return Point<Space>(double(p.x), double(p.y), double(p.z));
}

#define UNPROJECTOR_INSTANTIATE(Space)                                                                                 \
    template Result<Point<Space>> unprojectByInverse<Space, double>(                                                   \
        const glm::dmat4 &, const Viewport &, const DepthRange &, const WindowPoint &, NdcDepth);                      \
    template Result<Point<Space>> unprojectByInverse<Space, float>(const glm::dmat4 &, const Viewport &,               \
                                                                   const DepthRange &, const WindowPoint &, NdcDepth)
UNPROJECTOR_INSTANTIATE(EyeSpace);
UNPROJECTOR_INSTANTIATE(WorldSpace);
UNPROJECTOR_INSTANTIATE(ObjectSpace);
#undef UNPROJECTOR_INSTANTIATE

} // namespace unprojector::unproject
