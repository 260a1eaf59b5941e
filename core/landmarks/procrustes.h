#pragma once

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

#include <optional>
#include <span>
#include <vector>

namespace unprojector::landmarks {

/// The positions of one specimen's landmarks; every specimen has them in the same order. Empty: the
/// specimen lacks the landmark.
using Configuration = std::vector<std::optional<glm::dvec3>>;

/// The map y = scale * rotation * x + translation. A reflection is excluded: det(rotation) = 1.
struct Similarity {
    double scale = 1.0;
    glm::dmat3 rotation{1.0};
    glm::dvec3 translation{0.0};

    glm::dvec3 mapped(const glm::dvec3 &point) const { return scale * (rotation * point) + translation; }
    Configuration mapped(const Configuration &points) const;
    Similarity inverse() const;
};

/// How the scale of a similarity is found.
enum class Scaling {
    Regression, ///< minimises sum of w |y - (scale R x + t)|^2 (Umeyama 1991, formula 42)
    Sizes,      ///< the ratio of both centroid sizes, as in Procrustes superimposition
};

/// The least-squares similarity from one configuration to another, over the landmarks of both.
///
/// R maximises the sum of w y . R x about both centroids. It is the unit quaternion of the largest
/// eigenvalue of Horn's 4 x 4 matrix, which is never a reflection.
///
/// @param weights  one a landmark, at least 0; none: all 1
/// @return empty for fewer than three common landmarks with a weight, if those of either
/// configuration are on a line (within 1 % of their length), and beyond the largest double
/// Source: Horn 1987, "Closed-form solution of absolute orientation using unit quaternions";
/// Umeyama 1991, "Least-squares estimation of transformation parameters between two point patterns".
std::optional<Similarity> similarityOf(const Configuration &from, const Configuration &to,
                                       Scaling scaling = Scaling::Regression, std::span<const double> weights = {});

/// The centroid size: the root of the sum of the squared distances from the centroid.
/// 0 without a landmark.
double centroidSizeOf(const Configuration &points);

/// How specimens are averaged and aligned.
enum class Estimate {
    LeastSquares, ///< the classic one: means, and equal weights
    Robust,       ///< medians of each coordinate; landmarks out of place have no weight in their specimen
};

/// Specimens turned, moved and scaled onto their mean.
struct Superimposition {
    Configuration mean; ///< centroid 0, centroid size 1; empty landmarks: of no aligned specimen
    std::vector<std::optional<Similarity>> meanFromSpecimen; ///< empty: it cannot be aligned, see similarityOf
    std::vector<Configuration> aligned;                      ///< in the mean's space; all empty: not aligned
};

/// Generalised Procrustes superimposition: aligns each specimen with the mean, computes the mean
/// again, and so on until the mean stays. The specimen with the most landmarks is the first mean.
///
/// Each specimen gets the mean's centroid size. A specimen with missing landmarks gets the size that
/// the mean has over the others. So complete specimens have centroid size 1, as in geomorph's gpagen.
///
/// Robust: a weight is Tukey's (1 - (r / 3s)^2)^2 for a residual r below 3 s, else 0. The spread s of a
/// specimen is 1.126 times its median residual: the root of the mean square for normal errors.
///
/// Source: Gower 1975, "Generalized Procrustes analysis"; Rohlf and Slice 1990, "Extensions of the
/// Procrustes method for the optimal superimposition of landmarks" (both estimates).
Superimposition superimposed(std::span<const Configuration> specimens, Estimate estimate = Estimate::LeastSquares);

/// The root of the mean square of a distance in space, if its median is 1 and its three coordinates
/// have equal normal errors: sqrt(3) / 1.5382.
inline constexpr double kSpreadPerMedian = 1.12604;

/// The median; the mean of both middle values for an even count. @pre not empty
double medianOf(std::vector<double> values);

} // namespace unprojector::landmarks
