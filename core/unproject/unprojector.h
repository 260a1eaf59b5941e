#pragma once

#include "core/geometry/setup.h"
#include "core/unproject/answers.h"
#include "core/unproject/matrix_inverse.h"
#include "core/unproject/object_from_world.h"

#include <glm/mat4x4.hpp>

#include <optional>

namespace unprojector::unproject {

/// A setup prepared for unprojecting: checked, with its axes and inverses computed once. Every
/// click uses one, in the window, in a file of clicks and in comparisons of methods; a ClickBatch
/// computes the same for many rows.
///
/// The stages of a click: widget position -> device pixel -> its centre -> the y flip
/// (geometry/viewport) -> window point -> eye point by the closed form (unproject/closed_form,
/// geometry/matrix_projection) and by the inverse of clipFromEye (unproject/matrix_inverse) ->
/// world point by the camera's axes (geometry/camera, geometry/view_matrix) and by the inverse of
/// clipFromWorld.
class Unprojector {
public:
    /// @return the errors of check(setup). If only one method fails (a matrix without an inverse, a
    ///         matrix that is no known projection), that method returns the error for each point
    static geometry::Result<Unprojector> of(const geometry::Setup &setup);

    const geometry::Setup &setup() const { return m_setup; }

    /// A window position, rounded or not. A matrix takes it rounded.
    using PreciseWindow = geometry::PrecisePoint<geometry::WindowSpace>;

    /// The point at a window position by every method.
    Unprojected at(const PreciseWindow &window) const;
    /// The same by one method in one space, for tables.
    geometry::Result<geometry::EyePoint> eyeAt(Method method, const PreciseWindow &window) const;
    geometry::Result<geometry::WorldPoint> worldAt(Method method, const PreciseWindow &window) const;
    /// The same in an object's space. The formula's world point is not rounded before.
    geometry::Result<geometry::ObjectPoint> objectAt(Method method, const PreciseWindow &window,
                                                     const ObjectFromWorld &object) const;

private:
    explicit Unprojector(const geometry::Setup &setup);

    geometry::Result<geometry::PrecisePoint<geometry::EyeSpace>> preciseEyeAt(const PreciseWindow &window) const;
    geometry::Result<geometry::PrecisePoint<geometry::WorldSpace>>
    worldByFormula(const geometry::Result<geometry::PrecisePoint<geometry::EyeSpace>> &eye) const;
    template <class Space>
    struct Inverses {
        geometry::Result<MatrixInverse<Space, double>> inDouble;
        geometry::Result<MatrixInverse<Space, float>> inFloat;

        static Inverses of(const geometry::Result<glm::dmat4> &clipFromSpace, const geometry::Setup &setup);
        geometry::Result<geometry::Point<Space>> at(Method method, const PreciseWindow &window) const;
    };

    geometry::Setup m_setup;
    std::optional<geometry::PreciseEyeFrame> m_frame; ///< for a pose by parameters
    Inverses<geometry::EyeSpace> m_eye;
    Inverses<geometry::WorldSpace> m_world;
};

} // namespace unprojector::unproject
