#include "core/lessons/highlights.h"

#include "core/geometry/view_volume.h"

#include <glm/geometric.hpp>

#include <algorithm>

namespace unprojector::lessons {
using namespace geometry;
using namespace scene;

namespace {

/// The object whose axes are MC; null in a scene without objects.
const SceneObject *modelOf(const Scene &scene)
{
    if (scene.givenPoint) {
        const auto followed = std::find_if(scene.objects.begin(), scene.objects.end(), [&](const SceneObject &one) {
            return one.name == scene.givenPoint->object;
        });
        if (followed != scene.objects.end())
            return &*followed;
    }
    return scene.objects.empty() ? nullptr : &scene.objects.front();
}

} // namespace

std::vector<NamedAxes> namedAxes(const Scene &scene, const EyeFrame &eye)
{
    std::vector<NamedAxes> all;
    std::string world = "WC";
    if (const SceneObject *object = modelOf(scene)) {
        const glm::dmat4 worldFromModel = geometry::worldFromObject(object->transform);
        NamedAxes model{"MC", WorldPoint(glm::dvec3(worldFromModel[3])), {}};
        for (int axis = 0; axis < 3; ++axis)
            model.directions[static_cast<std::size_t>(axis)] =
                WorldVector(glm::normalize(glm::dvec3(worldFromModel[axis])));
        if (worldFromModel == glm::dmat4(1.0))
            world = "MC = WC";
        else
            all.push_back(std::move(model));
    }
    all.push_back({world, WorldPoint(), {WorldVector(1, 0, 0), WorldVector(0, 1, 0), WorldVector(0, 0, 1)}});
    all.push_back({"VC", eye.eye, {eye.side, eye.upward, -eye.forward}});
    return all;
}

std::array<LetterAt<EyeSpace>, 6> volumeLetters(const Projection &projection)
{
    const std::array<EyePoint, 8> corners = viewVolumeCorners(projection);
    constexpr std::array kLetters{"l", "r", "b", "t", "n", "f"};
    std::array<LetterAt<EyeSpace>, 6> letters;
    for (std::size_t side = 0; side < letters.size(); ++side) {
        // One bit of the corners' indices for each pair of sides.
        const std::size_t bit = std::size_t(1) << (side / 2), value = side % 2 == 0 ? 0 : bit;
        glm::dvec3 sum(0.0);
        for (std::size_t i = 0; i < corners.size(); ++i) {
            if ((i & bit) == value)
                sum += corners[i].coordinates();
        }
        letters[side] = {{kLetters[side], ""}, EyePoint(sum / 4.0)};
    }
    return letters;
}

std::array<LetterAt<NdcSpace>, 6> cubeLetters()
{
    const Letter low{"−1", ""}, high{"1", ""};
    return {{{low, NdcPoint(-1, 0, 0)},
             {high, NdcPoint(1, 0, 0)},
             {low, NdcPoint(0, -1, 0)},
             {high, NdcPoint(0, 1, 0)},
             {low, NdcPoint(0, 0, -1)},
             {high, NdcPoint(0, 0, 1)}}};
}

std::vector<LetteredArrow> viewportArrows(const Viewport &viewport, const Surface &surface, double inset)
{
    using enum LetteredArrow::Kind;
    const double right = viewport.x + viewport.width, top = viewport.y + viewport.height;
    const double width = surface.widthPixels, height = surface.heightPixels;
    const double middleX = viewport.x + viewport.width / 2.0, middleY = viewport.y + viewport.height / 2.0;
    std::vector<LetteredArrow> arrows{
        {Axis, {"x", "v"}, WindowPoint(inset, inset, 0), WindowPoint(width - inset, inset, 0)},
        {Axis, {"y", "v"}, WindowPoint(inset, inset, 0), WindowPoint(inset, height - inset, 0)},
        {Length, {"width", ""}, WindowPoint(viewport.x, top - inset, 0), WindowPoint(right, top - inset, 0)},
        {Length, {"height", ""}, WindowPoint(right - inset, viewport.y, 0), WindowPoint(right - inset, top, 0)}};
    if (viewport.x != 0.0)
        arrows.push_back({Length, {"vx", ""}, WindowPoint(0, middleY, 0), WindowPoint(viewport.x, middleY, 0)});
    if (viewport.y != 0.0)
        arrows.push_back({Length, {"vy", ""}, WindowPoint(middleX, 0, 0), WindowPoint(middleX, viewport.y, 0)});
    const double beside = width - 16.0 * inset; // the arrow of the viewport's height
    arrows.push_back({Length, {"H", ""}, WindowPoint(beside, height, 0), WindowPoint(beside, 0, 0)});
    return arrows;
}

} // namespace unprojector::lessons
