#pragma once

#include "core/geometry/precise_matrix.h"
#include "gui/document/picked_ray.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace unprojector::gui {

/// A list of objects that is never modified in place.
using ObjectList = std::shared_ptr<const std::vector<scene::SceneObject>>;

/// The objects and clip planes that a ray can hit.
struct RayScene {
    ObjectList objects;
    std::vector<glm::dvec4> clipPlanes;
};

/// A pick with everything that belongs to it.
struct KeptPick {
    std::optional<unproject::Pick> pick = {};
    geometry::PreciseMatrix placement = {}; ///< worldFromObject of its object at the click
    PickedRay ray = {};                     ///< meaningful with a pick
    std::optional<RayScene> rayScene = {};  ///< at the click, until the ray is answered
    std::uint64_t click = 0;                ///< identifies a click within the document
};

/// Changes of the scene and its view since the click.
struct SinceClick {
    bool isOtherSetup = false;   ///< camera, projection, viewport, depth range or the window's size
    bool isObjectMoved = false;  ///< the object that was hit: the point is where its surface was
    bool isObjectHidden = false; ///< the object that was hit
    bool isCutAway = false;      ///< the point lies on the side of a clip plane where nothing is drawn

    bool isAnything() const { return isOtherSetup || isObjectMoved || isObjectHidden || isCutAway; }
};

/// worldFromObject of the pick's object, the identity if it has none.
geometry::PreciseMatrix placementOf(const unproject::Pick &pick, const std::vector<scene::SceneObject> &objects);

/// Compares a pick with the current scene. @param scene, setup  the current ones
SinceClick sinceClick(const KeptPick &kept, const scene::Scene &scene, const geometry::Setup &setup);

/// The one point that a pick stands for: the snapped point on the mesh, else the surface by the
/// formula. Nothing if there is neither.
std::optional<geometry::WorldPoint> pickedPoint(const KeptPick &kept);

/// The uncertainty of that point: the snapped point's, else the surface's. @pre there is a pick
geometry::WorldVector pickedUncertainty(const KeptPick &kept);

/// Maps the indices of a pick from one list of objects to another. An object that is missing in
/// `after` leaves no index.
/// @return whether an index changed
bool follow(KeptPick &kept, const std::vector<scene::SceneObject> &before,
            const std::vector<scene::SceneObject> &after);

/// Fills in what the ray of a pick hits, and takes the uncertainty from the hit triangle.
/// @param unprojector  of the pick's setup
/// @param rays         of the pick's rayScene in that setup
/// @param now          the current objects
void answerRay(KeptPick &kept, const unproject::Unprojector &unprojector, const ray::SceneRays &rays,
               const std::vector<scene::SceneObject> &now);

} // namespace unprojector::gui
