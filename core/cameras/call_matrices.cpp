#include "core/cameras/call_matrices.h"

#include <algorithm>
#include <variant>

namespace unprojector::cameras {
using namespace geometry;

Check check(const Ortho &v, bool isPerspective)
{
    if (isPerspective && std::min(v.nearDistance, v.farDistance) <= 0.0)
        return Error{ErrorCode::NearNotPositive, std::min(v.nearDistance, v.farDistance)};
    if (v.left == v.right)
        return Error{ErrorCode::LeftEqualsRight, v.left};
    if (v.bottom == v.top)
        return Error{ErrorCode::BottomEqualsTop, v.bottom};
    if (v.nearDistance == v.farDistance)
        return Error{ErrorCode::NearNotBeforeFar, v.nearDistance, v.farDistance};
    return std::monostate{};
}

glm::dmat4 clipFromEye(const Ortho &v, const CallSignature &signature)
{
    const double n = v.nearDistance, f = v.farDistance, width = v.right - v.left, height = v.top - v.bottom;
    const bool isZeroToOne = signature.ndcDepth == NdcDepth::ZeroToOne;
    glm::dmat4 m(0.0);
    if (signature.isPerspective) {
        m[0][0] = 2.0 * n / width;
        m[1][1] = 2.0 * n / height;
        m[2] = {(v.right + v.left) / width, (v.top + v.bottom) / height, -(isZeroToOne ? f : f + n) / (f - n), -1.0};
        m[3][2] = -(isZeroToOne ? 1.0 : 2.0) * f * n / (f - n);
    } else {
        m[0][0] = 2.0 / width;
        m[1][1] = 2.0 / height;
        m[2][2] = -(isZeroToOne ? 1.0 : 2.0) / (f - n);
        m[3] = {-(v.right + v.left) / width, -(v.top + v.bottom) / height, -(isZeroToOne ? n : f + n) / (f - n), 1.0};
    }
    if (signature.isLeftHanded)
        m[2] = -m[2];
    return m;
}

Result<glm::dmat4> eyeFromWorld(const LookAt &camera, bool isLeftHanded)
{
    const Result<EyeFrame> frame = eyeFrame(camera);
    if (!frame)
        return frame.error();
    glm::dmat4 m = geometry::eyeFromWorld(*frame);
    if (isLeftHanded) {
        for (int column = 0; column < 4; ++column) {
            m[column][0] = -m[column][0];
            m[column][2] = -m[column][2];
        }
    }
    return m;
}

} // namespace unprojector::cameras
