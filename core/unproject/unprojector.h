#pragma once

#include "core/geometry/picture.h"
#include "core/unproject/answers.h"
#include "core/unproject/matrix_inverse.h"

#include <glm/mat4x4.hpp>

#include <optional>

namespace unprojector::unproject {
using namespace geometry;

/// A picture prepared for unprojecting: checked, its axes and its inverses computed once. Every click goes through one, in the
/// window, in a file of clicks and where methods are compared; a ClickBatch computes the same for many rows.
///
/// The way of a click: widget position -> device pixel -> its centre -> the y flip (geometry/viewport) -> window point ->
/// eye point by the closed form (unproject/closed_form, geometry/matrix_projection) and by the inverse of clipFromEye
/// (unproject/matrix_inverse) -> world point by the camera's axes (geometry/camera, geometry/view_matrix) and by the
/// inverse of clipFromWorld.
class Unprojector {
public:
    /// @return the errors of check(picture). What only one method cannot do (a matrix without an inverse, a matrix that
    ///         is no known projection) that method says for each point
    static Result<Unprojector> of(const Picture &picture);

    const Picture &picture() const { return m_picture; }

    /// A window position by every method.
    Unprojected at(const WindowPoint &window) const;
    /// The same by one method and to one space, for tables.
    Result<EyePoint> eyeAt(Method method, const WindowPoint &window) const;
    Result<WorldPoint> worldAt(Method method, const WindowPoint &window) const;

private:
    explicit Unprojector(const Picture &picture);

    Result<PrecisePoint<EyeSpace>> preciseEyeAt(const WindowPoint &window) const;
    Result<WorldPoint> worldByFormula(const Result<PrecisePoint<EyeSpace>> &eye) const;
    template <class Space>
    struct Inverses {
        Result<MatrixInverse<Space, double>> inDouble;
        Result<MatrixInverse<Space, float>> inFloat;

        static Inverses of(const Result<glm::dmat4> &clipFromSpace, const Picture &picture);
        Result<Point<Space>> at(Method method, const WindowPoint &window) const;
    };

    Picture m_picture;
    std::optional<PreciseEyeFrame> m_frame; ///< of a pose by parameters
    Inverses<EyeSpace> m_eye;
    Inverses<WorldSpace> m_world;
};

} // namespace unprojector::unproject
