#include "core/curves/measured_sets.h"

#include "core/base/path_text.h"
#include "core/base/translation.h"
#include "core/curves/curve_line.h"
#include "core/mesh/import/mesh_import.h"
#include "core/ray/tie_landmark.h"

#include <cassert>
#include <memory>

namespace unprojector::curves {
using base::tr;
using namespace geometry;
using namespace landmarks;
namespace {

/// The surface of a model file, in the file's own coordinates.
struct ScanSurface {
    std::filesystem::path file;
    ray::TyingTarget target = {};
    std::shared_ptr<const SurfaceMesh> mesh = {}; ///< null: it cannot be read, or the user stopped
    std::string problem = {};                     ///< why it cannot be read
};

ScanSurface surfaceOf(const std::filesystem::path &file, const base::Progress &progress)
{
    ScanSurface surface{file};
    const auto model = mesh::importModel(file, progress);
    if (!model) {
        surface.problem = model.error().message();
        return surface;
    }
    surface.target.name = base::utf8FromPath(file.filename());
    surface.target.places = ray::ClosestPlaces::build(*model, progress);
    if (surface.target.places)
        surface.mesh = SurfaceMesh::build(**model, progress);
    return surface;
}

/// The length of the geodesics through landmarks, in their order. Each counts where the surface is
/// closest to it.
/// @return or the reason why there is none, a clause: a landmark is farther from the surface than
///         ray::kFarFromMesh, or there is no path
/// @pre there are at least two landmarks
Result<Measure, std::string> lengthAlong(const ScanSurface &surface, std::span<const Landmark *const> points,
                                         const base::Progress &progress)
{
    assert(points.size() >= landmarks::sizeOf(landmarks::MeasureKind::Surface).fewest);
    std::vector<Landmark> tied;
    tied.reserve(points.size());
    std::vector<const Landmark *> places;
    for (const Landmark *point : points) {
        const std::optional<ray::Tied> moved = ray::tieToMesh(tied.emplace_back(*point), {&surface.target, 1});
        if (!moved || moved->distance > ray::kFarFromMesh * surface.target.places->model().bounds.diagonal())
            return tr("\"%1\" is off the surface", point->name);
        places.push_back(&tied.back());
    }
    const auto line = lineThrough(*surface.mesh, places, CurveKind::Geodesic, surface.target.worldFromObject, progress);
    if (line)
        return line->length;
    const std::string &name = places[line.error().point]->name;
    return line.error().code == CurveError::Code::NotConnected ? tr("no path on the surface leads to \"%1\"", name)
                                                               : tr("\"%1\" is off the surface", name);
}

} // namespace

std::optional<std::vector<std::vector<ProtocolValue>>>
measuredSets(std::span<const LandmarkSet> sets, std::span<const KeptMeasure> measures,
             const std::function<Result<std::filesystem::path, std::string>(std::size_t)> &modelOf,
             const std::function<bool(std::size_t)> &goesOn)
try {
    const base::InEnglish english;
    std::vector<std::vector<ProtocolValue>> all;
    std::optional<ScanSurface> surface;
    for (std::size_t i = 0; i < sets.size(); ++i) {
        bool isStopped = false;
        const base::Progress progress = [&](double) {
            isStopped = isStopped || (goesOn && !goesOn(i));
            return !isStopped;
        };
        const auto along = [&](std::span<const Landmark *const> points) -> Result<Measure, std::string> {
            const auto model = modelOf(i);
            if (!model)
                return model.error();
            if (!surface || surface->file != *model)
                surface = surfaceOf(*model, progress);
            if (isStopped)
                throw base::Stopped{};
            if (!surface->mesh)
                return surface->problem;
            return lengthAlong(*surface, points, progress);
        };
        std::vector<ProtocolValue> &values = all.emplace_back();
        for (const KeptMeasure &measure : measures)
            values.push_back(valueOf(measure, sets[i], along));
    }
    return all;
} catch (const base::Stopped &) {
    return std::nullopt;
}

} // namespace unprojector::curves
