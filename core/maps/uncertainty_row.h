#pragma once

#include "core/maps/surface_image.h"
#include "core/scene/scene.h"
#include "core/unproject/certainty.h"
#include "core/unproject/depth_error.h"

#include <span>
#include <vector>

namespace unprojector::maps {

/// How sure clicks on a picture's pixels are, as a click states it once its triangle is known (see unproject::Pick): with the
/// slope that the depths around a pixel show, and corners that are moved as the renderer does.
class UncertaintyRow {
public:
    /// @param setup              by parameters
    /// @param objects            outlive this
    /// @param cornerShiftPixels  as DepthSample has it
    UncertaintyRow(const geometry::Setup &setup, std::span<const scene::SceneObject> objects, double cornerShiftPixels);

    /// The length of the +- in world space.
    /// @param surfaces    of the pixel's row and of those beside it; @pre surfaces.isMet()
    /// @param pixel       with a surface
    /// @param eye, world  its formulas' point
    double at(const SurfaceImage &surfaces, const geometry::DevicePixel &pixel, const geometry::EyePoint &eye,
              const geometry::WorldPoint &world) const;

private:
    /// A mesh of an object, prepared.
    struct PreparedMesh {
        const mesh::Mesh *mesh;
        std::size_t before; ///< triangles of the object's meshes before it
        unproject::DepthErrors errors;
    };

    geometry::Setup m_setup;
    double m_cornerShiftPixels;
    unproject::Certainties m_certainties;
    std::vector<std::vector<PreparedMesh>> m_meshes; ///< of each object
};

} // namespace unprojector::maps
