#include "core/doctor/report_text.h"

#include "core/base/columns.h"
#include "core/base/number_text.h"
#include "core/base/translation.h"
#include "core/doctor/mistake_texts.h"
#include "core/doctor/remedies.h"
#include "core/doctor/verdict_texts.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <vector>

namespace unprojector::doctor {
using namespace base;
namespace {

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

/// The mistake, and the ones that cannot be distinguished from it.
std::string mistakeText(const Diagnosis &diagnosis)
{
    const Candidate &first = diagnosis.candidates.front();
    std::string names = nameOf(first), sentences = "  " + candidateSentence(first) + '\n';
    for (const Candidate &alike : diagnosis.alike()) {
        names = tr("%1 or %2|names", names, nameOf(alike));
        sentences +=
            "  " + tr("Or %1: %2", nameOf(alike), candidateSentence(alike)) + "\n  " + alikeSentence(alike) + '\n';
    }
    return names + '\n' + sentences;
}

std::string verdictText(const Diagnosis &diagnosis)
{
    const std::string except = diagnosis.except ? "  " + exceptSentence(diagnosis) + '\n' : std::string();
    if (diagnosis.namesMistake())
        return mistakeText(diagnosis) + except;
    const std::string text = verdictName(diagnosis) + "\n  " + verdictSentence(diagnosis) + '\n' + except;
    return diagnosis.depthKnown == DepthKnown::ByRay ? text + "  " + tr("--depth gives the depth.") + '\n' : text;
}

/// A line of the report, its name in the first column.
std::string line(const std::string &name, const std::string &value)
{
    return "  " + padded(name, 13) + value + '\n';
}

std::string candidateText(const Candidate &candidate, const Diagnosis &diagnosis, const WrongPoint &first)
{
    return tr("%1: %2, %3, off by %4 units of the last digit", nameOf(candidate),
              pointText(candidate.point, first.lastDigit), digitsText(candidate, diagnosis),
              significantText(candidate.distance, 3));
}

std::string codeText(const Candidate &candidate)
{
    const std::vector<std::string> parts = partsOf(candidate.id);
    std::string text;
    if (parts.size() == 2)
        text = '\n' + twoChangesSentence(parts[0], parts[1]) + '\n';
    for (const std::string &part : parts) {
        text += '\n' + tr("To change for %1:", part) + '\n';
        for (const CodeChange &change : codeOf(part, candidate.values)) {
            std::string name(change.library);
            name.resize(10, ' ');
            text += "  " + name + "- " + lineWithValues(change.wrong, candidate.values) + "\n            + "
                    + lineWithValues(change.right, candidate.values) + '\n';
        }
    }
    return text;
}

} // namespace

std::string reportText(const Diagnosis &diagnosis, const WrongPoint &first)
{
    const Candidate &best = diagnosis.candidates.front();
    std::string text = verdictText(diagnosis);
    if (diagnosis.isSinglePrecision)
        text += "  " + precisionSentence() + '\n';
    // A known point of the scene makes the closest candidate meaningless.
    const bool isKnown = diagnosis.verdict == "known-point";
    if (!isKnown)
        text += line(best.explains ? tr("explains|row") : tr("closest|row"), candidateText(best, diagnosis, first));
    for (const Candidate &other : diagnosis.asWell())
        text += line(tr("as well|row"), candidateText(other, diagnosis, first));
    if (const Candidate *next = isKnown ? nullptr : diagnosis.runnerUp())
        text += line(tr("next best"), candidateText(*next, diagnosis, first));
    if (!diagnosis.known.empty() && diagnosis.namesMistake())
        text += line(tr("is also|row"), knownPointName(diagnosis.known));
    if (diagnosis.next && diagnosis.verdict != "right" && !isKnown)
        text += line(tr("to be sure"), nextClickText(diagnosis));
    text += line(tr("projects|row"), projectedText(diagnosis));
    if (diagnosis.right)
        text += line(tr("right is"), pointText(*diagnosis.right, glm::dvec3(diagnosis.rightLastDigit)));
    if (diagnosis.depthKnown == DepthKnown::FromMesh)
        text += line(tr("depth|row"), tr("from the scene's mesh"));
    if (best.explains && best.id != "right" && !isKnown)
        text += line(tr("chance|row"), chanceText(diagnosis.chance));
    if (diagnosis.namesMistake())
        text += codeText(best);
    for (const Candidate &alike : diagnosis.alike())
        text += codeText(alike);
    return text;
}

} // namespace unprojector::doctor
