#include "unprojector/diagnose.h"

#include "core/base/number_text.h"
#include "core/base/translation.h"
#include "core/doctor/diagnosis.h"
#include "core/doctor/known_points.h"
#include "core/doctor/mistakes.h"
#include "core/doctor/report_text.h"
#include "core/doctor/written_points.h"
#include "core/library/internal.h"
#include "core/library/scene_data.h"
#include "core/ray/mesh_point.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace unprojector {
namespace {

WrongPoint publicPoint(const doctor::WrongPoint &point)
{
    return {point.pixel.coordinates(), point.depth, point.got, point.lastDigit, point.depthLastDigit};
}

Candidate publicCandidate(const doctor::Candidate &candidate)
{
    Candidate result;
    result.id = candidate.id;
    result.sentence = doctor::candidateSentence(candidate);
    for (const doctor::SolvedValue &value : candidate.values) {
        if (value.word.empty())
            result.values.emplace_back(value.name, value.numbers);
        else
            result.values.emplace_back(value.name, value.word);
    }
    result.point = candidate.point;
    result.distance = candidate.distance;
    result.explains = candidate.explains;
    return result;
}

Diagnosis publicDiagnosis(const doctor::Diagnosis &diagnosis, const doctor::WrongPoint &first)
{
    Diagnosis result;
    result.verdict = diagnosis.verdict;
    result.sentence = diagnosis.namesMistake() ? doctor::candidateSentence(diagnosis.candidates.front())
                                               : doctor::verdictSentence(diagnosis);
    const report::Report report = doctor::reportOf(diagnosis, first);
    result.report = asText(report);
    result.html = asHtml(report);
    for (const doctor::Candidate &candidate : diagnosis.candidates)
        result.candidates.push_back(publicCandidate(candidate));
    const auto &values = diagnosis.candidates.front().values;
    for (const std::string &part : doctor::partsOf(diagnosis.verdict)) {
        for (const doctor::CodeChange &change : doctor::codeOf(part, values))
            result.code.push_back({part, change.library, change.wrong, change.right});
    }
    result.right = diagnosis.right;
    if (diagnosis.next)
        result.next = diagnosis.next->coordinates();
    result.chance = diagnosis.chance;
    return result;
}

/// The point's name in messages; its index where there are several.
std::string nameOf(std::size_t index, std::size_t count)
{
    return count == 1 ? std::string("pixel") : "pixel[" + std::to_string(index) + ']';
}

Result<Diagnosis> diagnosed(doctor::Case scene, std::span<const WrongPoint> points, const DiagnoseOptions &options)
{
    if (points.empty())
        return valueError(
            base::tr("there is no point to examine; give a pixel and the coordinate that the program got"));
    if (points.size() > doctor::kMostWrongPoints)
        return valueError(base::tr("there are %1 points; give at most %2, more add no information", points.size(),
                                   doctor::kMostWrongPoints));
    if (options.otherSize) {
        scene.otherSize = geometry::Surface{options.otherSize->first, options.otherSize->second, 1.0};
        if (const geometry::Check valid = check(*scene.otherSize); !valid)
            return valueError("other_size: " + geometry::errorText(valid.error()));
    }
    const geometry::Surface &surface = scene.setup.surface;
    std::vector<doctor::WrongPoint> given;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const WrongPoint &point = points[i];
        const glm::dvec2 &at = point.pixel;
        if (!(at.x >= 0.0 && at.y >= 0.0 && at.x <= surface.widthPixels && at.y <= surface.heightPixels))
            return valueError(
                base::tr("%1: %2,%3 lies outside the view of %4x%5; give device pixels from its top left corner",
                         nameOf(i, points.size()), base::shortestText(at.x), base::shortestText(at.y),
                         surface.widthPixels, surface.heightPixels));
        const glm::dvec3 &digit = point.lastDigit;
        if (!(digit.x > 0.0 && digit.y > 0.0 && digit.z > 0.0 && std::isfinite(digit.x + digit.y + digit.z)))
            return valueError(base::tr("%1: the unit of a last digit is %2; it must be greater than 0",
                                       nameOf(i, points.size()),
                                       base::shortestText(std::min({digit.x, digit.y, digit.z}))));
        given.push_back({geometry::DevicePoint(at), point.depth, point.got, point.lastDigit,
                         options.space == Space::Eye ? doctor::PointSpace::Eye : doctor::PointSpace::World, 0,
                         point.depthLastDigit});
    }
    const auto diagnosis = doctor::diagnose(scene, given);
    if (diagnosis)
        return publicDiagnosis(*diagnosis, given[diagnosis->firstPoint()]);
    const geometry::Error &error = diagnosis.error();
    if (error.code == geometry::ErrorCode::DepthOutsideRange)
        return valueError("depth: "
                          + doctor::depthOutsideText(base::shortestText(error.value), scene.setup.depthRange));
    return valueError(error);
}

} // namespace

Result<WrongPoint> wrongPoint(const std::string &pixel, const std::string &depth, const std::string &got)
{
    const auto point = doctor::wrongPointOf(pixel, depth, got);
    if (!point)
        return valueError(point.error());
    return publicPoint(*point);
}

Result<Diagnosis> diagnose(const Setup &setup, std::span<const WrongPoint> points, const DiagnoseOptions &options)
{
    return diagnosed({SetupAccess::of(setup), {}, {}, {}, {}}, points, options);
}

Result<Diagnosis> diagnose(const Scene &scene, std::span<const WrongPoint> points, const DiagnoseOptions &options)
{
    const opening::OpenedScene &opened = SceneAccess::of(scene);
    doctor::Case examined{SetupAccess::of(scene.setup()), {}, {}, {}, {}};
    for (const scene::SceneObject &object : opened.objects)
        examined.models.push_back({object.name, geometry::preciseWorldFromObject(object.transform)});
    if (!opened.objects.empty()) {
        const SceneAccess::Rays rays = SceneAccess::rays(scene, examined.setup);
        if (!rays)
            return rays.error();
        examined.pointOnMesh = ray::MeshPoint(*rays);
        examined.verticesIn = [&opened](const geometry::Box &world) {
            return doctor::verticesIn(opened.objects, world);
        };
    }
    return diagnosed(std::move(examined), points, options);
}

} // namespace unprojector
