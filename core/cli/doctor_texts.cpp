#include "core/cli/doctor_texts.h"

#include "core/doctor/remedies.h"
#include "core/scene_file/json_text.h"
#include "core/text/number_text.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <string_view>
#include <vector>

namespace unprojector::cli {
using namespace doctor;
using namespace scene_file;
using namespace text;
namespace {

using Json = nlohmann::ordered_json;

Json jsonOf(const glm::dvec3 &v)
{
    return Json::array({jsonNumber(v.x), jsonNumber(v.y), jsonNumber(v.z)});
}

/// The mistakes of an id: none, one or two.
std::vector<std::string> partsOf(const std::string &id)
{
    if (id == "right" || id == "unknown")
        return {};
    const std::size_t plus = id.find('+');
    if (plus == std::string::npos)
        return {id};
    return {id.substr(0, plus), id.substr(plus + 1)};
}

std::string_view landingName(Landing landing)
{
    switch (landing) {
    case Landing::Right: return "right";
    case Landing::Pixel: return "pixel";
    case Landing::Depth: return "depth";
    case Landing::Matrix: return "matrix";
    }
    return {};
}

std::string_view depthName(DepthKnown known)
{
    switch (known) {
    case DepthKnown::Given: return "given";
    case DepthKnown::FromMesh: return "mesh";
    case DepthKnown::ByRay: return "unknown";
    }
    return {};
}

/// Up to so many significant digits.
std::string shortText(double value, int digits)
{
    std::array<char, 32> text;
    const auto written =
        std::to_chars(text.data(), text.data() + text.size(), value + 0.0, std::chars_format::general, digits);
    return {text.data(), written.ptr};
}

/// A coordinate with the digits that its last one allows.
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
    return candidate.id + (candidate.variant.empty() ? "" : " (" + candidate.variant + ')');
}

std::string sentenceOf(const std::string &id)
{
    std::string sentence;
    for (const std::string &part : partsOf(id))
        sentence += (sentence.empty() ? "" : " ") + std::string(remedyOf(part).sentence);
    return sentence;
}

/// Digits that rounding leaves nothing of are given, and explained by nobody.
std::string digitsText(const Candidate &candidate, const Diagnosis &diagnosis)
{
    const int counted = diagnosis.digitsGiven;
    const bool countAll = counted == diagnosis.digitsWritten;
    const std::string which = std::to_string(counted) + (countAll ? " digits given" : " digits that count")
                              + (countAll ? "" : " of the " + std::to_string(diagnosis.digitsWritten) + " given");
    return (candidate.digits == counted ? "all " : std::to_string(candidate.digits) + " of the ") + which
           + (candidate.isCutOff ? ", the last not rounded but cut off" : "");
}

std::string percent(double share)
{
    return share < 1e-6 ? "less than 0.0001 %" : shortText(100.0 * share, share >= 0.1 ? 3 : 2) + " %";
}

std::string verdictText(const Diagnosis &diagnosis)
{
    const Candidate &first = diagnosis.candidates.front();
    if (diagnosis.verdict == "right") {
        if (diagnosis.depthKnown == DepthKnown::ByRay)
            return "right, as far as the ray tells\n  The point lies on the ray of this pixel, between near and far. "
                   "Whether its depth is right is not known: give --depth.\n";
        return "right\n  The point is right to the digits given.\n";
    }
    if (diagnosis.verdict != "unknown")
        return nameOf(first) + "\n  " + sentenceOf(first.id) + '\n';
    if (!first.explains)
        return "unknown\n  Nothing that is known explains this point: none of " + std::to_string(diagnosis.tried)
               + " mistakes and pairs of them.\n";
    if (diagnosis.depthKnown == DepthKnown::ByRay && diagnosis.landing == Landing::Depth)
        return "unknown\n  The pixel is right, and the depth is not; by the ray alone the mistakes of the depth cannot "
               "be told from each other: give --depth.\n";
    return "unknown\n  " + nameOf(first)
           + " would explain the point, but that may be chance: give more digits, or another click.\n";
}

std::string landingText(const Diagnosis &diagnosis)
{
    if (!diagnosis.projected)
        return "  lands        in the plane of the eye, by the right matrices\n";
    const glm::dvec3 &at = *diagnosis.projected;
    const bool isByRay = diagnosis.depthKnown == DepthKnown::ByRay;
    std::string text = "  lands        on pixel " + shortText(at.x, 7) + ' ' + shortText(at.y, 7) + ", depth "
                       + shortText(at.z, 7) + ", by the right matrices: ";
    switch (diagnosis.landing) {
    case Landing::Right:
        return text
               + (isByRay ? "as far as the digits given tell, the pixel is right\n"
                          : "as far as the digits given tell, pixel and depth are right\n");
    case Landing::Pixel: return text + "the depth is right, the pixel is not: pixel, viewport or lens\n";
    case Landing::Depth: return text + "the pixel is right, the depth is not\n";
    case Landing::Matrix:
        return text + (isByRay ? "the pixel is not right\n" : "neither pixel nor depth is right: a matrix\n");
    }
    return text;
}

std::string candidateText(const Candidate &candidate, const Diagnosis &diagnosis, const WrongPoint &first)
{
    return nameOf(candidate) + ": " + pointText(candidate.point, first.lastDigit) + ", "
           + digitsText(candidate, diagnosis) + ", off by " + shortText(candidate.distance, 3)
           + " units of the last digit\n";
}

std::string codeText(const std::string &id)
{
    const std::vector<std::string> parts = partsOf(id);
    std::string text;
    if (parts.size() == 2)
        text = "\nTwo changes: first that for " + parts[0] + ", then that for " + parts[1]
               + " in what it leaves; each is written here as if it were the only one.\n";
    for (const std::string &part : parts) {
        text += "\nTo change for " + part + ":\n";
        for (const CodeChange &change : remedyOf(part).code) {
            std::string name(change.library);
            name.resize(10, ' ');
            text +=
                "  " + name + "- " + std::string(change.wrong) + "\n            + " + std::string(change.right) + '\n';
        }
    }
    return text;
}

} // namespace

