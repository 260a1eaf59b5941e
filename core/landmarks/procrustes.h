#pragma once

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

#include <cstddef>
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

/// The rule for the scale of a similarity.
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

/// The similarity that fits most landmarks well and ignores those out of place. It starts with weights
/// 1 / r for residuals r, and ends with Tukey's (1 - (r / 3s)^2)^2 below 3 s, else 0. The spread s is
/// 1.126 times the median residual: the root of the mean square for normal errors. Scaling::Sizes.
/// @return empty as similarityOf
std::optional<Similarity> robustSimilarityOf(const Configuration &from, const Configuration &to);

/// The number of landmarks that a specimen has.
std::size_t placedCount(const Configuration &points);

/// The centroid size: the root of the sum of the squared distances from the centroid.
/// 0 without a landmark.
double centroidSizeOf(const Configuration &points);

/// The way to average and align specimens.
enum class Estimate {
    LeastSquares, ///< the classic one: means, and equal weights
    Robust,       ///< medians of each coordinate; landmarks out of place have no weight in their specimen
};

/// The mean of aligned specimens, landmark by landmark. All have the same length, or there is none.
Configuration meanOf(std::span<const Configuration> aligned, Estimate estimate);

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
/// Estimate::Robust weights landmarks as robustSimilarityOf does.
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
