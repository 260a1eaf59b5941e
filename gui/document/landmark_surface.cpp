#include "gui/document/landmark_surface.h"

#include "core/ray/closest_place.h"
#include "core/ray/tie_landmark.h"
#include "gui/document/scene_document.h"
#include "gui/document/scene_edits.h"

#include <algorithm>
#include <utility>

namespace unprojector::gui {
using namespace geometry;
using namespace scene;

namespace {

using landmarks::Landmark;

/// The targets that these points may lie on, prepared for queries.
std::vector<ray::TyingTarget> targetsOf(const SceneDocument &document, const std::vector<const Landmark *> &points)
{
    std::vector<ray::TyingTarget> targets;
    for (const SceneObject &object : document.objects()) {
        const auto names = [&](const Landmark *landmark) { return landmark->object == object.name; };
        const auto isOnAny = [&](const Landmark *landmark) {
            return std::none_of(document.objects().begin(), document.objects().end(),
                                [&](const SceneObject &other) { return other.name == landmark->object; });
        };
        const bool isAsked = std::any_of(points.begin(), points.end(), names)
                             || (!object.isHidden && std::any_of(points.begin(), points.end(), isOnAny));
        if (!isAsked || object.model->triangleCount() + object.model->pointCount() == 0)
            continue;
        if (auto places = ray::ClosestPlaces::build(object.model, {}))
            targets.push_back({object.name, std::move(places), worldFromObject(object.transform)});
    }
    return targets;
}

} // namespace

Check putOnSurface(SceneDocument &document, const std::vector<std::size_t> &indices)
{
    std::vector<Landmark> all = document.landmarks();
    std::vector<const Landmark *> asked;
    for (const std::size_t index : indices) {
        if (index < all.size() && all[index].isPlaced())
            asked.push_back(&document.landmarks()[index]);
    }
    if (asked.empty())
        return std::monostate{};
    const std::vector<ray::TyingTarget> targets = targetsOf(document, asked);
    for (const std::size_t index : indices) {
        if (index < all.size())
            static_cast<void>(ray::tieToMesh(all[index], targets));
    }
    const QString text = indices.size() == 1 ? SceneLandmarks::tr("Put %1 on the surface")
                                                   .arg(SceneLandmarks::shownNameOf(document.landmarks(), indices[0]))
                                             : SceneLandmarks::tr("Put %n landmarks on the surface", nullptr,
                                                                  static_cast<int>(indices.size()));
    return editLandmarks(document, std::move(all), {text});
}

} // namespace unprojector::gui
