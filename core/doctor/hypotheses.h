#pragma once

#include "core/doctor/mistakes.h"

#include <array>
#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <vector>

namespace unprojector::doctor {

/// A point that somebody got, and what programs are asked for to answer it: one click, or two where the depth is not known
/// to the digit; then any answer between theirs will do, and any on their line where the depth is not known at all.
struct Target {
    std::vector<Click> clicks; ///< one or two
    bool isLine = false;       ///< of two
    glm::dvec3 got{0.0};
    glm::dvec3 lastDigit{1.0};    ///< that counts
    glm::dvec3 writtenDigit{1.0}; ///< the last one that was given
};

/// A rounded coordinate is half a unit of its last digit off, one that was cut off a whole one. What single precision adds
/// to either.
constexpr double kRounded = 0.6;
constexpr double kCutOff = 1.1;

/// By how many units of its last digit a coordinate is off an answer. Digits are cut off towards zero: more than rounding
/// explains, and on the other side, is never less than two units.
double unitsOff(const Target &target, int axis, const glm::dvec3 &answer);

/// The answer closest to what was got.
struct Nearest {
    glm::dvec3 point{0.0};
    double distance = 0.0; ///< the greatest difference of a coordinate, in units of its last digit
};

/// No mistake, one or two, and how close their answers come.
struct Hypothesis {
    std::array<const Variant *, 2> parts{}; ///< by their place in the list of mistakes
    std::size_t count = 0;
    /// The other of two ways to make both. In the same stage: the second before the first. Of the eye point and the view:
    /// see Run::isClosedForm.
    bool isOtherWay = false;
    glm::dvec3 point{0.0}; ///< the answer to the first point
    double distance = 0.0; ///< mean over the points
    double worst = 0.0;    ///< of the points

    /// The program at its end; nothing where it has no answer.
    std::optional<Run> ranFor(const Given &given, const Click &click) const;
    /// What the program answers; nothing where it has no answer.
    std::optional<glm::dvec3> answerTo(const Given &given, const Click &click) const;
    /// The answer closest to what was got.
    std::optional<Nearest> nearest(const Given &given, const Target &target) const;
};

/// Whether two answers differ by no more than computing leaves.
bool isSameAnswer(const glm::dvec3 &a, const glm::dvec3 &b);

/// The ways to make one mistake, and two of different ones; those without effect on all of the points are left out.
/// @param list  must outlive what is returned
std::vector<Hypothesis> hypotheses(const Given &given, std::span<const Target> points, std::span<const Variant> list);

} // namespace unprojector::doctor
