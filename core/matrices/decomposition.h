#pragma once

#include <glm/mat4x4.hpp>

#include <optional>
#include <string>

namespace unprojector::matrices {

/// Projection and view of a product.
struct Decomposition {
    glm::dmat4 clipFromEye{0.0};  ///< looks down -z, w' = -z; y turned round where the product is mirrored
    glm::dmat4 eyeFromWorld{1.0}; ///< turns and moves only
    double w =
        1.0; ///< what the product was divided by: 1 but for scaled views; below 0 where all its entries are negated
    bool isMirrored = false;
    bool isBox = false; ///< its eye is put on the near plane: anywhere along the view gives the same product
    double residual =
        0.0; ///< the largest |entry| of their product, times w, less the given one, over the largest given entry
};

/// The projection that looks down -z and the view that make a product. Of a perspective's there is one of each: its rows are
///
///   x = xScale s + xOffset f,  y = yScale u + yOffset f,  z = zScale f,  w = f
///
/// in the axes s, u, f of the eye, and their last column is where the eye is.
/// A box's rows are perpendicular to each other; x and y have no offset then, and depths are taken to grow away from the eye.
/// @param clipFromWorld  finite
/// @return nothing for oblique products, for products of other forms
std::optional<Decomposition> decomposed(const glm::dmat4 &clipFromWorld);

/// That it was done, how well, and where the eye of a box is put, in the language of text::tr().
std::string decompositionText(const Decomposition &apart);

} // namespace unprojector::matrices
