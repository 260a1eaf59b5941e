#include "core/cli/commands/doctor_texts.h"

#include "core/base/number_text.h"
#include "core/base/translation.h"
#include "core/doctor/mistakes.h"
#include "core/doctor/report_text.h"
#include "core/scene_file/json_text.h"

#include <nlohmann/json.hpp>

#include <string_view>
#include <vector>

namespace unprojector::cli {
using namespace doctor;
using namespace scene_file;
using namespace base;
namespace {

using Json = nlohmann::ordered_json;

Json jsonOf(const glm::dvec3 &v)
{
    return Json::array({jsonNumber(v.x), jsonNumber(v.y), jsonNumber(v.z)});
}

/// One number, an array of several, or a word under each name.
Json jsonOf(const std::vector<SolvedValue> &values)
{
    Json json = Json::object();
    for (const SolvedValue &value : values) {
        Json numbers = Json::array();
        for (const double number : value.numbers)
            numbers.push_back(jsonNumber(number));
        json[value.name] = !value.word.empty() ? Json(value.word) : numbers.size() == 1 ? numbers.front() : numbers;
    }
    return json;
}

std::string_view errorKindName(ErrorKind kind)
{
    switch (kind) {
    case ErrorKind::Right: return "right";
    case ErrorKind::Pixel: return "pixel";
    case ErrorKind::Depth: return "depth";
    case ErrorKind::Matrix: return "matrix";
    }
    return {};
}

std::string_view alikeName(Alike alike)
{
    switch (alike) {
    case Alike::No: return "no";
    case Alike::InDigits: return "digits";
    case Alike::Here: return "here";
    case Alike::Always: return "always";
    }
    return {};
}

std::string_view sharedName(Shared shared)
{
    switch (shared) {
    case Shared::Window: return "window";
    case Shared::Depth: return "depth";
    case Shared::Projection: return "projection";
    case Shared::View: return "view";
    case Shared::Ndc: return "ndc";
    case Shared::Matrix: return "matrix";
    case Shared::Point: return "point";
    }
    return {};
}

std::string_view kindName(KnownPoint::Kind kind)
{
    switch (kind) {
    case KnownPoint::Kind::Eye: return "eye";
    case KnownPoint::Kind::ViewTranslation: return "view-translation";
    case KnownPoint::Kind::CameraCentre: return "camera-centre";
    case KnownPoint::Kind::WorldOrigin: return "world-origin";
    case KnownPoint::Kind::ObjectOrigin: return "object-origin";
    case KnownPoint::Kind::Vertex: return "vertex";
    }
    return {};
}

Json jsonOf(const KnownPoint &known)
{
    Json one{{"kind", kindName(known.kind)}, {"point", jsonOf(known.point)}};
    if (!known.object.empty())
        one["object"] = known.object;
    if (known.kind == KnownPoint::Kind::Vertex)
        one["vertex"] = known.vertex;
    return one;
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

} // namespace

std::string doctorJson(const Diagnosis &diagnosis)
{
    const InEnglish english;
    Json json;
    json["verdict"] = diagnosis.verdict;
    if (diagnosis.except)
        json["except"] = Json::array({diagnosis.except->point + 1});
    json["candidates"] = Json::array();
    for (const Candidate &candidate : diagnosis.candidates) {
        Json one{{"id", candidate.id},
                 {"point", jsonOf(candidate.point)},
                 {"distance", jsonNumber(candidate.distance)},
                 {"digits", candidate.digits},
                 {"explains", candidate.explains}};
        if (!candidate.values.empty())
            one["values"] = jsonOf(candidate.values);
        if (!candidate.ways.empty())
            one["variant"] = waysText(candidate.ways);
        if (candidate.alike != Alike::No)
            one["alike"] = alikeName(candidate.alike);
        if (candidate.shared)
            one["shared"] = sharedName(*candidate.shared);
        json["candidates"].push_back(one);
    }
    json["known"] = Json::array();
    for (const KnownPoint &known : diagnosis.known)
        json["known"].push_back(jsonOf(known));
    json["projected"] = diagnosis.projected ? jsonOf(*diagnosis.projected) : Json();
    json["next"] = Json();
    if (diagnosis.next)
        json["next"] = {{"pixel", Json::array({jsonNumber(diagnosis.next->x), jsonNumber(diagnosis.next->y)})},
                        {"apart", jsonNumber(diagnosis.nextApart)}};
    json["right"] = diagnosis.right ? jsonOf(*diagnosis.right) : Json();
    json["digitsGiven"] = diagnosis.digitsGiven;
    json["digitsWritten"] = diagnosis.digitsWritten;
    json["wrong"] = diagnosis.tellsWrong() ? Json(errorKindName(diagnosis.wrong)) : Json();
    json["depth"] = depthName(diagnosis.depthKnown);
    json["tried"] = diagnosis.tried;
    json["singlePrecision"] = diagnosis.isSinglePrecision;
    json["chance"] = jsonNumber(diagnosis.chance);
    json["sentence"] = diagnosis.verdict == "known-point" ? knownPointSentence(diagnosis.known)
                       : diagnosis.namesMistake()         ? candidateSentence(diagnosis.candidates.front())
                                                          : std::string();
    json["code"] = Json::array();
    for (const std::string &part : partsOf(diagnosis.verdict)) {
        for (const CodeChange &change : codeOf(part, diagnosis.candidates.front().values))
            json["code"].push_back(
                {{"id", part}, {"library", change.library}, {"wrong", change.wrong}, {"right", change.right}});
    }
    return jsonLine(json) + '\n';
}

} // namespace unprojector::cli
