#pragma once

#include "core/maps/surface_image.h"
#include "core/unproject/batch/click_batch.h"

#include <cstddef>
#include <vector>

namespace unprojector::maps {

/// Many points, one array per coordinate.
struct PointArrays {
    std::vector<double> x, y, z;

    explicit PointArrays(std::size_t count) : x(count), y(count), z(count) {}
    geometry::WorldPoint world(std::size_t i) const { return {x[i], y[i], z[i]}; }
    geometry::EyePoint eye(std::size_t i) const { return {x[i], y[i], z[i]}; }
};

/// Picture elements (pixel positions and depths) to unproject.
struct ElementArrays {
    std::vector<double> px, py, depth;

    void add(const geometry::DevicePoint &position, double windowDepth)
    {
        px.push_back(position.x);
        py.push_back(position.y);
        depth.push_back(windowDepth);
    }
    /// @param batch  a ClickBatch or a BatchUnprojection
    template <class Batch>
    PointArrays unprojected(const Batch &batch) const
    {
        PointArrays points(px.size());
        batch(unproject::BatchInput<double>{px.data(), py.data(), depth.data()},
              unproject::BatchOutput<double>{points.x.data(), points.y.data(), points.z.data()}, px.size());
        return points;
    }
};

/// The pixels of a row that show a surface.
struct RowPixels {
    ElementArrays elements;                    ///< their centres
    std::vector<geometry::DevicePixel> pixels; ///< in the same order
    std::vector<std::size_t> places;           ///< indices in the image

    RowPixels(const SurfaceImage &surfaces, int row);
};

} // namespace unprojector::maps
