#include "tests/support/doctor_bar.h"

#include "core/doctor/report_text.h"

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

namespace doctor_bar {
using namespace unprojector;
using namespace unprojector::geometry;
using oracle::Random;
using wrong_programs::Made;
using wrong_programs::printed;

namespace {

constexpr double kStep = 1e-4;

glm::dvec3 inFourDecimals(const glm::dvec3 &p)
{
    return glm::dvec3(std::round(p.x / kStep), std::round(p.y / kStep), std::round(p.z / kStep)) * kStep;
}

bool isSame(const glm::dvec3 &a, const glm::dvec3 &b)
{
    const glm::dvec3 d = glm::abs(inFourDecimals(a) - inFourDecimals(b));
    return std::max({d.x, d.y, d.z}) < kStep / 2.0;
}

glm::dvec3 randomIn(Random &random, double size)
{
    const double x = random.uniform(-size, size), y = random.uniform(-size, size), z = random.uniform(-size, size);
    return {x, y, z};
}

template <std::size_t N>
double oneOf(Random &random, const std::array<double, N> &choices)
{
    return choices[std::size_t(random.integer(0, int(N) - 1))];
}

void setWindow(Random &random, wrong_programs::Scene &scene)
{
    const int width = random.integer(400, 2000), height = random.integer(300, 1200);
    scene.framebufferWidth = width;
    scene.framebufferHeight = height;
    scene.viewport = {0.0, 0.0, width, height};
    if (random.chance(0.1))
        scene.viewport.z = scene.viewport.w = scene.framebufferWidth = scene.framebufferHeight;
    else if (random.chance(0.6))
        scene.viewport = {random.integer(5, width / 4), random.integer(5, height / 4),
                          random.integer(width / 2, 3 * width / 4), random.integer(height / 2, 3 * height / 4)};
    scene.pixelRatio = random.chance(0.3) ? 1.0 : oneOf(random, std::array{1.25, 1.5, 1.75, 2.0, 3.0});
}

void setCamera(Random &random, wrong_programs::Scene &scene)
{
    const std::array<glm::dvec3, 3> ups{glm::dvec3(0, 1, 0), glm::dvec3(0, 1, 0), glm::dvec3(0, 0, 1)};
    do {
        scene.target = random.chance(0.3) ? glm::dvec3(0.0) : randomIn(random, 2.0);
        scene.eye = randomIn(random, 10.0);
        scene.up = ups[std::size_t(random.integer(0, 2))];
    } while (glm::length(scene.eye - scene.target) < 4.0
             || glm::length(glm::cross(glm::normalize(scene.eye - scene.target), scene.up)) < 0.2);
    scene.lens.isPerspective = random.chance(0.75);
    scene.lens.fovyRadians = random.uniform(25.0, 75.0) * std::numbers::pi / 180.0;
    scene.lens.height = random.uniform(4.0, 20.0);
    scene.lens.aspect = scene.viewport.z / scene.viewport.w;
    scene.lens.nearDistance = random.logUniform(0.05, 1.0);
    scene.lens.farDistance = random.logUniform(50.0, 1000.0);
    const glm::dmat4 placed = glm::rotate(glm::translate(glm::dmat4(1.0), randomIn(random, 3.0)),
                                          random.uniform(0.2, 3.0), glm::normalize(randomIn(random, 1.0)));
    scene.worldFromObject = glm::scale(placed, glm::dvec3(random.uniform(0.5, 2.0)));
}

/// The others with the same output: "right" for the right point, and other mistakes.
std::vector<std::string> twinsOf(const Shot &shot, const glm::dvec3 &point, const std::string &id)
{
    if (isSame(point, shot.truth))
        return {"right"};
    std::vector<std::string> twins;
    std::array scenes{shot.scene, shot.scene};
    scenes[1].pixelRatio = 2.0; // K of half the size prints the same as this ratio
    for (const wrong_programs::Mistake &other : wrong_programs::mistakes()) {
        for (int variant = 0; variant < other.variants && other.id != id; ++variant) {
            for (const wrong_programs::Scene &scene : scenes) {
                const auto p = printed(scene, shot.click, {{other.id, variant}});
                if (p && isSame(*p, point))
                    twins.emplace_back(other.id);
            }
        }
    }
    return twins;
}

bool isId(const std::string &given, const std::string &id)
{
    const std::size_t plus = id.find('+');
    return given == id || (plus != std::string::npos && given == id.substr(plus + 1) + '+' + id.substr(0, plus));
}

std::string described(const Shot &shot, const glm::dvec3 &point)
{
    const auto text = [](double number) { return std::to_string(number); };
    const wrong_programs::Scene &s = shot.scene;
    return std::string(s.lens.isPerspective ? "perspective" : "box") + ", viewport " + text(s.viewport.x) + ' '
           + text(s.viewport.y) + ' ' + text(s.viewport.z) + ' ' + text(s.viewport.w) + " in "
           + text(s.framebufferWidth) + ' ' + text(s.framebufferHeight) + ", ratio " + text(s.pixelRatio) + " told "
           + text(shot.ratioTold) + ", pixel " + text(shot.click.px) + ' ' + text(shot.click.py) + ", got "
           + text(point.x) + ' ' + text(point.y) + ' ' + text(point.z);
}

} // namespace

Shot randomShot(Random &random)
{
    for (;;) {
        Shot shot;
        setWindow(random, shot.scene);
        setCamera(random, shot.scene);
        shot.ratioTold = random.chance(0.5) ? shot.scene.pixelRatio : 1.0;
        const glm::dvec4 &v = shot.scene.viewport;
        const double left = v.x + random.integer(0, int(v.z) - 1);
        const double top = shot.scene.framebufferHeight - (v.y + random.integer(1, int(v.w)));
        const double z = glm::length(shot.scene.eye - shot.scene.target) * random.uniform(0.5, 1.5);
        const glm::dvec3 forward = glm::normalize(shot.scene.target - shot.scene.eye);
        shot.click = {left + 0.5, top + 0.5, clickOn(shot.scene, shot.scene.eye + z * forward).depth};
        shot.truth = *printed(shot.scene, shot.click, {});
        const double size = std::max({std::abs(shot.truth.x), std::abs(shot.truth.y), std::abs(shot.truth.z)});
        if (size >= 1.0 && size <= 10.0)
            return shot;
    }
}

doctor::Case caseOf(const Shot &shot)
{
    const wrong_programs::Scene &s = shot.scene;
    const wrong_programs::Lens &lens = s.lens;
    doctor::Case result;
    Setup &setup = result.setup;
    setup.surface = {int(s.framebufferWidth), int(s.framebufferHeight), shot.ratioTold};
    setup.viewport = {s.viewport.x, s.viewport.y, s.viewport.z, s.viewport.w};
    const double top = lens.height / 2.0, right = top * lens.aspect;
    if (lens.isPerspective)
        setup.lens = Projection(Perspective{lens.fovyRadians, lens.aspect, lens.nearDistance, lens.farDistance});
    else
        setup.lens = Projection(Ortho{-right, right, -top, top, lens.nearDistance, lens.farDistance});
    setup.pose = LookAt{WorldPoint(s.eye.x, s.eye.y, s.eye.z), WorldPoint(s.target.x, s.target.y, s.target.z),
                        WorldVector(s.up.x, s.up.y, s.up.z)};
    result.models = {{"model", s.worldFromObject}};
    return result;
}

Result<doctor::Diagnosis> diagnosed(const Shot &shot, const glm::dvec3 &got)
{
    doctor::WrongPoint point;
    point.pixel = DevicePoint(shot.click.px, shot.click.py);
    point.depth = shot.click.depth;
    point.got = inFourDecimals(got);
    point.lastDigit = glm::dvec3(kStep);
    return doctor::diagnose(caseOf(shot), std::array{point});
}

void Tally::add(const std::string &id, const doctor::Diagnosis &diagnosis, const std::vector<std::string> &twins,
                const std::string &what)
{
    const auto place = std::find_if(diagnosis.candidates.begin(), diagnosis.candidates.end(),
                                    [&](const doctor::Candidate &c) { return isId(c.id, id); });
    const auto before = place == diagnosis.candidates.end() ? 1000 : place - diagnosis.candidates.begin();
    const bool isTwin = !diagnosis.candidates.empty()
                        && std::find(twins.begin(), twins.end(), diagnosis.candidates.front().id) != twins.end();
    const bool isNamed = before == 0 && isId(diagnosis.verdict, id);
    for (Count *count : {&all, &ofId[id]}) {
        ++count->asked;
        count->first += isNamed ? 1 : 0;
        count->firstThree += before < 3 ? 1 : 0;
        count->firstOrTwin += isNamed || isTwin ? 1 : 0;
    }
    if (isNamed)
        return;
    std::string named;
    for (std::size_t i = 0; i < std::min<std::size_t>(3, diagnosis.candidates.size()); ++i) {
        const doctor::Candidate &c = diagnosis.candidates[i];
        named += ' ' + c.id + (c.ways.empty() ? "" : " (" + doctor::waysText(c.ways) + ')') + ' '
                 + std::to_string(c.distance);
    }
    missed.push_back(id
                     + (before == 0  ? " (verdict " + diagnosis.verdict + "):"
                        : isTwin     ? " (twin):"
                        : before < 3 ? " (in three):"
                                     : " (lost):")
                     + named + "; " + what);
}

std::string lines(const std::vector<std::string> &texts)
{
    std::string all;
    for (const std::string &text : texts)
        all += text + '\n';
    return all;
}

void addSingles(Tally &tally, Random &random, int shots)
{
    for (int i = 0; i < shots; ++i) {
        const Shot shot = randomShot(random);
        for (const wrong_programs::Mistake &mistake : wrong_programs::mistakes()) {
            const Made made{mistake.id, i % mistake.variants};
            const auto point = printed(shot.scene, shot.click, {made});
            const std::string id(mistake.id);
            if (!point)
                continue;
            const auto diagnosis = diagnosed(shot, *point);
            const std::vector<std::string> twins = twinsOf(shot, *point, id);
            const bool isRight = twins == std::vector<std::string>{"right"};
            tally.add(isRight ? "right" : id, diagnosis ? *diagnosis : doctor::Diagnosis{}, twins,
                      "variant " + std::to_string(made.variant) + ", " + described(shot, *point));
        }
    }
}

void addPairs(Tally &tally, Random &random, int shots)
{
    static const std::vector<std::string> common{"ratio-logical-in-device", "viewport-origin-ignored",
                                                 "ortho-formula",           "far-differs",
                                                 "depth-not-remapped",      "depth-zero",
                                                 "view-transposed",         "y-not-flipped",
                                                 "fov-degrees-as-radians",  "aspect-inverted"};
    for (int i = 0; i < shots; ++i) {
        const Shot shot = randomShot(random);
        for (std::size_t a = 0; a < common.size(); ++a) {
            for (std::size_t b = a + 1; b < common.size(); ++b) {
                const auto point = printed(shot.scene, shot.click, {{common[a]}, {common[b]}});
                if (!point || !twinsOf(shot, *point, "").empty())
                    continue;
                const auto diagnosis = diagnosed(shot, *point);
                tally.add(common[a] + '+' + common[b], diagnosis ? *diagnosis : doctor::Diagnosis{}, {},
                          described(shot, *point));
            }
        }
    }
}

int rightsMissed(Random &random, int shots)
{
    int missed = 0;
    for (int i = 0; i < shots; ++i) {
        const Shot shot = randomShot(random);
        const auto diagnosis = diagnosed(shot, shot.truth);
        missed += diagnosis && diagnosis->verdict == "right" ? 0 : 1;
    }
    return missed;
}

int garbageExplained(Random &random, int shots)
{
    int explained = 0;
    for (int i = 0; i < shots; ++i) {
        const Shot shot = randomShot(random);
        const auto diagnosis = diagnosed(shot, randomIn(random, 10.0));
        const bool isExplained = diagnosis
                                 && (diagnosis->verdict != "unknown"
                                     || std::any_of(diagnosis->candidates.begin(), diagnosis->candidates.end(),
                                                    [](const doctor::Candidate &c) { return c.explains; }));
        explained += isExplained ? 1 : 0;
    }
    return explained;
}

} // namespace doctor_bar
