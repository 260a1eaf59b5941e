#include "core/unproject/matrix_inverse.h"

#include "core/geometry/condition_number.h"
#include "core/geometry/finite.h"

#include <glm/matrix.hpp>

namespace unprojector::unproject {
using namespace geometry;

template <class Space, class Scalar>
Result<MatrixInverse<Space, Scalar>> MatrixInverse<Space, Scalar>::of(const glm::dmat4 &clipFromSpace,
                                                                      const Viewport &viewport, const DepthRange &range,
                                                                      NdcDepth ndcDepth)
{
    if (const Check valid = check(viewport); !valid)
        return valid.error();
    if (const Check valid = check(range); !valid)
        return valid.error();
    if (const auto value = firstNotFinite(clipFromSpace))
        return Error{ErrorCode::NotFinite, *value};
    if (isSingular(clipFromSpace))
        return Error{ErrorCode::SingularMatrix};
    return MatrixInverse(glm::inverse(Matrix(clipFromSpace)), viewport, range, ndcDepth);
}

template <class Space, class Scalar>
Result<glm::vec<4, Scalar>> MatrixInverse<Space, Scalar>::homogeneousAt(const WindowPoint &window) const
{
    if (const auto value = firstNotFinite(window))
        return Error{ErrorCode::NotFinite, *value};

    const auto &[vx, vy, width, height] = m_viewport;
    const Scalar two = 2, one = 1;
    const Scalar fromNear = Scalar(window.z) - Scalar(m_range.atNear), depth = Scalar(m_range.atFar - m_range.atNear);
    const glm::vec<4, Scalar> ndc(two * (Scalar(window.x) - Scalar(vx)) / Scalar(width) - one,
                                  two * (Scalar(window.y) - Scalar(vy)) / Scalar(height) - one,
                                  m_ndcDepth == NdcDepth::ZeroToOne ? fromNear / depth : two * fromNear / depth - one,
                                  one);
    return m_spaceFromClip * ndc;
}

template <class Space, class Scalar>
Result<Point<Space>> MatrixInverse<Space, Scalar>::at(const WindowPoint &window) const
{
    const Result<glm::vec<4, Scalar>> homogeneous = homogeneousAt(window);
    if (!homogeneous)
        return homogeneous.error();
    const glm::vec<4, Scalar> p = *homogeneous / homogeneous->w;
    if (!isFinite(p))
        return Error{ErrorCode::PointAtInfinity};
    return Point<Space>(double(p.x), double(p.y), double(p.z));
}

template class MatrixInverse<EyeSpace, double>;
template class MatrixInverse<EyeSpace, float>;
template class MatrixInverse<WorldSpace, double>;
template class MatrixInverse<WorldSpace, float>;
template class MatrixInverse<ObjectSpace, double>;
template class MatrixInverse<ObjectSpace, float>;

} // namespace unprojector::unproject
