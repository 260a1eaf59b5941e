#pragma once

#include "tests/support/doctor_bar.h"
#include "tests/support/wrong_values.h"

#include <map>
#include <string>
#include <vector>

/// Measures how often the doctor finds a program's wrong value, over random scenes. The answers are
/// given in four decimals.
namespace value_bar {

struct Count {
    int asked = 0;
    int verdicts = 0;     ///< the verdict, with its values within 1 %
    int firstThree = 0;   ///< among the first three candidates, with its values within 1 %
    int undetermined = 0; ///< not asked: a value 1 % off prints nearly the same points
};

struct Tally {
    std::map<std::string, Count> ofId;
    std::vector<std::string> missed; ///< the values and the candidates named instead
};

/// Tests every id of wrong_programs::wrongValueIds() with values that are round, or (one in two)
/// any.
/// @param points  clicks of each program
Tally tested(oracle::Random &random, int shots, int points);

/// Tests near and far of round numbers from two points of different depths.
Count roundPlanesFromTwo(oracle::Random &random, int shots);

/// @return the number of triples of random points, within 10 of the origin on each axis, that are
///         explained
int garbageExplained(oracle::Random &random, int shots);

} // namespace value_bar
