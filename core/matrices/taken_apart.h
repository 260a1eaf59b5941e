#pragma once

#include <glm/mat4x4.hpp>

#include <optional>

namespace unprojector::matrices {

/// Projection and view of a product.
struct TakenApart {
    glm::dmat4 clipFromEye{0.0};  ///< looks down -z, w' = -z; y turned round where the product is mirrored
    glm::dmat4 eyeFromWorld{1.0}; ///< turns and moves only
    double w = 1.0;               ///< what the product was divided by: 1 but for scaled views
    bool isMirrored = false;
    double off =
        0.0; ///< the largest |entry| of their product, times w, less the given one, over the largest given entry
};

/// The one projection that looks down -z and the one view that make a perspective's product: its rows are
///
///   x = xScale s + xOffset f,  y = yScale u + yOffset f,  z = zScale f,  w = f
///
/// in the axes s, u, f of the eye, and their last column is where the eye is.
/// @param clipFromWorld  finite
/// @return nothing for boxes, whose eye may be anywhere along the view, for oblique products, for products of other forms
std::optional<TakenApart> takenApart(const glm::dmat4 &clipFromWorld);

} // namespace unprojector::matrices
