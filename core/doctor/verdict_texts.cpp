#include "core/doctor/verdict_texts.h"

#include "core/base/number_text.h"
#include "core/base/translation.h"
#include "core/doctor/mistake_texts.h"

#include <algorithm>

namespace unprojector::doctor {
using namespace base;
namespace {

std::string rightnessText(const Diagnosis &diagnosis)
{
    const bool isByRay = diagnosis.depthKnown == DepthKnown::ByRay;
    switch (diagnosis.wrong) {
    case ErrorKind::Right:
        return tr(isByRay ? "within the given digits, the pixel is right"
                          : "within the given digits, pixel and depth are right");
    case ErrorKind::Pixel: return tr("the depth is right, the pixel is not: pixel, viewport or lens");
    case ErrorKind::Depth: return tr("the pixel is right, the depth is not");
    case ErrorKind::Matrix:
        return tr(isByRay ? "the pixel is not right" : "neither pixel nor depth is right: a matrix");
    }
    return {};
}

std::string lackSentence(Lack lack)
{
    switch (lack) {
    case Lack::OtherDepth:
        return tr("All points have one depth, so near and far cannot be solved: give a point at another depth.");
    case Lack::Plane:
        return tr("The points lie on a line, so another frame cannot be solved: give a third point beside the line.");
    }
    return {};
}

std::string withLacks(std::string sentences, const std::vector<Lack> &lacks)
{
    for (const Lack lack : lacks)
        sentences = tr("%1 %2|sentences", sentences, lackSentence(lack));
    return sentences;
}

/// The sentence that one point allows each of several values.
std::string valuesSentence(const Diagnosis &diagnosis)
{
    constexpr std::size_t kMostNamed = 4;
    std::string names;
    int count = 0;
    for (std::size_t i = 0; i < std::min(kMostNamed, diagnosis.candidates.size()); ++i) {
        const Candidate &candidate = diagnosis.candidates[i];
        if (candidate.explains)
            names = ++count == 1 ? candidateName(candidate) : tr("%1 or %2|names", names, candidateName(candidate));
    }
    if (count == 1)
        return tr("A value would explain the point, but that may be chance: %1. Another wrong point shows whether it "
                  "is.",
                  names);
    return diagnosis.wrong == ErrorKind::Depth
               ? tr("A value would explain the point: %1. Another wrong point at another depth separates them.", names)
               : tr("A value would explain the point: %1. Another wrong point separates them.", names);
}

} // namespace

std::string candidateName(const Candidate &candidate)
{
    const std::string name = candidate.id == "right" ? tr("right|verdict") : mistakeName(candidate.id);
    return candidate.ways.empty() ? name : tr("%1 (%2)", name, waysText(candidate.ways));
}

std::string verdictName(const Diagnosis &diagnosis)
{
    if (diagnosis.verdict == "known-point")
        return knownPointName(diagnosis.known);
    if (diagnosis.verdict != "right")
        return tr("unknown|verdict");
    return diagnosis.depthKnown == DepthKnown::ByRay ? tr("right, as far as the ray shows") : tr("right|verdict");
}

std::string verdictSentence(const Diagnosis &diagnosis)
{
    const bool isByRay = diagnosis.depthKnown == DepthKnown::ByRay;
    const Candidate &first = diagnosis.candidates.front();
    if (diagnosis.verdict == "known-point")
        return knownPointSentence(diagnosis.known);
    if (diagnosis.verdict == "right")
        return tr(isByRay ? "The point lies on the ray of this pixel, between near and far. Its right depth is not "
                            "known: give the depth."
                  : diagnosis.isSinglePrecision ? "The point is right to the digits that single precision holds."
                                                : "The point is right to the digits given.");
    if (diagnosis.contradiction)
        return tr("Points %1 and %2 have the same pixel and depth but different coordinates: they contradict each "
                  "other.",
                  (*diagnosis.contradiction)[0] + 1, (*diagnosis.contradiction)[1] + 1);
    if (!diagnosis.known.empty())
        return tr("The point given may be %1, but that may be chance: give more digits.",
                  knownPointName(diagnosis.known));
    if (!first.explains)
        return withLacks(
            tr("No known mistake explains this point: %1 mistakes and pairs of them were tried.", diagnosis.tried),
            diagnosis.lacking);
    if (isByRay && diagnosis.wrong == ErrorKind::Depth)
        return tr("The pixel is right, and the depth is not. The ray alone cannot separate mistakes of the depth: give "
                  "the depth.");
    if (first.hasNumbers())
        return valuesSentence(diagnosis);
    return tr("\"%1\" would explain the point, but that may be chance: give more digits, or another click.",
              candidateName(first));
}

std::string exceptSentence(const Diagnosis &diagnosis)
{
    return tr("This holds for all points but point %1, at pixel %2 %3: check its digits.", diagnosis.except->point + 1,
              shortestText(diagnosis.except->pixel.x), shortestText(diagnosis.except->pixel.y));
}

std::string digitsText(const Candidate &candidate, const Diagnosis &diagnosis)
{
    // Digits without significance after rounding are part of the point, but no candidate explains
    // them.
    const int counted = diagnosis.digitsGiven;
    if (counted == 0)
        return tr("none of the %1 digits given counts: each is coarser than the distance from the eye",
                  diagnosis.digitsWritten);
    const bool countAll = counted == diagnosis.digitsWritten;
    const bool hasAll = candidate.digits == counted;
    const std::string text =
        countAll
            ? tr(hasAll ? "all %2 digits given" : "%1 of the %2 digits given", candidate.digits, counted)
            : tr(hasAll ? "all %2 digits that count of the %3 given" : "%1 of the %2 digits that count of the %3 given",
                 candidate.digits, counted, diagnosis.digitsWritten);
    return candidate.isCutOff ? tr("%1, the last not rounded but cut off", text) : text;
}

std::string projectedText(const Diagnosis &diagnosis)
{
    if (!diagnosis.projected)
        return tr("in the plane of the eye, by the right matrices");
    const glm::dvec3 &at = *diagnosis.projected;
    constexpr int kPixelDigits = 7;
    constexpr double kShare = 0.1; // the depth's missing part must not show in the point's last digit
    const std::string x = significantText(at.x, kPixelDigits), y = significantText(at.y, kPixelDigits),
                      depth = shortestText(at.z, kShare * diagnosis.depthUnsure);
    return diagnosis.tellsWrong()
               ? tr("to pixel %1 %2, depth %3, by the right matrices: %4", x, y, depth, rightnessText(diagnosis))
               : tr("to pixel %1 %2, depth %3, by the right matrices", x, y, depth);
}

std::string chanceText(double chance)
{
    constexpr double kLeast = 1e-6;
    return tr("%1 that an unrelated point is explained as well",
              chance < kLeast ? tr("less than 0.0001 %")
                              : significantText(100.0 * chance, chance < 0.1 ? 2 : 3) + " %");
}

std::string precisionSentence()
{
    return tr("More digits were given than single precision holds; only the digits that it holds are compared.");
}

std::string nextClickText(const Diagnosis &diagnosis)
{
    return tr(
        diagnosis.isNextFromRunnerUp() ? "against the next best, click at %1 %2: the answers are %3 or more apart there"
                                       : "click at %1 %2: the answers are %3 or more apart there",
        shortestText(diagnosis.next->x), shortestText(diagnosis.next->y), significantText(diagnosis.nextApart, 3));
}

std::string twoChangesSentence(const std::string &first, const std::string &second)
{
    return tr("Two changes: first \"%1\", then \"%2\". Each is shown here as if it were the only one.", first, second);
}

} // namespace unprojector::doctor
