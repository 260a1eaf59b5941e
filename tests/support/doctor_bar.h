#pragma once

#include "core/doctor/diagnosis.h"
#include "tests/support/random_scene.h"
#include "tests/support/wrong_programs.h"

#include <cstdint>
#include <map>
#include <string>
#include <vector>

/// Measures how often the doctor names the mistakes of a wrong program, over random scenes. A
/// program's answer is given in four decimals, the pixel and its depth exactly.
namespace doctor_bar {

/// A scene, a click and the true point.
struct Shot {
    wrong_programs::Scene scene;
    double ratioTold = 1.0; ///< the scene's ratio, or 1 if only the framebuffer is known
    wrong_programs::Click click;
    glm::dvec3 truth{0.0}; ///< largest coordinate between 1 and 10
};

/// Perspectives and (one in four) boxes, viewports within larger windows and (one in three) whole
/// ones, some square.
Shot randomShot(oracle::Random &random);

unprojector::doctor::Case caseOf(const Shot &shot);
unprojector::geometry::Result<unprojector::doctor::Diagnosis> diagnosed(const Shot &shot, const glm::dvec3 &got);

struct Count {
    int asked = 0;
    int first = 0;      ///< is the verdict, and named first
    int firstThree = 0; ///< among the first three
    /// Named first, or a mistake that prints the same four decimals of each coordinate: no doctor
    /// can distinguish the two.
    int firstOrTwin = 0;
};

struct Tally {
    Count all;
    std::map<std::string, Count> ofId;
    std::vector<std::string> missed; ///< the mistakes made and those named instead

    void add(const std::string &id, const unprojector::doctor::Diagnosis &diagnosis,
             const std::vector<std::string> &twins, const std::string &what);
};

/// The texts, a line each.
std::string lines(const std::vector<std::string> &texts);

/// Tests every mistake, cycling through its variants. A mistake that prints the right point, in the
/// given digits, must be called right. Mistakes that print no numbers are skipped.
void addSingles(Tally &tally, oracle::Random &random, int shots);

/// Tests pairs of the most common mistakes, one from each of the first rows of the reports. Skips
/// pairs that print the same as one mistake alone, or as none.
void addPairs(Tally &tally, oracle::Random &random, int shots);

/// @return the number of right points that are not called right
int rightsMissed(oracle::Random &random, int shots);

/// @return the number of random points, within 10 of the origin on each axis, that are explained
int garbageExplained(oracle::Random &random, int shots);

} // namespace doctor_bar
