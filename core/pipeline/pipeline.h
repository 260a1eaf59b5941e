#pragma once

#include "core/geometry/api_conventions.h"
#include "core/geometry/given_point.h"
#include "core/geometry/setup.h"

#include <array>
#include <optional>
#include <vector>

namespace unprojector::pipeline {

/// A matrix of the fixed pipeline, or a product of several. Forward, it maps a point to the next
/// space:
///
///   ModelMatrix       worldFromObject
///   ViewMatrix        eyeFromWorld
///   ProjectionMatrix  clipFromEye
///   ViewportMatrix    windowFromNdc; the division by w comes before it
///   ModelviewMatrix   eyeFromObject = view * model
///   WholeMatrix       windowFromObject = viewport * projection * view * model (MVPW);
///                     its result is homogeneous
enum class PipelineStage { ModelMatrix, ViewMatrix, ProjectionMatrix, ViewportMatrix, ModelviewMatrix, WholeMatrix };
constexpr std::array kPipelineStages{PipelineStage::ModelMatrix,      PipelineStage::ViewMatrix,
                                     PipelineStage::ProjectionMatrix, PipelineStage::ViewportMatrix,
                                     PipelineStage::ModelviewMatrix,  PipelineStage::WholeMatrix};

/// Forward: from the object to the widget. Backward: from the window to the object, by the inverse
/// of each stage.
enum class PipelineDirection { Forward, Backward };

/// The matrices that map one object of a setup to the window, and back.
struct Pipeline {
    geometry::Setup setup;
    std::array<glm::dmat4, kPipelineStages.size()> forward;
    /// objectFromWorld, worldFromEye, eyeFromClip, ndcFromWindow, objectFromEye, objectFromWindow
    std::array<glm::dmat4, kPipelineStages.size()> backward;

    const glm::dmat4 &matrix(PipelineStage stage, PipelineDirection direction) const;
};

/// Computes all matrices of a setup. View and viewport are inverted as a rigid and a diagonal
/// matrix, without rounding noise. Model and projection are inverted by glm::inverse; the products
/// use these inverses.
///
/// @param worldFromObject  of the selected object, affine; the identity without one
/// @return the errors of check(setup); NotFinite (the value of the entry); SingularMatrix, also
///         where the inverse overflows
geometry::Result<Pipeline> pipelineOf(const geometry::Setup &setup, const glm::dmat4 &worldFromObject);

/// The same matrices in an API's conventions, between its own spaces. The points of a pipeline stay
/// in this program's spaces; ApiSpaces converts them.
Pipeline inApi(const Pipeline &pipeline, const geometry::ApiSpaces &spaces);

/// One point in every space. Each stage holds its own error; later stages repeat the first one.
struct PipelinePoints {
    geometry::Result<geometry::ObjectPoint> object = geometry::ObjectPoint();
    geometry::Result<geometry::WorldPoint> world = geometry::WorldPoint();
    geometry::Result<geometry::EyePoint> eye = geometry::EyePoint();
    geometry::Result<geometry::ClipPoint> clip = geometry::ClipPoint();
    geometry::Result<geometry::NdcPoint> ndc = geometry::NdcPoint();
    geometry::Result<geometry::WindowPoint> window = geometry::WindowPoint();
    geometry::Result<geometry::DevicePoint> device = geometry::DevicePoint();
    geometry::Result<geometry::WidgetPoint> widget = geometry::WidgetPoint();
    /// Set on the way back: (x', y', z', w') = eyeFromClip (x_n, y_n, z_n, 1), before its division
    /// by its own w'.
    std::optional<glm::dvec4> undividedEye = std::nullopt;
};

/// Maps a point forward, stage by stage: object, world, eye, clip, division by w, window, device,
/// widget. A point behind the eye has w < 0 and is mapped as well, as the matrices do.
/// @return PointAtInfinity from NDC on where w = 0; NotFinite from the first stage that overflows
///         (or of the given point)
PipelinePoints pointsForward(const Pipeline &pipeline, const geometry::ObjectPoint &point);
/// The same for a world point; its object point is objectFromWorld * point.
PipelinePoints pointsForward(const Pipeline &pipeline, const geometry::WorldPoint &point);

/// Maps a point backward, each stage by the inverse of its matrix: window, NDC, eye, world, object.
/// Like gluUnProject, it undoes the division by w with another division:
///
///   (x', y', z', w') = eyeFromClip (x_n, y_n, z_n, 1),  eye = (x', y', z') / w'
///
/// The w of the forward division is 1 / w', so the clip point is (x_n, y_n, z_n, 1) / w'. It is not
/// needed to compute the others.
/// @param window  device pixels, origin bottom-left; depth in the depth range (may lie outside it)
/// @return PointAtInfinity from clip on where w' = 0; NotFinite as above
PipelinePoints pointsBackward(const Pipeline &pipeline, const geometry::WindowPoint &window);

/// Maps a point both ways from the space in which it is given: forward to the widget, backward to
/// the object. The given coordinates stay unchanged. A clip point maps to the eye by
///
///   (x', y', z', w') = eyeFromClip (x, y, z, w),  eye = (x', y', z') / w'
///
/// so that a clip point and its multiples have one eye point. `undividedEye` is computed from its
/// NDC, as on the way back.
/// @return as pointsForward and pointsBackward, stage by stage
PipelinePoints pointsFrom(const Pipeline &pipeline, const geometry::GivenPoint &given);

/// The side on which a point lies outside the view volume, each with its inequality.
enum class Outside {
    Left,       ///< x < -w
    Right,      ///< x > w
    Bottom,     ///< y < -w
    Top,        ///< y > w
    Near,       ///< z < -w
    Far,        ///< z > w
    InEyePlane, ///< w = 0
    BehindEye   ///< w < 0
};

/// The clip test, |x|, |y|, |z| <= w, as OpenGL does it: the planes that a clip point violates, x
/// before y before z. For a point behind the eye or in its plane, only that is returned, since the
/// others mean nothing there.
/// @return nothing for a point inside the view volume or on its edge
std::vector<Outside> clipTest(const geometry::ClipPoint &point);

/// Returns whether a clip point lies inside the view volume or on its edge.
bool isInsideViewVolume(const geometry::ClipPoint &point);

} // namespace unprojector::pipeline
