#pragma once

#include "core/curves/surface_mesh.h"
#include "core/curves/surface_path.h"
#include "core/geometry/result.h"
#include "core/landmarks/measure.h"
#include "core/ray/tie_landmark.h"

#include <filesystem>
#include <memory>
#include <span>
#include <string>

namespace unprojector::curves {

/// Lengths along the surface of a model file between landmarks in the file's own coordinates. The
/// file is read when the first length is asked for.
class ScanSurface {
public:
    explicit ScanSurface(std::filesystem::path file) : m_file(std::move(file)) {}

    const std::filesystem::path &file() const { return m_file; }
    /// The length of the geodesics through landmarks, in their order. Each counts where the surface is
    /// closest to it.
    /// @param goesOn  may be empty
    /// @return or the reason why there is none, a clause: the file cannot be read, a landmark is
    ///         farther from the surface than ray::kFarFromMesh, or there is no path
    geometry::Result<landmarks::Measure, std::string> length(std::span<const landmarks::Landmark *const> points,
                                                             const Progress &goesOn);

private:
    std::filesystem::path m_file;
    ray::TyingTarget m_target;
    std::shared_ptr<const SurfaceMesh> m_surface; ///< null: not read yet
    std::string m_problem;                        ///< why the file cannot be read
};

} // namespace unprojector::curves
