#include "core/doctor/report_text.h"

#include "core/base/columns.h"
#include "core/base/number_text.h"
#include "core/base/translation.h"
#include "core/doctor/mistakes.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>

namespace unprojector::doctor {
using namespace base;
namespace {

/// Sentences one after another; the first ones may be empty.
std::string joined(const std::string &sentences, const std::string &next)
{
    return sentences.empty() ? next : tr("%1 %2|sentences", sentences, next);
}

/// A pattern of VariantName with its values.
std::string filledIn(const char *pattern, const VariantName &way)
{
    return filled(translated(pattern), way.values);
}

struct KnownText {
    const char *name;   ///< marked, %1 is the object, %2 the vertex
    const char *reason; ///< the usual cause, as a clause
};
/// In the order of KnownPoint::Kind.
constexpr KnownText kKnownTexts[] = {
    {marked("the eye"),
     marked("the program returns where the ray begins: the translation of the view's inverse, or the point at a "
            "distance of 0")},
    {marked("the translation of the view matrix"),
     marked("the program reads the eye from the last column of the view matrix; it is in the last column of the "
            "inverse")},
    {marked("the camera's centre"), marked("the program returns the point that the camera looks at, for every click")},
    {marked("the world's origin"),
     marked("the result was never set: a call failed or the ray hit nothing, and the program did not check it")},
    {marked("the origin of \"%1\""),
     marked("the program returns the translation of the model matrix: the object's position, not the clicked point")},
    {marked("vertex %2 of \"%1\""),
     marked("the program returns the nearest vertex of the mesh, not the point that is clicked")},
};

const KnownText &textsOf(const KnownPoint &known)
{
    return kKnownTexts[std::size_t(known.kind)];
}

/// In the order of Shared.
constexpr const char *kSharedSentences[] = {
    marked("Both unproject the same wrong window position."),
    marked("Both unproject the same wrong depth."),
    marked("Both use the same wrong projection matrix."),
    marked("Both use the same wrong view matrix."),
    marked("Both reach the same wrong NDC position."),
    marked("Both multiply by the same wrong matrix."),
    marked("They reach the same wrong point in different ways."),
};

/// In the order of Lack.
constexpr const char *kLackSentences[] = {
    marked("All points have one depth, so near and far cannot be solved: give a point at another depth."),
    marked("The points lie on a line, so another frame cannot be solved: give a third point beside the line."),
};

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

/// A coordinate with digits down to `lastDigit`.
std::string coordinateText(double value, double lastDigit)
{
    const int decimals = std::clamp(int(std::lround(-std::log10(lastDigit))), 0, 15);
    std::array<char, 400> text;
    const auto written =
        std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::fixed, decimals);
    std::string result(text.data(), written.ptr);
    if (result.front() == '-' && result.find_first_of("123456789") == std::string::npos)
        result.erase(0, 1);
    return result;
}

std::string pointText(const glm::dvec3 &point, const glm::dvec3 &lastDigit)
{
    return coordinateText(point.x, lastDigit.x) + ' ' + coordinateText(point.y, lastDigit.y) + ' '
           + coordinateText(point.z, lastDigit.z);
}

std::string nameOf(const Candidate &candidate)
{
    return candidate.ways.empty() ? candidate.id : tr("%1 (%2)", candidate.id, waysText(candidate.ways));
}

/// The verdict: the mistake with the ones that cannot be distinguished from it, or why none is
/// named.
report::Section verdictOf(const Diagnosis &diagnosis)
{
    std::string title;
    std::vector<report::Block> sentences;
    const auto add = [&sentences](std::string sentence) {
        sentences.push_back(report::Paragraph{std::move(sentence)});
    };
    if (diagnosis.namesMistake()) {
        title = nameOf(diagnosis.candidates.front());
        add(candidateSentence(diagnosis.candidates.front()));
        for (const Candidate &alike : diagnosis.alike()) {
            title = tr("%1 or %2|names", title, nameOf(alike));
            add(tr("Or %1: %2", nameOf(alike), candidateSentence(alike)));
            add(alikeSentence(alike));
        }
    } else {
        title = verdictName(diagnosis);
        add(verdictSentence(diagnosis));
    }
    if (diagnosis.except)
        add(exceptSentence(diagnosis));
    if (!diagnosis.namesMistake() && diagnosis.depthKnown == DepthKnown::ByRay)
        add(tr("--depth gives the depth."));
    if (diagnosis.isSinglePrecision)
        add(precisionSentence());
    return {title, sentences};
}

std::string candidateText(const Candidate &candidate, const Diagnosis &diagnosis, const WrongPoint &first)
{
    return tr("%1: %2, %3, off by %4 units of the last digit", nameOf(candidate),
              pointText(candidate.point, first.lastDigit), digitsText(candidate, diagnosis),
              significantText(candidate.distance, 3));
}

void addCode(report::Report &report, const Candidate &candidate)
{
    const std::vector<std::string> parts = partsOf(candidate.id);
    if (parts.size() == 2)
        report.push_back({twoChangesSentence(parts[0], parts[1]), {}, true});
    for (const std::string &part : parts) {
        report::Code code;
        for (const CodeChange &change : codeOf(part, candidate.values)) {
            code.lines.push_back(padded(change.library, 10) + "- " + change.wrong);
            code.lines.push_back(std::string(10, ' ') + "+ " + change.right);
        }
        report.push_back({tr("To change for %1:", part), {code}, true});
    }
}

} // namespace

