#pragma once

#include "core/landmarks/landmark.h"

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace unprojector::landmarks {

/// One placing of a landmark, over all specimens.
struct PlacingError {
    int placing = 1;
    std::size_t specimens = 0; ///< with this placing and another one
    /// The standard deviation of this placing about the specimens' means:
    ///
    ///   sqrt(mean of k / (k - 1) |x - mean|^2), k the specimen's placings
    ///
    /// Two placings always have the same one.
    std::optional<double> error;
    /// The distance from the mean of all placings to this one's, over the specimens with all placings:
    /// what is systematic about it. The specimens' axes are turned as for the coefficients.
    std::optional<double> bias;
};

/// The error of measurement of one landmark, or of all.
struct LandmarkError {
    std::string name;          ///< empty: all landmarks together
    std::size_t specimens = 0; ///< with two placings or more; for all landmarks, of any of them
    std::size_t placings = 0;  ///< of these specimens
    /// The standard deviation of one placing, all three coordinates together, pooled over the
    /// specimens: the technical error of measurement.
    ///
    ///   sqrt(sum over specimens and placings of |x - mean|^2 / sum over specimens of (k - 1))
    ///
    /// For two placings this is Dahlberg's sqrt(sum of d^2 / 2n). Coordinates stay in their scan's
    /// frame, which all placings of a scan share.
    /// Source: Dahlberg 1940, "Statistical Methods for Medical and Biological Students".
    std::optional<double> error;
    /// The intraclass correlation of one placing: the share of the variance that is between specimens.
    ///
    ///   ICC(1) = (MSB - MSW) / (MSB + (k0 - 1) MSW)
    ///   k0     = (N - sum of k^2 / N) / (n - 1), for N placings of n specimens; k if all have k
    ///
    /// Mean squares are sums over x, y and z. Empty for fewer than two aligned specimens, or without
    /// a repeated placing.
    /// Source: Shrout and Fleiss 1979, "Intraclass correlations: uses in assessing rater
    /// reliability", case 1; Lessells and Boag 1987 for k0; Fruciano 2016, "Measurement error in
    /// geometric morphometrics", for sums over coordinates.
    std::optional<double> icc1;
    /// The same for crossed placings, each by one observer of many, over the complete specimens. The
    /// observers' differences count as error.
    ///
    ///   ICC(2,1) = (MSR - MSE) / (MSR + (k - 1) MSE + k (MSC - MSE) / n)
    ///
    /// Source: Shrout and Fleiss 1979, case 2.
    std::optional<double> icc2;
    std::vector<PlacingError> byPlacing; ///< ascending
};

struct MeasurementError {
    std::vector<LandmarkError> landmarks; ///< by name, see distinctNames
    LandmarkError all;                    ///< sums of squares and degrees of freedom over all landmarks
    std::vector<int> placings;            ///< their numbers, ascending
    std::size_t specimens = 0;            ///< all that were given
    /// Specimens that cannot be aligned with the others: fewer than three landmarks, or all on a line.
    /// The coefficients and the biases leave them out.
    std::size_t notAligned = 0;
};

/// The error of measurement of landmarks that were placed several times.
///
/// Scans have frames of their own, so specimens can be compared only after they are aligned: by
/// generalised Procrustes superimposition of each specimen's mean. All placings of a specimen are
/// turned, moved and scaled with it, so their differences stay as placed.
/// @param specimens  each with its placings, which LandmarkSet::placing tells apart
MeasurementError measurementErrorOf(std::span<const std::vector<LandmarkSet>> specimens);

} // namespace unprojector::landmarks
