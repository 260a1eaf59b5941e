#pragma once

#include "core/geometry/setup.h"
#include "core/pipeline/pipeline.h"
#include "core/ray/scene_rays.h"
#include "tests/support/example_scene.h"
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

using unprojector::scene::Scene;
using unprojector::scene::SceneObject;

/// A few roundings of numbers of order 1 to 100.
constexpr double kRounding = 1e-12;
/// Coordinates of order 100, taken forward and backward in double.
constexpr double kRoundTrip = 1e-10;
constexpr double kRightAngle = std::numbers::pi / 2.0;

/// The pipeline of an example's first object, in a window as large as the original's: the Pipeline
/// panel shows it.
inline unprojector::pipeline::Pipeline pipelineOf(const char *id)
{
    const Scene &scene = sceneOfExample(id);
    return unprojector::pipeline::pipelineOf(setupOf(scene, {800, 600, 1.0}, {}).value(),
                                             worldFromObject(scene.objects.at(0).transform))
        .value();
}

/// Returns the matrix by value: most pipelines passed here end with the expression.
inline glm::dmat4 forward(const unprojector::pipeline::Pipeline &pipeline, unprojector::pipeline::PipelineStage stage)
{
    return pipeline.matrix(stage, unprojector::pipeline::PipelineDirection::Forward);
}

/// A picture that fills a window of 800 x 600 pixels.
inline unprojector::geometry::Setup pictureBy(const unprojector::geometry::Projection &projection,
                                              const unprojector::geometry::LookAt &camera = {})
{
    const unprojector::geometry::Surface surface{800, 600, 1.0};
    return {surface, unprojector::geometry::wholeSurface(surface), unprojector::geometry::DepthRange{}, projection,
            camera};
}

/// OpenGL numbers a matrix's elements down the columns: m[12..14] is the translation.
inline double element(const glm::dmat4 &m, int index)
{
    return m[index / 4][index % 4];
}

/// The hit of a click on a quadrilateral.
inline std::optional<unprojector::ray::SceneHit>
hitOn(const std::vector<glm::vec3> &corners, const std::vector<unprojector::geometry::TransformStep> &transform,
      const unprojector::geometry::Setup &setup, const unprojector::geometry::DevicePoint &position,
      const std::vector<glm::dvec4> &clipPlanes = {})
{
    unprojector::mesh::Mesh mesh;
    mesh.positions = corners;
    mesh.indices = {0, 1, 2, 0, 2, 3};
    const std::array objects{SceneObject{"quadrilateral", {}, modelOf(std::move(mesh)), transform}};
    const std::array casters{unprojector::ray::RayCaster::build(objects[0].model, {})};
    return unprojector::ray::SceneRays(unprojector::unproject::Unprojector::of(setup).value(), objects, casters,
                                       clipPlanes)
        .at(position)
        .value();
}

/// The eye of the originals' programs, which call no gluLookAt.
inline const unprojector::geometry::LookAt kFromOrigin{
    unprojector::geometry::WorldPoint(0, 0, 0), unprojector::geometry::WorldPoint(0, 0, -1), {0, 1, 0}};
inline const unprojector::geometry::LookAt kFromFive{
    unprojector::geometry::WorldPoint(0, 0, 5), unprojector::geometry::WorldPoint(0, 0, 0), {0, 1, 0}};
/// A camera neither at the origin nor along an axis: 13 from its centre.
inline const unprojector::geometry::LookAt kFromAside{
    unprojector::geometry::WorldPoint(3, 4, 12), unprojector::geometry::WorldPoint(0, 0, 0), {0, 1, 0}};

} // namespace source_examples
