#include "core/curves/curve_line.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <optional>
#include <utility>

namespace unprojector::curves {
using namespace geometry;
using namespace landmarks;

namespace {

/// The unit direction from one point to another; 0 if they coincide.
glm::dvec3 wayFrom(const WorldPoint &a, const WorldPoint &b)
{
    const glm::dvec3 way = b.coordinates() - a.coordinates();
    const double length = glm::length(way);
    return length > 0.0 ? way / length : glm::dvec3(0.0);
}

} // namespace

Result<CurveLine, CurveError> lineThrough(const SurfaceMesh &mesh, std::span<const Landmark *const> points,
                                          CurveKind kind, const glm::dmat4 &worldFromObject,
                                          const base::Progress &progress)
{
    if (points.size() < 2)
        return CurveError{CurveError::Code::TooFew, 0};
    std::vector<SurfacePlace> places;
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (!points[i]->isPlaced())
            return CurveError{CurveError::Code::Missing, i};
        const std::optional<SurfacePlace> place = placeOf(points[i]->anchor, mesh);
        if (!place)
            return CurveError{CurveError::Code::NotOnSurface, i};
        places.push_back(*place);
    }
    CurveLine line;
    std::vector<glm::dvec3> gradients(points.size(), glm::dvec3(0.0));
    for (std::size_t i = 1; i < points.size(); ++i) {
        const base::Progress ofPiece = [&](double share) {
            return !progress || progress((double(i - 1) + share) / double(points.size() - 1));
        };
        const bool isGeodesic = kind == CurveKind::Geodesic;
        const std::optional<SurfacePath> piece =
            isGeodesic ? geodesic(mesh, places[i - 1], places[i], worldFromObject, ofPiece)
                       : planeSection(mesh, places[i - 1], places[i], worldFromObject, ofPiece);
        if (!piece)
            return CurveError{isGeodesic ? CurveError::Code::NotConnected : CurveError::Code::NoSection, i};
        const std::vector<WorldPoint> &way = piece->places;
        line.length.value += piece->length;
        if (way.size() > 1) {
            gradients[i - 1] += wayFrom(way[1], way[0]);
            gradients[i] += wayFrom(way[way.size() - 2], way.back());
        }
        line.path.insert(line.path.end(), way.begin() + (line.path.empty() ? 0 : 1), way.end());
    }
    line.length.error = 0.0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (!points[i]->uncertainty)
            line.length.error = std::nullopt;
        if (line.length.error)
            *line.length.error += glm::dot(glm::abs(gradients[i]), glm::abs(points[i]->uncertainty->coordinates()));
    }
    return line;
}

std::vector<WorldPoint> resampled(std::span<const WorldPoint> path, std::size_t count)
{
    std::vector<double> reached{0.0}; // distance along the path, at each of its points
    for (std::size_t i = 1; i < path.size(); ++i)
        reached.push_back(reached.back() + glm::distance(path[i - 1].coordinates(), path[i].coordinates()));
    std::vector<WorldPoint> places;
    places.reserve(count);
    std::size_t piece = 1;
    for (std::size_t i = 0; i + 1 < count; ++i) {
        const double wanted = reached.back() * double(i) / double(count - 1);
        while (piece + 1 < path.size() && reached[piece] < wanted)
            ++piece;
        if (piece >= path.size()) {
            places.push_back(path.front());
            continue;
        }
        const double length = reached[piece] - reached[piece - 1];
        const double share = length > 0.0 ? std::clamp((wanted - reached[piece - 1]) / length, 0.0, 1.0) : 0.0;
        places.push_back(WorldPoint((1.0 - share) * path[piece - 1].coordinates() + share * path[piece].coordinates()));
    }
    places.push_back(path.back());
    return places;
}

} // namespace unprojector::curves
