#pragma once

#include "core/ray/scene_rays.h"

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace unprojector::ray {

/// What in sight near a position a click snaps to. Rays through the positions about it, a pixel apart, find most of it; what is
/// nearer than that, and thin or small enough to lie between them, is looked for among all triangles there.
class SnapSearch {
public:
    /// @param rays  outlive this
    SnapSearch(const SceneRays &rays, const geometry::DevicePoint &position);

    /// The vertex that is nearest in the picture, within kSnapPixels, and that nothing hides.
    std::optional<SceneHit> vertex() const;
    /// The same of the nearest points of edges.
    std::optional<SceneHit> edge() const;
    /// The nearest place at which a triangle was met.
    std::optional<SceneHit> face() const;

private:
    /// A triangle that was met, and how far from the position.
    struct Seen {
        SceneHit hit;
        double pixels;
    };
    /// A place on a triangle.
    struct Place {
        std::size_t object;
        std::uint32_t triangle;
        glm::dvec3 barycentric;
        geometry::WorldPoint world;
        geometry::DevicePoint at;
        double pixels; ///< from the position
    };
    /// A triangle that was met, whole in front of the eye and not clipped, as what hides others.
    struct Occluder {
        std::array<glm::dvec2, 3> corners; ///< in the picture, counter-clockwise as numbers go
        bool covers(const geometry::DevicePoint &at) const;
        geometry::WorldPoint on;
        glm::dvec3 behind;         ///< its normal on the far side, length 1
        geometry::WorldPoint from; ///< on the near plane
        double
            coversTo; ///< the t up to which something beside it is seen at all; infinity: it does not cover everything
    };

    /// Where a world point is seen; nothing behind the eye.
    std::optional<geometry::DevicePoint> seenAt(const geometry::WorldPoint &point) const;
    /// Adds the places that a triangle of an object has no farther than some pixels away.
    using AddPlaces =
        std::function<void(const SceneRays::Object &, std::uint32_t, double pixels, std::vector<Place> &)>;
    void addCorners(const SceneRays::Object &object, std::uint32_t triangle, double pixels,
                    std::vector<Place> &places) const;
    void addEdges(const SceneRays::Object &object, std::uint32_t triangle, double pixels,
                  std::vector<Place> &places) const;
    std::optional<SceneHit> nearest(const AddPlaces &addPlaces) const;
    /// The rays through all positions so near, in the space of an object; nothing where they cannot be computed.
    std::optional<RayBundle> bundle(const SceneRays::Object &object, double pixels, double high) const;
    struct InSight {
        SceneHit hit;
        double pixels;
    };
    std::optional<InSight> nearestInSight(std::vector<Place> places) const;
    std::vector<Occluder> occluders() const;
    /// Removes what lies well behind one of them: it is much faster seen so than by rays.
    static void eraseHidden(std::vector<Place> &places, const std::vector<Occluder> &occluders);
    std::optional<SceneHit> inSight(const Place &place) const;

    const SceneRays &m_rays;
    geometry::DevicePoint m_position;
    std::optional<glm::dmat4> m_clipFromWorld;
    double m_nearW = 1.0;     ///< of clip space, on the near plane
    std::vector<Seen> m_seen; ///< the nearest first, each triangle once
};

/// Why a pick has found nothing, in the language of text::tr().
std::string nothingText(Snap snap);

} // namespace unprojector::ray
