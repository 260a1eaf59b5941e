#pragma once

#include "core/geometry/matrix_projection.h"
#include "core/geometry/view_matrix.h"
#include "core/unproject/comparison.h"

#include <variant>

namespace unprojector::unproject {
using namespace geometry;

/// How a picture was taken, in the words of whichever program took it: parameters or matrices. What the window draws is
/// a ViewGeometry; this one also has pictures that no window here draws, because their far plane is at infinity or their
/// matrix is of no known form, and computes with them all the same.
struct PictureGeometry {
    Surface surface;
    Viewport viewport;
    DepthRange depthRange;
    std::variant<Projection, MatrixProjection> projection;
    std::variant<LookAt, glm::dmat4> view; ///< or eyeFromWorld
};

/// The NDC depths that the depth range stands for.
NdcDepth ndcDepthOf(const PictureGeometry &geometry);

/// @return the errors of clipFromEye; NotFinite of a matrix
Result<glm::dmat4> clipFromEye(const PictureGeometry &geometry);
/// @return the errors of eyeFrame; NotFinite of a matrix
Result<glm::dmat4> eyeFromWorld(const PictureGeometry &geometry);

/// @return as windowFromWorld of a ViewGeometry
Result<WindowPoint> windowFromWorld(const PictureGeometry &geometry, const WorldPoint &point);

/// Both methods side by side. Where a matrix has no form that the formulas hold for, they say so (MatrixNotAProjection,
/// ViewNotRigid), and the inverted matrix answers alone.
Comparison compareUnprojections(const PictureGeometry &geometry, const WindowPoint &window);

/// The same picture by parameters, for the window: a reversed matrix is one with its depth range turned round, and [0, 1]
/// one with its near plane where it is. A far plane at infinity is put at a million times near, where a depth differs by
/// less than a millionth.
/// @return the errors of recognised and lookAtFrom; MatrixNotAProjection for an eye space that looks along +z
Result<ViewGeometry> viewGeometry(const PictureGeometry &geometry);

} // namespace unprojector::unproject
