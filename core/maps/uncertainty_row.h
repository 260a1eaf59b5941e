#pragma once

#include "core/maps/surface_image.h"
#include "core/scene/scene.h"
#include "core/unproject/certainty.h"
#include "core/unproject/depth_error.h"

#include <span>
#include <vector>

namespace unprojector::maps {

/// The uncertainty of clicks on a view's pixels, as a click reports it when its triangle is known
/// (see unproject::Pick). It uses the slope of the depths around a pixel, and vertices shifted as
/// by the renderer.
class UncertaintyRow {
public:
    /// @param setup              by parameters
    /// @param objects            must outlive this
    /// @param cornerShiftPixels  see DepthSample
    UncertaintyRow(const geometry::Setup &setup, std::span<const scene::SceneObject> objects, double cornerShiftPixels);

    /// The length of the ± in world space.
    /// @param surfaces    of the pixel's row and its neighbouring rows; @pre surfaces.isMet()
    /// @param pixel       with a surface
    /// @param eye, world  the pixel's point by the formulas
    double at(const SurfaceImage &surfaces, const geometry::DevicePixel &pixel, const geometry::EyePoint &eye,
              const geometry::WorldPoint &world) const;

private:
    /// A prepared mesh of an object.
    struct PreparedMesh {
        const mesh::Mesh *mesh;
        std::size_t before; ///< triangles in the object's meshes before this one
        unproject::DepthErrors errors;
    };

    geometry::Setup m_setup;
    double m_cornerShiftPixels;
    unproject::Certainties m_certainties;
    std::vector<std::vector<PreparedMesh>> m_meshes; ///< one list per object
};

} // namespace unprojector::maps
