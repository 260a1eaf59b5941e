#pragma once

#include "core/doctor/diagnosis.h"
#include "tests/support/random_scene.h"
#include "tests/support/wrong_programs.h"

#include <cstdint>
#include <map>
#include <string>
#include <vector>

/// How often the doctor names what a wrong program did, over random scenes. What a program prints is given in four
/// decimals, the pixel and its depth exactly.
namespace doctor_bar {

/// A scene, a click and what is seen there.
struct Shot {
    wrong_programs::Scene scene;
    double ratioTold = 1.0; ///< the scene's ratio, or 1 where only the framebuffer is known
    wrong_programs::Click click;
    glm::dvec3 truth{0.0}; ///< largest coordinate between 1 and 10
};

/// Perspectives and (one in four) boxes, viewports within larger windows and (one in three) whole ones, some square.
Shot randomShot(oracle::Random &random);

unprojector::doctor::Case caseOf(const Shot &shot);
unprojector::geometry::Result<unprojector::doctor::Diagnosis> diagnosed(const Shot &shot, const glm::dvec3 &got);

struct Count {
    int asked = 0;
    int first = 0;      ///< the verdict, and named first
    int firstThree = 0; ///< among the first three
    /// Named first, or what is prints the same four decimals of each coordinate: no doctor tells the two apart.
    int firstOrTwin = 0;
};

struct Tally {
    Count all;
    std::map<std::string, Count> ofId;
    std::vector<std::string> missed; ///< what was done, what was named instead

    void add(const std::string &id, const unprojector::doctor::Diagnosis &diagnosis,
             const std::vector<std::string> &twins, const std::string &what);
};

/// Every mistake, in one of its variants by turns. One that prints the right point, in the digits given, is to be called right;
/// those that print no numbers are left out.
void addSingles(Tally &tally, oracle::Random &random, int shots);

/// Two of the most common mistakes, one of each of the first rows of the reports. What one mistake alone, or none, prints as
/// well is left out.
void addPairs(Tally &tally, oracle::Random &random, int shots);

/// @return how many right points are not called right
int rightsMissed(oracle::Random &random, int shots);

/// @return how many random points, within 10 of the origin on each axis, are explained
int garbageExplained(oracle::Random &random, int shots);

} // namespace doctor_bar
