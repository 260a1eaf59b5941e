#include "gui/document/clip_cuts.h"

#include "gui/document/scene_document.h"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>

namespace unprojector::gui {
using namespace geometry;
using namespace scene;

namespace {

/// Adds the plane through a point that keeps the side the normal points to.
CutFault addCut(SceneDocument &document, const WorldPoint &point, const glm::dvec3 &normal)
{
    if (document.scene().clipPlanes.size() + document.scene().clipPlanesOff.size() >= kMostClipPlanes)
        return CutFault::TooMany;
    const glm::dvec4 plane(normal, -glm::dot(normal, point.coordinates()));
    const Check added = document.edit({SceneDocument::tr("Add clip plane")},
                                      [&plane](Scene &scene) { scene.clipPlanes.push_back(plane); });
    return added ? CutFault::None : CutFault::Refused;
}

/// The index of the last plane that cuts, among all planes. @pre there is one
std::size_t lastCut(const Scene &scene)
{
    std::size_t index = scene.clipPlanes.size() + scene.clipPlanesOff.size();
    const auto isOff = [&scene](std::size_t number) {
        return std::any_of(scene.clipPlanesOff.begin(), scene.clipPlanesOff.end(),
                           [number](const ClipPlaneOff &off) { return off.index == number; });
    };
    while (index > 0 && isOff(index - 1))
        --index;
    return index > 0 ? index - 1 : 0;
}

} // namespace

CutFault cutAcrossView(SceneDocument &document, const WorldPoint &point)
{
    const Result<EyeFrame> frame = eyeFrame(document.setup().camera());
    return frame ? addCut(document, point, frame->forward.coordinates()) : CutFault::NoDirection;
}

CutFault cutAlongView(SceneDocument &document, const WorldPoint &a, const WorldPoint &b)
{
    const Result<glm::dmat4> matrix = clipFromWorld(document.setup());
    if (!matrix)
        return CutFault::NoDirection;
    // Along the ray of a, NDC x and y stay: x_clip - x_ndc w = 0 and y_clip - y_ndc w = 0.
    const glm::dvec4 clip = *matrix * glm::dvec4(a.coordinates(), 1.0);
    const glm::dmat4 rows = glm::transpose(*matrix);
    const glm::dvec3 x(rows[0] * clip.w - rows[3] * clip.x), y(rows[1] * clip.w - rows[3] * clip.y);
    const glm::dvec3 ray = glm::cross(x, y), way = b.coordinates() - a.coordinates();
    const double rayLength = glm::length(ray), wayLength = glm::length(way);
    if (!(rayLength > 0.0 && wayLength > 0.0))
        return CutFault::NoDirection;
    glm::dvec3 normal = glm::cross(ray / rayLength, way / wayLength);
    constexpr double kSmallestSine = 1e-6;
    if (!(glm::length(normal) > kSmallestSine))
        return CutFault::NoDirection;
    normal = glm::normalize(normal);
    const glm::dvec3 middle = document.bounds().isEmpty() ? glm::dvec3(0.0) : document.bounds().center();
    if (glm::dot(normal, middle - a.coordinates()) < 0.0)
        normal = -normal;
    return addCut(document, a, normal);
}

bool flipLastCut(SceneDocument &document)
{
    if (document.scene().clipPlanes.empty())
        return false;
    return static_cast<bool>(document.edit({SceneDocument::tr("Flip clip plane")},
                                           [](Scene &scene) { scene.clipPlanes.back() = -scene.clipPlanes.back(); }));
}

bool removeLastCut(SceneDocument &document)
{
    if (document.scene().clipPlanes.empty())
        return false;
    return static_cast<bool>(document.edit({SceneDocument::tr("Remove clip plane")}, [](Scene &scene) {
        const std::size_t removed = lastCut(scene);
        scene.clipPlanes.pop_back();
        for (ClipPlaneOff &off : scene.clipPlanesOff) {
            if (off.index > removed)
                --off.index;
        }
    }));
}

} // namespace unprojector::gui
