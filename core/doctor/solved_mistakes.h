#pragma once

#include "core/doctor/hypotheses.h"
#include "core/doctor/variants.h"
#include "core/doctor/written_value.h"

#include <array>
#include <functional>
#include <optional>
#include <span>
#include <vector>

/// Mistakes with free values, such as another far plane. The values are solved from the given
/// points, on the assumption that the mistake is the only one. Each solved mistake is a Variant
/// with `values` and `unknowns`. It competes with the mistakes of fixed form, but not in pairs.
namespace unprojector::doctor {

// Each adds the mistakes of some families whose values the points determine. A variant that does
// not explain all points is dropped later, by hypotheses().

/// The mistakes that one point determines.
void addSolvedFromOne(VariantList &list, const Given &given, const Case &scene);
/// Pixels of a letterboxed window, from one point or more.
void addLetterboxes(VariantList &list, const Given &given, const Case &scene);
/// The mistakes that take two points or three.
void addSolvedFromSeveral(VariantList &list, const Given &given);
/// Another frame, or other axes with a scale or a translation. All depths must be known.
void addSolvedFrames(VariantList &list, const Given &given);

/// The lacks of several points that keep values from being solved; none for one point.
std::vector<Lack> lackOf(const Given &given);

/// A click, the program's answer, and the pixel where the right matrices put it, see projected().
struct Answered {
    Answered(const Given &given, const Click &clicked, const glm::dvec3 &answer)
        : click(clicked), got(answer), there(projected(given, clicked, answer))
    {
    }

    Click click;
    glm::dvec3 got;
    std::optional<glm::dvec3> there;
};

/// Solves a value from one point.
/// @return empty if this point does not determine it
using Value = std::optional<double>;
using Solve = std::function<Value(const Answered &)>;

/// The value that all points have in common, with its uncertainty. Points that do not determine it
/// are skipped.
/// @return empty if the points contradict each other, or if none determines the value
std::optional<Solution> solvedFrom(const Given &given, const Solve &solve);

/// The shift of all positions along x and y, device pixels to the right and down.
/// @return empty if the points do not have one
std::optional<std::array<Solution, 2>> solvedShift(const Given &given);

/// A pixel that is off by the same way at every click, device pixels to the right and down.
Variant shifted(double dx, double dy, VariantName name, std::vector<SolvedValue> values);

/// A pixel that is scaled about the top-left corner, then moved to the right and down, device pixels.
Variant scaledAndMoved(double scale, double dx, double dy);

/// Usual sizes of windows and images, and the scene's.
std::vector<double> usualSizes(const Given &given, const Case &scene);

/// True if no clicked point lies between these planes: a program that shows nothing there hardly
/// has them. Round values are believed nevertheless.
bool hideAll(const Given &given, double nearDistance, double farDistance);

/// The far plane if near is at `nearDistance`, and the near plane if far is at `farDistance`.
std::optional<Solution> solvedFar(const Given &given, double nearDistance);
std::optional<Solution> solvedNear(const Given &given, double farDistance);

/// Adds a solved mistake: with the round values if they are round, and with the values as they are
/// determined. ranked() takes the first that explains the points. `made` builds the variant from
/// the values; `unknowns` and `isExpected` are set here, and `coincidence` is multiplied.
void addSolved(VariantList &list, std::string_view id, std::span<const Solution> solutions,
               std::span<const double> known, const std::function<Variant(std::span<const double>)> &made,
               int ways = 1);

/// Adds a mistake with one solved value, as addSolved() does. Within its bound the value is the one
/// whose answers are closest to the points.
void addSolvedNumber(VariantList &list, std::string_view id, const Given &given, const Solution &solution,
                     std::span<const double> known, const std::function<Variant(double)> &made);

/// The click of a target, in the middle of its possible depths.
Click middleOf(const Given &given, const Target &target);
/// True if the depths of all clicks are known.
bool areDepthsKnown(const Given &given);
/// The share of the depth's way from the near plane to the far plane.
double shareFromNear(const Given &given, const Click &click);
/// The program's point in eye space.
glm::dvec3 eyeFromGot(const Given &given, const Answered &of);

} // namespace unprojector::doctor
