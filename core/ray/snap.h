#pragma once

#include "core/ray/scene_rays.h"

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace unprojector::ray {

/// Finds the visible vertex, edge or face near a position that a click snaps to. Rays through the
/// positions around it, a pixel apart, find most of them. A search among all triangles there finds
/// the ones thin or small enough to lie between the rays.
class SnapSearch {
public:
    /// @param rays  outlive this
    SnapSearch(const SceneRays &rays, const geometry::DevicePoint &position);

    /// The nearest visible vertex in the view, within kSnapPixels.
    std::optional<SceneHit> vertex() const;
    /// The nearest visible point of an edge, in the same radius.
    std::optional<SceneHit> edge() const;
    /// The nearest location where a ray hit a triangle.
    std::optional<SceneHit> face() const;

private:
    /// A hit triangle, and its distance from the position.
    struct Seen {
        SceneHit hit;
        double pixels;
    };
    /// A location on a triangle.
    struct Place {
        std::size_t object;
        std::uint32_t triangle;
        glm::dvec3 barycentric;
        geometry::WorldPoint world;
        geometry::DevicePoint at;
        double pixels; ///< from the position
    };
    /// A hit triangle that can hide others: wholly in front of the eye and not clipped.
    struct Occluder {
        std::array<glm::dvec2, 3> corners; ///< in the view, counter-clockwise in these coordinates
        bool covers(const geometry::DevicePoint &at) const;
        geometry::WorldPoint on;
        glm::dvec3 behind;         ///< its normal towards the far side, length 1
        geometry::WorldPoint from; ///< on the near plane
        double coversTo; ///< the t up to which points beside it may be visible; infinity: it does not cover everything
    };

    /// The position of a world point in the view; nothing behind the eye.
    std::optional<geometry::DevicePoint> seenAt(const geometry::WorldPoint &point) const;
    /// Adds the locations of a triangle of an object that lie within some pixels.
    using AddPlaces =
        std::function<void(const SceneRays::Object &, std::uint32_t, double pixels, std::vector<Place> &)>;
    void addCorners(const SceneRays::Object &object, std::uint32_t triangle, double pixels,
                    std::vector<Place> &places) const;
    void addEdges(const SceneRays::Object &object, std::uint32_t triangle, double pixels,
                  std::vector<Place> &places) const;
    std::optional<SceneHit> nearest(const AddPlaces &addPlaces) const;
    /// The rays through all positions within a distance, in the space of an object; nothing if they
    /// cannot be computed.
    std::optional<RayBundle> bundle(const SceneRays::Object &object, double pixels, double high) const;
    struct InSight {
        SceneHit hit;
        double pixels;
    };
    std::optional<InSight> nearestInSight(std::vector<Place> places) const;
    std::vector<Occluder> occluders() const;
    /// Removes the locations well behind an occluder: much faster than casting rays.
    static void eraseHidden(std::vector<Place> &places, const std::vector<Occluder> &occluders);
    std::optional<SceneHit> inSight(const Place &place) const;

    const SceneRays &m_rays;
    geometry::DevicePoint m_position;
    std::optional<glm::dmat4> m_clipFromWorld;
    double m_nearW = 1.0;     ///< of clip space, on the near plane
    std::vector<Seen> m_seen; ///< nearest first, each triangle once
};

/// The reason why a click found nothing, in the language of base::tr().
std::string nothingText(Snap snap);

} // namespace unprojector::ray
