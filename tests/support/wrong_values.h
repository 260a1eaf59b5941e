#pragma once

#include "tests/support/wrong_programs.h"

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

#include <map>
#include <optional>
#include <string>
#include <vector>

/// Programs in which one value differs from the scene's. They share no code with core.
namespace wrong_programs {

/// A wrong value. `values` has the numbers under the names that the doctor uses for them:
///
///   far-differs            far
///   near-differs           near
///   near-far-differ        near, far
///   fovy-differs           fovy, degrees
///   pixel-shifted          dx, dy: the program's pixel is the right one plus these, y down
///   pixel-scaled-and-moved scale, dx, dy: the program's pixel is the right one times scale, plus
///                          these, y down; variant 1 flips it with the height of the letterboxed
///                          window, which has a bar of dy above and below
///   viewport-size-differs  width, height: of the viewport alone
///   ratio-differs          ratio: the program's pixel is the right one divided by it; variant 1
///                          divides the height for the flip too
///   scaled                 factor; word: about "origin" or "eye"
///   frame-differs          rotation (by rows), translation, scale: the program's point is
///                          scale · rotation · right point + translation
///   axes-differ            word: "x,-z,y" if the program's point is (x, -z, y) of the right one
struct WrongValue {
    std::string id;
    std::map<std::string, std::vector<double>> values;
    std::string word;
    int variant = 0;
};

/// The ids above.
const std::vector<std::string> &wrongValueIds();

/// The answer of a program with this value to the click.
/// @return nothing if it prints no numbers, or if the scene has no such value
std::optional<glm::dvec3> printed(const Scene &scene, const Click &click, const WrongValue &wrong);

} // namespace wrong_programs