std::string doctorJson(const Diagnosis &diagnosis)
{
    Json json;
    json["verdict"] = diagnosis.verdict;
    json["candidates"] = Json::array();
    for (const Candidate &candidate : diagnosis.candidates) {
        Json one{{"id", candidate.id},
                 {"point", jsonOf(candidate.point)},
                 {"distance", jsonNumber(candidate.distance)},
                 {"digits", candidate.digits},
                 {"explains", candidate.explains}};
        if (!candidate.variant.empty())
            one["variant"] = candidate.variant;
        json["candidates"].push_back(one);
    }
    json["projected"] = diagnosis.projected ? jsonOf(*diagnosis.projected) : Json();
    json["next"] = Json();
    if (diagnosis.next)
        json["next"] = {{"pixel", Json::array({jsonNumber(diagnosis.next->x), jsonNumber(diagnosis.next->y)})},
                        {"apart", jsonNumber(diagnosis.nextApart)}};
    json["right"] = diagnosis.right ? jsonOf(*diagnosis.right) : Json();
    json["digitsGiven"] = diagnosis.digitsGiven;
    json["digitsWritten"] = diagnosis.digitsWritten;
    json["wrong"] = landingName(diagnosis.landing);
    json["depth"] = depthName(diagnosis.depthKnown);
    json["tried"] = diagnosis.tried;
    json["singlePrecision"] = diagnosis.isSinglePrecision;
    json["chance"] = jsonNumber(diagnosis.chance);
    json["sentence"] = sentenceOf(diagnosis.verdict);
    json["code"] = Json::array();
    for (const std::string &part : partsOf(diagnosis.verdict)) {
        for (const CodeChange &change : remedyOf(part).code)
            json["code"].push_back(
                {{"id", part}, {"library", change.library}, {"wrong", change.wrong}, {"right", change.right}});
    }
    return jsonLine(json) + '\n';
}

std::string doctorText(const Diagnosis &diagnosis, const WrongPoint &first)
{
    const Candidate &best = diagnosis.candidates.front();
    std::string text = verdictText(diagnosis);
    if (diagnosis.isSinglePrecision)
        text += "  More digits were given than single precision holds; this is to the digits that it leaves.\n";
    text += (best.explains ? "  explains     " : "  closest      ") + candidateText(best, diagnosis, first);
    if (diagnosis.candidates.size() > 1)
        text += "  next best    " + candidateText(diagnosis.candidates[1], diagnosis, first);
    if (diagnosis.next && diagnosis.verdict != "right")
        text += "  tell apart   by a click at " + shortestText(diagnosis.next->x) + ' '
                + shortestText(diagnosis.next->y) + ": the answers are " + shortText(diagnosis.nextApart, 3)
                + " or more apart there\n";
    text += landingText(diagnosis);
    if (diagnosis.right && diagnosis.depthKnown != DepthKnown::ByRay)
        text += "  right is     " + pointText(*diagnosis.right, glm::dvec3(diagnosis.rightLastDigit)) + '\n';
    if (diagnosis.depthKnown == DepthKnown::FromMesh)
        text += "  depth        from the scene's mesh\n";
    if (best.explains && best.id != "right")
        text += "  chance       " + percent(diagnosis.chance) + " that a point of other making is explained as well\n";
    return text + codeText(diagnosis.verdict);
}

} // namespace unprojector::cli
