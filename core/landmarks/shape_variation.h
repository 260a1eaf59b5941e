#pragma once

#include "core/landmarks/procrustes.h"

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

#include <cstddef>
#include <span>
#include <vector>

namespace unprojector::landmarks {

/// The offset of each landmark of an aligned specimen from its usual place. Empty: not there.
using Offsets = Configuration;

/// Parts of the variance of a landmark, which sum to 1 with the part that the specimens show.
struct VarianceShares {
    double own = 1.0;    ///< of each landmark alone, equal in all directions
    double smooth = 0.0; ///< shared with landmarks close by
};

/// Smooth functions over a shape, one value a landmark. Together they are nearly the kernel
/// exp(-d^2 / (2 r^2)) of the distance d of two landmarks: values . values = kernel. The radius r is
/// the root mean square distance of a landmark from the centroid. Found by Cholesky's algorithm with
/// pivots, at most 10 functions.
std::vector<std::vector<double>> smoothFunctionsOver(const Configuration &shape);

/// The way in which landmarks vary together: a normal distribution of all offsets with mean 0.
///
///   covariance = own D + smooth K + (1 - own - smooth) S
///
/// S is the covariance of other specimens' offsets, D its variances, and K shares them with the
/// landmarks close by. The mixture stays regular with fewer specimens than landmarks.
///
/// Source: Schaefer and Strimmer 2005, "A shrinkage approach to large-scale covariance matrix
/// estimation"; Luethi et al. 2018, "Gaussian process morphable models" (K).
class ShapeVariation {
public:
    /// Each landmark varies alone: no landmark tells anything about another.
    ShapeVariation() = default;
    /// @param specimens  offsets of other specimens; all of one length
    /// @param smooth     see smoothFunctionsOver
    ShapeVariation(std::span<const Offsets> specimens, const std::vector<std::vector<double>> &smooth,
                   const VarianceShares &shares);

    /// Each offset minus what the other landmarks of the specimen predict for it: the mean of its
    /// distribution when theirs are known. For one landmark, with precision P = covariance^-1:
    ///
    ///   rest = P_jj^-1 (P offsets)_j
    ///
    /// @param isLeftOut  landmarks that predict no other
    /// Source: Rasmussen and Williams 2006, "Gaussian Processes for Machine Learning", (5.12).
    Offsets rests(const Offsets &offsets, const std::vector<bool> &isLeftOut) const;

private:
    /// covariance = rows^T rows + diagonal; none: nothing is shared.
    std::vector<std::vector<glm::dvec3>> m_rows;
    std::vector<double> m_diagonal; ///< for each landmark
};

} // namespace unprojector::landmarks
