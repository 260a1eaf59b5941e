#pragma once

#include "core/examples/examples.h"
#include "core/geometry/picture.h"
#include "core/matrices/pipeline.h"
#include "core/ray/scene_rays.h"
#include "tests/support/mesh_model.h"
#include "tests/support/unprojecting.h"

#include <QtGlobal>

#include <algorithm>
#include <array>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

// The originals' programs as the examples have them, and the cameras that the originals use.
namespace source_examples {

using namespace unprojector;
using namespace unprojector::geometry;
using namespace unprojector::matrices;
using namespace unprojector::unproject;
using unprojector::scene::Scene;
using unprojector::scene::SceneObject;

/// A few roundings of numbers of order 1 to 100.
constexpr double kRounding = 1e-12;
/// Coordinates of order 100, taken forward and backward in double.
constexpr double kRoundTrip = 1e-10;
constexpr double kRightAngle = std::numbers::pi / 2.0;

inline const Scene &exampleScene(const char *id)
{
    static const std::vector<examples::Example> all = examples::examples();
    const auto found = std::find_if(all.begin(), all.end(), [id](const examples::Example &e) { return e.id == id; });
    if (found == all.end())
        qFatal("There is no example %s.", id);
    return found->scene;
}

/// Of an example's first object, in a window as large as the original's: what the Pipeline panel shows.
inline Pipeline pipelineOf(const char *id)
{
    const Scene &scene = exampleScene(id);
    return pipeline(pictureOf(scene, {800, 600, 1.0}, {}).value(), worldFromObject(scene.objects.at(0).transform))
        .value();
}

/// By value: most of the pipelines that it is given end with the expression.
inline glm::dmat4 forward(const Pipeline &pipeline, PipelineStage stage)
{
    return pipeline.matrix(stage, PipelineDirection::Forward);
}

/// A picture that fills a window of 800 x 600 pixels.
inline Picture pictureBy(const Projection &projection, const LookAt &camera = {})
{
    const Surface surface{800, 600, 1.0};
    return {surface, wholeSurface(surface), DepthRange{}, projection, camera};
}

/// OpenGL numbers a matrix's elements down the columns: m[12..14] is the translation.
inline double element(const glm::dmat4 &m, int index)
{
    return m[index / 4][index % 4];
}

/// What a click meets of a quadrilateral.
inline std::optional<ray::SceneHit> hitOn(const std::vector<glm::vec3> &corners,
                                          const std::vector<TransformStep> &transform, const Picture &picture,
                                          const DevicePoint &position, const std::vector<glm::dvec4> &clipPlanes = {})
{
    mesh::Mesh mesh;
    mesh.positions = corners;
    mesh.indices = {0, 1, 2, 0, 2, 3};
    const std::array objects{SceneObject{"quadrilateral", {}, modelOf(std::move(mesh)), transform}};
    const std::array casters{ray::RayCaster::build(objects[0].model, {})};
    return ray::SceneRays(Unprojector::of(picture).value(), objects, casters, clipPlanes).at(position).value();
}

/// The eye of the originals' programs, which call no gluLookAt.
inline const LookAt kFromOrigin{WorldPoint(0, 0, 0), WorldPoint(0, 0, -1), {0, 1, 0}};
inline const LookAt kFromFive{WorldPoint(0, 0, 5), WorldPoint(0, 0, 0), {0, 1, 0}};
/// Neither at the origin nor along an axis: 13 from where it looks.
inline const LookAt kFromAside{WorldPoint(3, 4, 12), WorldPoint(0, 0, 0), {0, 1, 0}};

} // namespace source_examples
