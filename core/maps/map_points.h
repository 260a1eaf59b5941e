#pragma once

#include "core/maps/surface_image.h"
#include "core/unproject/batch/click_batch.h"

#include <cstddef>
#include <vector>

namespace unprojector::maps {

/// Many points, one array per coordinate.
struct PointArrays {
    std::vector<double> x, y, z;

    void resize(std::size_t count)
    {
        x.resize(count);
        y.resize(count);
        z.resize(count);
    }
    unproject::BatchOutput<double> output() { return {x.data(), y.data(), z.data()}; }
    geometry::WorldPoint world(std::size_t i) const { return {x[i], y[i], z[i]}; }
    geometry::EyePoint eye(std::size_t i) const { return {x[i], y[i], z[i]}; }
};

/// Picture elements (pixel positions and depths) to unproject.
struct ElementArrays {
    std::vector<double> px, py, depth;

    void clear()
    {
        px.clear();
        py.clear();
        depth.clear();
    }
    void add(const geometry::DevicePoint &position, double windowDepth)
    {
        px.push_back(position.x);
        py.push_back(position.y);
        depth.push_back(windowDepth);
    }
    std::size_t count() const { return px.size(); }

    void unproject(const unproject::ClickBatch &batch, PointArrays &points) const
    {
        points.resize(count());
        batch({px.data(), py.data(), depth.data()}, points.output(), count());
    }
};

/// The pixels of a row that show a surface.
struct RowPixels {
    ElementArrays elements;                    ///< their centres
    std::vector<geometry::DevicePixel> pixels; ///< in the same order
    std::vector<std::size_t> places;           ///< indices in the image

    void read(const SurfaceImage &surfaces, int row);
};

} // namespace unprojector::maps
