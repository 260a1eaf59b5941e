#pragma once

#include "core/doctor/program.h"

#include <array>
#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <vector>

namespace unprojector::doctor {

/// The tolerances in units of the last digit: half a unit for a rounded coordinate, a whole unit
/// for a truncated one, plus the error of single precision.
constexpr double kRounded = 0.6;
constexpr double kCutOff = 1.1;

/// The difference between a coordinate and an answer, in units of its last digit. Truncation moves
/// a number towards zero. So an answer nearer to zero than rounding explains counts as at least two
/// units off, provided that all given digits count.
double unitsOff(const Target &target, int axis, const glm::dvec3 &answer);

/// The answer closest to the given point.
struct Nearest {
    glm::dvec3 point{0.0};
    double distance = 0.0; ///< the greatest difference of a coordinate, in units of its last digit
};

/// The hypothesis of no mistake, one or two, and the distance of its answers.
struct Hypothesis {
    std::array<const Variant *, 2> parts{}; ///< in the order of the list of mistakes
    std::size_t count = 0;
    /// True for the second of two ways to combine both mistakes. In one stage: the second mistake
    /// before the first. For the eye point and the view: see Run::isClosedForm.
    bool isOtherWay = false;
    glm::dvec3 point{0.0};      ///< the answer to the first point
    double distance = 0.0;      ///< mean over the points
    double worst = 0.0;         ///< the greatest of the points
    std::size_t missed = 0;     ///< number of points that it does not explain
    std::size_t lastMissed = 0; ///< the last of them

    /// Counts a point's distance in `worst` and `missed`.
    void add(std::size_t index, double ofPoint);

    /// True if values were solved from the points.
    bool isSolved() const;
    /// True if such values are round, or stand in the scene.
    bool isExpected() const;
    /// The program after its last stage; empty if it has no answer.
    std::optional<Run> ranFor(const Given &given, const Click &click) const;
    /// The program's answer; empty if it has none.
    std::optional<glm::dvec3> answerTo(const Given &given, const Click &click) const;
    /// The answer closest to the given point.
    std::optional<Nearest> nearest(const Given &given, const Target &target) const;
};

/// True if two answers differ only by rounding.
bool isSameAnswer(const glm::dvec3 &a, const glm::dvec3 &b);

/// The variants of one mistake, and of two different ones. Mistakes without effect on all of the
/// points are omitted, and solved values that do not explain all points. Pairs have no solved
/// values.
/// @param list  must outlive the result
std::vector<Hypothesis> hypotheses(const Given &given, std::span<const Variant> list);

} // namespace unprojector::doctor
