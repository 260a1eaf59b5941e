#pragma once

#include "core/lessons/lesson.h"
#include "core/lessons/step_numbers.h"

#include <optional>
#include <string_view>
#include <vector>

/// The classic wrong answers to the questions of lessons, recognised from the numbers of the step.
namespace unprojector::lessons {

/// The kind of number that a question asks for, as far as wrong answers depend on it.
enum class AskedKind {
    Other,
    WindowX,
    WindowY,     ///< from the bottom
    DeviceX,     ///< device or widget coordinates, from the upper left corner
    DeviceY,     ///< like DeviceX, downwards
    Row,         ///< a row of pixels, counted from the bottom, as glReadPixels counts
    WindowDepth, ///< window z
    NdcZ,
    EyeZ,
    Distance, ///< in front of the eye: -z of the eye
};

/// The question of a step, and the numbers by which a wrong answer is recognised.
struct Asked {
    AskedKind kind = AskedKind::Other;
    double answer = 0.0;
    double tolerance = 0.0;
    double height = 0.0; ///< of the view, device pixels
    double ratio = 1.0;  ///< device pixels per logical one
    std::optional<double> nearDistance{};
    std::optional<double> farDistance{};
    bool isPerspective = false;
    double depthAtNear = 0.0; ///< of glDepthRange
    double depthAtFar = 1.0;
    std::vector<double> anglesDegrees{}; ///< of the projection, as they enter a tangent: half a field of view, θ, φ
};

/// The slip that leads to a wrong answer.
enum class SlipKind {
    LeftEdge, ///< of the pixel, half a pixel left of its centre
    RightEdge,
    UpperEdge,
    LowerEdge,
    RowAbove,     ///< height − row, without the − 1
    RowCentre,    ///< a row is a whole number
    NotFlipped,   ///< counted from the top
    Flipped,      ///< counted from the bottom
    TimesRatio,   ///< multiplied by the pixel ratio
    OverRatio,    ///< divided by it
    DistanceForZ, ///< without the sign of −z
    Sign,
    NearFarSwapped,
    NdcForDepth,       ///< z in [−1, 1] given for the depth
    DepthForNdc,       ///< the depth given for z in [−1, 1]
    EvenDepth,         ///< a perspective's depth taken for an even scale
    DegreesForRadians, ///< the tangent of the degrees as if they were radians, or the whole answer
    RadiansForDegrees,
};

/// The kind of number that a source gives.
/// @param source  an expression of StepNumbers, as Question::answer
AskedKind askedKind(std::string_view source);

/// The question of a step with its numbers.
/// @return empty if the step has no question, or if its answer cannot be computed
std::optional<Asked> askedIn(const LessonNumbers &numbers, const Step &step);

/// Returns whether an answer is right within the question's tolerance.
bool isRight(const Asked &asked, double given);

/// The slip that a wrong answer comes from; the first in the order of SlipKind where several lead
/// to it.
/// @return empty if no slip does, or if the answer is right
std::optional<SlipKind> slipOf(const Asked &asked, double given);

} // namespace unprojector::lessons
