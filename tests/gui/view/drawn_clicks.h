#pragma once

#include "core/scene/scene.h"
#include "tests/support/inside_share.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

/// Clicks on models that OpenGL draws, compared with the mesh: the hit of the exact ray of the
/// pixel's centre, in double, without a depth buffer.
namespace drawnclicks {

// Models made for these tests.

/// Triangles of the size of a few pixels, each inclined another way.
std::shared_ptr<unprojector::mesh::Model> roughTerrain(std::uint32_t n);
/// A twisted wall of triangles that are hundreds of times as long as wide.
std::shared_ptr<unprojector::mesh::Model> slivers(std::uint32_t n);
/// The same model far away, about another origin, as if read from a file of national coordinates.
std::shared_ptr<unprojector::mesh::Model> movedFarAway(const unprojector::mesh::Model &model);

/// The share of the clicked points inside the reported box.
struct Shares {
    InsideShare byTriangle;   ///< where the triangle is known that the ray meets
    InsideShare byNeighbours; ///< where the depths around the pixel tell the slope
    void add(const Shares &other)
    {
        byTriangle.add(other.byTriangle);
        byNeighbours.add(other.byNeighbours);
    }
};

/// OpenGL without a window. It lives no longer than the application.
class Stage {
public:
    Stage();
    ~Stage();

    /// Clicks in a random picture of a model. Each number has another projection, pixel ratio,
    /// depth range and size; some have clip distances far apart, some show a small part. @param
    /// number  from 0 @param clicks  on the model, at random pixels @return nothing when OpenGL
    /// draws no picture
    std::optional<Shares> clicked(const std::shared_ptr<const unprojector::mesh::Model> &model, int number, int clicks);

    /// measuredCornerShift of the OpenGL that draws.
    double cornerShift(double grid);
    /// OpenGL's name of the renderer; empty without one.
    std::string rendererName();

private:
    struct Drawing;
    std::unique_ptr<Drawing> m_drawing;
};

} // namespace drawnclicks
