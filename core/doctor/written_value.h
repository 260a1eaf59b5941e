#pragma once

#include <limits>
#include <span>
#include <string>
#include <vector>

namespace unprojector::doctor {

/// A value that was solved from given points, with a bound on its error that follows from their
/// last digits.
struct Solution {
    double value = 0.0;
    double unsure = 0.0;
    double ofScene = std::numeric_limits<double>::quiet_NaN(); ///< the right value; NaN: has no part in it
};

/// A solved value as a person would write it.
struct WrittenValue {
    double value = 0.0; ///< the roundest number within the bound, or a value of the scene there
    /// The chance that an arbitrary value has so round a number, or a value of the scene, within
    /// its bound; 1 if the value is not round. Then it is rounded to the digits that are
    /// determined. It is 1 also for the right value: that a program has it is no evidence for the
    /// mistake.
    double coincidence = 1.0;
};

/// The round numbers within the bound, and the known values there.
/// @param known  values that stand in the scene, or are usual
std::vector<WrittenValue> roundValues(const Solution &solution, std::span<const double> known = {});
/// The roundest of roundValues(), the scene's right value, or the value as it is determined.
WrittenValue written(const Solution &solution, std::span<const double> known = {});
/// The value rounded to the digits that are determined.
WrittenValue asDetermined(const Solution &solution);

/// The greatest chance at which values count as round.
constexpr double kRoundByChance = 0.05;

/// The value in twelve digits: 0.1 times 0.1 is 0.01.
double withoutNoise(double value);
/// The text of a value, with seven digits at most.
std::string valueText(double value);

} // namespace unprojector::doctor
