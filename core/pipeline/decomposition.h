#pragma once

#include <glm/mat4x4.hpp>

#include <optional>
#include <string>

namespace unprojector::pipeline {

/// The projection and the view that multiply to a given product.
struct Decomposition {
    glm::dmat4 clipFromEye{0.0};  ///< looks down -z, w' = -z; y is flipped if the product is mirrored
    glm::dmat4 eyeFromWorld{1.0}; ///< rotation and translation only
    double w = 1.0; ///< the product's scale: 1 except for scaled views; negative if all entries are negated
    bool isMirrored = false;
    bool isBox = false; ///< the eye is set on the near plane: any position along the view gives the same product
    double residual =
        0.0; ///< the largest |entry| of (clipFromEye * eyeFromWorld * w - given), over the largest given |entry|
};

/// Decomposes a product into a projection that looks down -z and a view. A perspective product has
/// exactly one of each. Its rows are
///
///   x = xScale s + xOffset f,  y = yScale u + yOffset f,  z = zScale f,  w = f
///
/// in the axes s, u, f of the eye. Their last column gives the eye's position. The rows of a box
/// are perpendicular to each other. For a box, x and y have no offset, and depth is assumed to grow
/// away from the eye.
/// @param clipFromWorld  finite
/// @return nothing for oblique products and for products of other forms
std::optional<Decomposition> decomposed(const glm::dmat4 &clipFromWorld);

/// Describes the decomposition, its residual, and where the eye of a box is set, in the language of
/// base::tr().
std::string decompositionText(const Decomposition &apart);

} // namespace unprojector::pipeline
