#pragma once

#include "core/landmarks/procrustes.h"
#include "core/landmarks/symmetry.h"

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace unprojector::landmarks {

/// The distance of a landmark from where the other specimens put it.
struct Deviation {
    std::size_t specimen = 0, landmark = 0;
    double distance = 0.0; ///< in the specimen's units
    double spread = 0.0;   ///< the usual distance of this landmark on the other specimens; in the same units
    bool isOutOfPlace = false;
    std::optional<std::size_t> swappedWith; ///< the landmark that it has its position exchanged with

    double spreads() const { return distance / spread; }
};

/// The result of comparing several specimens, with all that could not be judged.
struct Deviations {
    std::vector<Deviation> worstFirst;   ///< all judged landmarks
    std::vector<std::size_t> notAligned; ///< specimens with too few landmarks that the others have, ascending
    std::vector<std::size_t> tooRare;    ///< landmarks placed on some specimens, but on fewer than kFewestSpecimens
    std::vector<std::size_t> swappedSpecimens; ///< specimens with all left and right landmarks exchanged
    /// Specimens with some left and right landmarks exchanged; the others do not tell which ones.
    std::vector<std::size_t> undecidedSpecimens;
};

inline constexpr std::size_t kFewestSpecimens = 3; ///< a landmark is judged if so many have it
inline constexpr std::size_t kFewestToAlign = 5;   ///< landmarks that a judged specimen needs
/// A landmark is out of place if it is farther off than so many spreads.
inline constexpr double kSpreadsOutOfPlace = 2.8;

/// Compares each landmark with where the other specimens, and the specimen's other landmarks, put
/// it.
///
///   distance  from the place that the specimen's other landmarks predict, in the specimen's
///             superimposition; see ShapeVariation
///   spread    the root of the mean square of the same distances of the other specimens
///
/// Offsets count from the median position on the other specimens. The shares of the variance are
/// those with which all specimens predict their landmarks best. If landmarks vary independently,
/// the prediction is the median position itself.
///
/// A specimen has no part in its own spreads, and landmarks out of place have none in any mean,
/// alignment, prediction or spread: so a mistake hides neither itself nor another one. The first
/// round knows no mistakes yet. It judges each landmark alone, by 1.126 times the median instead of
/// the root of the mean square, in a robust superimposition. Rounds follow until the same landmarks
/// are out of place; a landmark stays out of the means for one more round than it is out of place.
///
/// The square of a spread is averaged with that of the specimen's median spread, which counts like
/// 8 specimens: few specimens know a spread badly. All spreads of a specimen are multiplied by
/// 1.126 times the median of its distances in spreads, if that is above 1: a specimen may differ as
/// a whole.
///
/// In a specimen, the landmark farthest off is left out first, then the specimen is aligned again,
/// and so on; a landmark that fits afterwards counts again. This starts with each landmark alone,
/// from all landmarks and from a robust alignment; the start that needs fewer landmarks out of
/// place is taken. It goes on with the predictions.
///
/// Two landmarks are swapped if both are 2 spreads off, and each is within 2.8 spreads of the
/// other's position.
///
/// Left and right landmarks have another alignment for each set of pairs that may be swapped. The set
/// with the least sum of log(1 + r^2) of all landmarks, r spreads off, plus 3 for each pair counts; all
/// pairs at once cost 6. If another set is within 1.5 of it, the data cannot tell: the landmarks are out
/// of place, and none is called swapped.
///
/// @param pairs        left and right landmarks
/// @param isCancelled  true: returns soon, with nothing; empty: never
Deviations deviationsOf(std::span<const Configuration> specimens, std::span<const Pair> pairs = {},
                        const std::function<bool()> &isCancelled = {});

} // namespace unprojector::landmarks