std::vector<std::string> partsOf(std::string_view id)
{
    if (id.empty() || id == "right" || id == "unknown" || id == "known-point")
        return {};
    const std::size_t plus = id.find('+');
    if (plus == id.npos)
        return {std::string(id)};
    return {std::string(id.substr(0, plus)), std::string(id.substr(plus + 1))};
}

std::string mistakeName(std::string_view id)
{
    std::string names;
    for (const std::string &part : partsOf(id))
        names += (names.empty() ? "" : " + ") + tr(mistakeOf(part).name);
    return names;
}

std::string mistakeSentence(std::string_view id)
{
    std::string sentences;
    for (const std::string &part : partsOf(id))
        sentences = joined(sentences, tr(mistakeOf(part).sentence));
    return sentences;
}

std::string candidateSentence(const Candidate &candidate)
{
    std::string sentences;
    for (const VariantName &way : candidate.ways) {
        if (way.sentence != nullptr)
            sentences = joined(sentences, filledIn(way.sentence, way));
    }
    return joined(sentences, mistakeSentence(candidate.id));
}

std::string waysText(const std::vector<VariantName> &ways)
{
    std::string text;
    for (const VariantName &way : ways) {
        const std::string next = way.words == nullptr ? way.values.front() : filledIn(way.words, way);
        text = text.empty() ? next : tr("%1; %2|ways", text, next);
    }
    return text;
}

std::string knownPointName(const std::vector<KnownPoint> &known)
{
    std::string names;
    for (const KnownPoint &one : known) {
        const std::string name = tr(textsOf(one).name, one.object, one.vertex);
        names = names.empty() ? name : tr("%1 and %2|names", names, name);
    }
    return names;
}

std::string knownPointSentence(const std::vector<KnownPoint> &known)
{
    std::string sentences = tr("The point given is %1.", knownPointName(known));
    for (const KnownPoint &one : known)
        sentences = joined(sentences, tr(&one == &known.front() ? "Usually %1." : "Or %1.", tr(textsOf(one).reason)));
    return sentences;
}

std::string alikeSentence(const Candidate &candidate)
{
    const std::string shared = candidate.shared ? tr(kSharedSentences[std::size_t(*candidate.shared)]) : std::string();
    switch (candidate.alike) {
    case Alike::No: break;
    case Alike::InDigits:
        return candidate.hasNumbers()
                   ? tr("Both have a value that explains these points: another click separates them.")
                   : tr("These digits cannot separate them: give more digits, or another click.");
    case Alike::Here: return joined(shared, tr("They give the same point here: another click separates them."));
    case Alike::Always:
        return joined(shared, tr("They cannot be separated: every click in this scene gives the same point."));
    }
    return {};
}

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
    if (!first.explains) {
        std::string sentences =
            tr("No known mistake explains this point: %1 mistakes and pairs of them were tried.", diagnosis.tried);
        for (const Lack lack : diagnosis.lacking)
            sentences = joined(sentences, tr(kLackSentences[std::size_t(lack)]));
        return sentences;
    }
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

report::Report reportOf(const Diagnosis &diagnosis, const WrongPoint &first)
{
    const Candidate &best = diagnosis.candidates.front();
    // A known point of the scene makes the closest candidate meaningless.
    const bool isKnown = diagnosis.verdict == "known-point";
    report::Rows rows{13};
    if (!isKnown)
        rows.add(best.explains ? tr("explains|row") : tr("closest|row"), candidateText(best, diagnosis, first));
    for (const Candidate &other : diagnosis.asWell())
        rows.add(tr("as well|row"), candidateText(other, diagnosis, first));
    if (const Candidate *next = isKnown ? nullptr : diagnosis.runnerUp())
        rows.add(tr("next best"), candidateText(*next, diagnosis, first));
    if (!diagnosis.known.empty() && diagnosis.namesMistake())
        rows.add(tr("is also|row"), knownPointName(diagnosis.known));
    if (diagnosis.next && diagnosis.verdict != "right" && !isKnown)
        rows.add(tr("to be sure"), nextClickText(diagnosis));
    rows.add(tr("projects|row"), projectedText(diagnosis));
    if (diagnosis.right)
        rows.add(tr("right is"), pointText(*diagnosis.right, glm::dvec3(diagnosis.rightLastDigit)));
    if (diagnosis.depthKnown == DepthKnown::FromMesh)
        rows.add(tr("depth|row"), tr("from the scene's mesh"));
    if (best.explains && best.id != "right" && !isKnown)
        rows.add(tr("chance|row"), chanceText(diagnosis.chance));
    report::Report report{verdictOf(diagnosis)};
    report.front().blocks.push_back(rows);
    if (diagnosis.namesMistake())
        addCode(report, best);
    for (const Candidate &alike : diagnosis.alike())
        addCode(report, alike);
    return report;
}

} // namespace unprojector::doctor
