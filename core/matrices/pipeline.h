#pragma once

#include "core/geometry/api_conventions.h"
#include "core/geometry/given_point.h"
#include "core/geometry/setup.h"

#include <array>
#include <optional>
#include <vector>

namespace unprojector::matrices {

/// A matrix of the fixed pipeline, or a product of several. Forward it takes a point to the next space:
///
///   ModelMatrix       worldFromObject
///   ViewMatrix        eyeFromWorld
///   ProjectionMatrix  clipFromEye
///   ViewportMatrix    windowFromNdc; before it comes the division by w
///   ModelviewMatrix   eyeFromObject = view * model
///   WholeMatrix       windowFromObject = viewport * projection * view * model (MVPW); its result is homogeneous
enum class PipelineStage { ModelMatrix, ViewMatrix, ProjectionMatrix, ViewportMatrix, ModelviewMatrix, WholeMatrix };
constexpr std::array kPipelineStages{PipelineStage::ModelMatrix,      PipelineStage::ViewMatrix,
                                     PipelineStage::ProjectionMatrix, PipelineStage::ViewportMatrix,
                                     PipelineStage::ModelviewMatrix,  PipelineStage::WholeMatrix};

/// Forward: from the object to the widget. Backward: from the window to the object, by the inverse of each stage.
enum class PipelineDirection { Forward, Backward };

/// How one object of a picture gets to the window, and back.
struct Pipeline {
    geometry::Setup setup;
    std::array<glm::dmat4, kPipelineStages.size()> forward;
    /// objectFromWorld, worldFromEye, eyeFromClip, ndcFromWindow, objectFromEye, objectFromWindow
    std::array<glm::dmat4, kPipelineStages.size()> backward;

    const glm::dmat4 &matrix(PipelineStage stage, PipelineDirection direction) const;
};

/// All matrices of a picture. The inverses of view and viewport are those of a rigid and of a diagonal matrix, without
/// rounding noise; model and projection are inverted by glm::inverse; the products by those.
///
/// @param worldFromObject  of the object looked at, affine; the identity where there is none
/// @return the errors of check(setup); NotFinite (the value of the entry); SingularMatrix, also where the inverse
///         overflows
geometry::Result<Pipeline> pipeline(const geometry::Setup &setup, const glm::dmat4 &worldFromObject);

/// The same matrices as an API has them, from its own spaces to its own. The points of a pipeline stay those of this program:
/// ApiSpaces takes them there.
Pipeline inApi(const Pipeline &pipeline, const geometry::ApiSpaces &spaces);

/// One point in every space. Each stage says for itself why it has no answer; the stages after it have the same reason.
struct PipelinePoints {
    geometry::Result<geometry::ObjectPoint> object = geometry::ObjectPoint();
    geometry::Result<geometry::WorldPoint> world = geometry::WorldPoint();
    geometry::Result<geometry::EyePoint> eye = geometry::EyePoint();
    geometry::Result<geometry::ClipPoint> clip = geometry::ClipPoint();
    geometry::Result<geometry::NdcPoint> ndc = geometry::NdcPoint();
    geometry::Result<geometry::WindowPoint> window = geometry::WindowPoint();
    geometry::Result<geometry::DevicePoint> device = geometry::DevicePoint();
    geometry::Result<geometry::WidgetPoint> widget = geometry::WidgetPoint();
    /// On the way back: (x', y', z', w') = eyeFromClip (x_n, y_n, z_n, 1), before it is divided by its own w'.
    std::optional<glm::dvec4> undividedEye = std::nullopt;
};

/// Forward, stage by stage: object, world, eye, clip, divided by w, window, device, widget. A point behind the eye has
/// w < 0 and is taken through as well, as the matrices do.
/// @return PointAtInfinity from NDC on where w = 0; NotFinite from the stage on that overflows (or of the point given)
PipelinePoints pointsForward(const Pipeline &pipeline, const geometry::ObjectPoint &point);
/// The same for a world point; its object point is objectFromWorld * point.
PipelinePoints pointsForward(const Pipeline &pipeline, const geometry::WorldPoint &point);

/// Backward, each stage by the inverse of its matrix: window, NDC, eye, world, object. The division by w is undone as
/// gluUnProject does it, by another one:
///
///   (x', y', z', w') = eyeFromClip (x_n, y_n, z_n, 1),  eye = (x', y', z') / w'
///
/// The w that the division took is 1 / w', so that the clip point is (x_n, y_n, z_n, 1) / w'; the way does not need it.
/// @param window  device pixels, origin bottom-left; depth in the depth range (not required to be inside it)
/// @return PointAtInfinity from clip on where w' = 0; NotFinite as above
PipelinePoints pointsBackward(const Pipeline &pipeline, const geometry::WindowPoint &window);

/// Both ways from the space that the point is given in: towards the widget as forward, towards the object as backward. The
/// given coordinates themselves stay as they are. What a clip point comes from is found by
///
///   (x', y', z', w') = eyeFromClip (x, y, z, w),  eye = (x', y', z') / w'
///
/// so that a clip point and its multiples have one eye point; `undividedEye` is that of its NDC, as on the way back.
/// @return as pointsForward and pointsBackward, stage by stage
PipelinePoints pointsFrom(const Pipeline &pipeline, const geometry::GivenPoint &given);

/// Where a point lies that is not in the view volume, each with the inequality that says so.
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

/// The clip test, |x|, |y|, |z| <= w, as OpenGL does it: what a clip point fails of it, x before y before z. Of a point
/// behind the eye or in its plane only that is said, since there the others mean nothing.
/// @return nothing for a point inside the view volume or on its edge
std::vector<Outside> clipTest(const geometry::ClipPoint &point);

/// Whether a clip point lies inside the view volume or on its edge.
bool isInsideViewVolume(const geometry::ClipPoint &point);

} // namespace unprojector::matrices
