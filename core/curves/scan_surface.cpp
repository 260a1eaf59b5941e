#include "core/curves/scan_surface.h"

#include "core/base/path_text.h"
#include "core/base/translation.h"
#include "core/curves/curve_line.h"
#include "core/mesh/import/mesh_import.h"

#include <vector>

namespace unprojector::curves {
using base::tr;
using geometry::Result;
using landmarks::Landmark;
namespace {

std::string reasonOf(const CurveError &error, const std::vector<const Landmark *> &points)
{
    switch (error.code) {
    case CurveError::Code::TooFew: return tr("it needs two landmarks");
    case CurveError::Code::Missing: return tr("\"%1\" has no position yet", points[error.point]->name);
    case CurveError::Code::NotOnSurface: return tr("\"%1\" is off the surface", points[error.point]->name);
    case CurveError::Code::NotConnected:
    case CurveError::Code::NoSection: return tr("no path on the surface leads to \"%1\"", points[error.point]->name);
    case CurveError::Code::Stopped: return tr("it was cancelled");
    }
    return {};
}

} // namespace

Result<landmarks::Measure, std::string> ScanSurface::length(std::span<const Landmark *const> points,
                                                            const Progress &goesOn)
{
    bool isStopped = false;
    const Progress progress = [&](double share) {
        isStopped = goesOn && !goesOn(share);
        return !isStopped;
    };
    if (!m_surface && m_problem.empty()) {
        const auto model = mesh::importModel(m_file, progress);
        if (isStopped)
            return tr("it was cancelled");
        if (!model) {
            m_problem = model.error().message();
        } else {
            m_target.name = base::utf8FromPath(m_file.filename());
            m_target.places = ray::ClosestPlaces::build(*model, progress);
            m_surface = m_target.places ? SurfaceMesh::build(**model, progress) : nullptr;
            if (!m_surface)
                return tr("it was cancelled");
        }
    }
    if (!m_surface)
        return m_problem;
    std::vector<Landmark> tied;
    tied.reserve(points.size());
    for (const Landmark *point : points) {
        Landmark &landmark = tied.emplace_back(*point);
        const std::optional<ray::Tied> moved = ray::tieToMesh(landmark, {&m_target, 1});
        if (!moved || moved->distance > ray::kFarFromMesh * m_target.places->model().bounds.diagonal())
            return tr("\"%1\" is off the surface", landmark.name);
    }
    std::vector<const Landmark *> places;
    places.reserve(tied.size());
    for (const Landmark &landmark : tied)
        places.push_back(&landmark);
    const auto line = lineThrough(*m_surface, places, landmarks::CurveKind::Geodesic, m_target.worldFromObject, goesOn);
    if (!line)
        return reasonOf(line.error(), places);
    return line->length;
}

} // namespace unprojector::curves
