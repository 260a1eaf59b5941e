#include "tests/support/value_bar.h"

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <span>

namespace value_bar {
using namespace unprojector;
using namespace unprojector::geometry;
using oracle::Random;
using wrong_programs::Click;
using wrong_programs::printed;
using wrong_programs::WrongValue;

namespace {

constexpr double kStep = 1e-4;

glm::dvec3 inFourDecimals(const glm::dvec3 &p)
{
    return glm::dvec3(std::round(p.x / kStep), std::round(p.y / kStep), std::round(p.z / kStep)) * kStep;
}

double largest(const glm::dvec3 &p)
{
    return std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)});
}

/// One program's clicks.
struct Shots {
    doctor_bar::Shot first;
    std::vector<Click> clicks;
};

Shots randomShots(Random &random, int count)
{
    Shots shots{doctor_bar::randomShot(random), {}};
    const wrong_programs::Scene &scene = shots.first.scene;
    shots.clicks.push_back(shots.first.click);
    const glm::dvec3 forward = glm::normalize(scene.target - scene.eye);
    while (int(shots.clicks.size()) < count) {
        const glm::dvec4 &v = scene.viewport;
        const double left = v.x + random.integer(0, int(v.z) - 1);
        const double top = scene.framebufferHeight - (v.y + random.integer(1, int(v.w)));
        const double z = glm::length(scene.eye - scene.target) * random.uniform(0.5, 1.5);
        const double depth = clickOn(scene, scene.eye + z * forward).depth;
        shots.clicks.push_back({left + 0.5, top + 0.5, depth});
    }
    return shots;
}

double oneOf(Random &random, std::span<const double> choices)
{
    return choices[std::size_t(random.integer(0, int(choices.size()) - 1))];
}

/// A round number, or any.
double numberNear(Random &random, std::span<const double> round, double low, double high)
{
    return random.chance(0.5) ? oneOf(random, round) : random.logUniform(low, high);
}

constexpr double kFars[] = {10, 20, 50, 100, 200, 500, 1000, 2000, 5000};
constexpr double kNears[] = {0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1.0, 2.0};
constexpr double kAngles[] = {20, 30, 35, 40, 45, 50, 60, 70, 75, 80, 90, 100};
constexpr double kFactors[] = {1000, 0.001, 25.4, 1.0 / 25.4, 0.3048, 1.0 / 0.3048, 100, 0.01, 10, 0.1, 2, 0.5};
constexpr double kRatios[] = {1.1, 1.2, 2.25, 2.5, 3.5, 4.0};
constexpr double kWidths[] = {640, 800, 1024, 1280, 1366, 1600, 1920};
constexpr double kHeights[] = {480, 600, 720, 768, 900, 1080, 1200};

std::string randomAxes(Random &random)
{
    std::string letters = "xyz", axes;
    do {
        std::swap(letters[0], letters[std::size_t(random.integer(0, 2))]);
        std::swap(letters[1], letters[std::size_t(random.integer(1, 2))]);
        axes.clear();
        for (const char letter : letters) {
            axes += axes.empty() ? "" : ",";
            axes += random.chance(0.5) ? "-" : "";
            axes += letter;
        }
    } while (axes == "x,y,z");
    return axes;
}

/// Three points fit a frame and its mirror image equally well, so a mirrored one needs four.
void setFrame(Random &random, int points, WrongValue &wrong)
{
    const glm::dvec3 axis =
        glm::normalize(glm::dvec3(random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0), random.uniform(0.1, 1.0)));
    const glm::dmat4 turn = glm::rotate(glm::dmat4(1.0), random.uniform(0.3, 3.0), axis);
    const double mirror = points > 3 && random.chance(0.5) ? -1.0 : 1.0;
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 3; ++column)
            wrong.values["rotation"].push_back(mirror * turn[column][row]);
        wrong.values["translation"].push_back(random.uniform(-5.0, 5.0));
    }
    wrong.values["scale"] = {random.chance(0.5) ? 1.0 : random.logUniform(0.2, 5.0)};
}

/// The pixels of a window with bars at two sides: a usual one, or one of any size.
void setLetterbox(Random &random, const wrong_programs::Scene &scene, WrongValue &wrong)
{
    for (;;) {
        const bool isUsual = random.chance(0.5);
        const double width = isUsual ? oneOf(random, kWidths) : random.integer(400, 2600);
        const double height = isUsual ? oneOf(random, kHeights) : random.integer(300, 1600);
        const double scale = std::min(width / scene.framebufferWidth, height / scene.framebufferHeight);
        const double dx = (width - scale * scene.framebufferWidth) / 2.0;
        const double dy = (height - scale * scene.framebufferHeight) / 2.0;
        wrong.values = {{"scale", {scale}}, {"dx", {dx}}, {"dy", {dy}}};
        wrong.variant = random.integer(0, 1);
        if (std::max(dx, dy) > 2.0 && std::abs(scale - 1.0) > 0.01)
            return;
    }
}

WrongValue randomValue(Random &random, const wrong_programs::Scene &scene, const std::string &id, int points)
{
    WrongValue wrong{id, {}, {}, 0};
    if (id == "pixel-scaled-and-moved")
        setLetterbox(random, scene, wrong);
    if (id == "far-differs" || id == "near-far-differ")
        wrong.values["far"] = {numberNear(random, kFars, 10.0, 5000.0)};
    if (id == "near-differs" || id == "near-far-differ")
        wrong.values["near"] = {numberNear(random, kNears, 0.01, 2.0)};
    if (id == "fovy-differs")
        wrong.values["fovy"] = {numberNear(random, kAngles, 20.0, 100.0)};
    if (id == "pixel-shifted")
        wrong.values = {{"dx", {double(random.integer(-60, 60))}}, {"dy", {double(random.integer(-60, 60))}}};
    if (id == "viewport-size-differs")
        wrong.values = {{"width", {numberNear(random, kWidths, 400.0, 2000.0)}},
                        {"height", {numberNear(random, kHeights, 300.0, 1200.0)}}};
    if (id == "ratio-differs") {
        wrong.values["ratio"] = {numberNear(random, kRatios, 1.05, 4.0)};
        wrong.variant = random.integer(0, 1);
    }
    if (id == "scaled") {
        wrong.values["factor"] = {numberNear(random, kFactors, 0.2, 5.0)};
        wrong.word = random.chance(0.5) ? "origin" : "eye";
    }
    if (id == "axes-differ")
        wrong.word = randomAxes(random);
    if (id == "frame-differs")
        setFrame(random, points, wrong);
    return wrong;
}

/// The points of a program; nothing if it has none for one of the clicks.
std::optional<std::vector<glm::dvec3>> pointsOf(const Shots &shots, const WrongValue &wrong)
{
    std::vector<glm::dvec3> points;
    for (const Click &click : shots.clicks) {
        const auto point = printed(shots.first.scene, click, wrong);
        if (!point || !(largest(*point) < 1e6))
            return std::nullopt;
        points.push_back(inFourDecimals(*point));
    }
    return points;
}

bool isNearly(const std::vector<glm::dvec3> &a, const std::vector<glm::dvec3> &b, double least)
{
    double most = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i)
        most = std::max(most, largest(a[i] - b[i]));
    return most < least;
}

/// True if the points determine each number of the value to 1 %: a value 1 % off prints points at
/// least this many last digits away.
bool isDetermined(const Shots &shots, const WrongValue &wrong, const std::vector<glm::dvec3> &points)
{
    constexpr double kApart = 4.0 * kStep;
    for (const auto &[name, numbers] : wrong.values) {
        if (wrong.id == "frame-differs")
            continue;
        WrongValue other = wrong;
        for (double &number : other.values[name])
            number *= 1.01;
        const auto there = pointsOf(shots, other);
        if (numbers.front() != 0.0 && (!there || isNearly(points, *there, kApart)))
            return false;
    }
    return true;
}

/// True if a candidate names the value, each number within 1 %, or half a pixel of a shift.
bool isFound(const doctor::Candidate &candidate, const WrongValue &wrong)
{
    if (candidate.id != wrong.id)
        return false;
    bool hasWord = wrong.word.empty();
    std::size_t found = 0;
    for (const doctor::SolvedValue &value : candidate.values) {
        hasWord = hasWord || value.word == wrong.word;
        const auto expected = wrong.values.find(value.name);
        if (expected == wrong.values.end() || expected->second.size() != value.numbers.size())
            continue;
        bool isClose = true;
        for (std::size_t i = 0; i < value.numbers.size(); ++i) {
            const double right = expected->second[i];
            const bool isPixel = expected->first.size() == 2; // dx and dy
            const double least = isPixel ? 0.5 : wrong.id == "frame-differs" ? 0.01 : 0.0;
            isClose = isClose && std::abs(value.numbers[i] - right) <= std::max(0.01 * std::abs(right), least);
        }
        found += isClose ? 1 : 0;
    }
    return hasWord && found == wrong.values.size();
}

doctor::Diagnosis diagnosed(const Shots &shots, const std::vector<glm::dvec3> &points)
{
    std::vector<doctor::WrongPoint> given;
    for (std::size_t i = 0; i < points.size(); ++i) {
        doctor::WrongPoint point;
        point.pixel = DevicePoint(shots.clicks[i].px, shots.clicks[i].py);
        point.depth = shots.clicks[i].depth;
        point.got = points[i];
        point.lastDigit = glm::dvec3(kStep);
        given.push_back(point);
    }
    auto diagnosis = doctor::diagnose(doctor_bar::caseOf(shots.first), given);
    return diagnosis ? std::move(diagnosis).value() : doctor::Diagnosis{};
}

std::string described(const WrongValue &wrong, const Shots &shots, const std::vector<glm::dvec3> &points,
                      const doctor::Diagnosis &diagnosis)
{
    std::string text = wrong.id + ' ' + wrong.word;
    for (const auto &[name, numbers] : wrong.values)
        text += ' ' + name + ' ' + std::to_string(numbers.front());
    text += ": verdict " + diagnosis.verdict + ';';
    for (std::size_t i = 0; i < std::min<std::size_t>(4, diagnosis.candidates.size()); ++i) {
        const doctor::Candidate &candidate = diagnosis.candidates[i];
        text += ' ' + candidate.id + (candidate.explains ? " explains" : " off " + std::to_string(candidate.distance));
        for (const doctor::SolvedValue &value : candidate.values)
            text += ' ' + value.name + ' ' + value.word
                    + (value.numbers.empty() ? "" : std::to_string(value.numbers.front()));
        text += ';';
    }
    const wrong_programs::Lens &lens = shots.first.scene.lens;
    text += lens.isPerspective ? " perspective" : " box";
    text += " near " + std::to_string(lens.nearDistance) + " far " + std::to_string(lens.farDistance) + " got";
    for (const glm::dvec3 &p : points)
        text += ' ' + std::to_string(p.x) + ' ' + std::to_string(p.y) + ' ' + std::to_string(p.z);
    return text;
}

} // namespace

Tally tested(Random &random, int shots, int points)
{
    Tally tally;
    for (int i = 0; i < shots; ++i) {
        for (const std::string &id : wrong_programs::wrongValueIds()) {
            const Shots shot = randomShots(random, points);
            const WrongValue wrong = randomValue(random, shot.first.scene, id, points);
            const auto printedPoints = pointsOf(shot, wrong);
            const auto right = pointsOf(shot, WrongValue{});
            if (!printedPoints || !right || isNearly(*printedPoints, *right, 4.0 * kStep))
                continue;
            Count &count = tally.ofId[id];
            if (!isDetermined(shot, wrong, *printedPoints)) {
                ++count.undetermined;
                continue;
            }
            const doctor::Diagnosis diagnosis = diagnosed(shot, *printedPoints);
            ++count.asked;
            const auto &all = diagnosis.candidates;
            const auto end = all.begin() + std::ptrdiff_t(std::min<std::size_t>(3, all.size()));
            const bool isInThree =
                std::any_of(all.begin(), end, [&](const doctor::Candidate &c) { return isFound(c, wrong); });
            const bool isVerdict = !all.empty() && diagnosis.verdict == id && isFound(all.front(), wrong);
            count.firstThree += isInThree ? 1 : 0;
            count.verdicts += isVerdict ? 1 : 0;
            if (points == 1 ? !isInThree : !isVerdict)
                tally.missed.push_back(described(wrong, shot, *printedPoints, diagnosis));
        }
    }
    return tally;
}

Count roundPlanesFromTwo(Random &random, int shots)
{
    Count count;
    for (int i = 0; i < shots; ++i) {
        const Shots shot = randomShots(random, 2);
        const WrongValue wrong{
            "near-far-differ", {{"near", {oneOf(random, kNears)}}, {"far", {oneOf(random, kFars)}}}, {}, 0};
        const auto points = pointsOf(shot, wrong);
        const auto right = pointsOf(shot, WrongValue{});
        if (!points || !right || isNearly(*points, *right, 4.0 * kStep))
            continue;
        if (!isDetermined(shot, wrong, *points)) {
            ++count.undetermined;
            continue;
        }
        ++count.asked;
        const doctor::Diagnosis diagnosis = diagnosed(shot, *points);
        count.verdicts += diagnosis.verdict == wrong.id && isFound(diagnosis.candidates.front(), wrong) ? 1 : 0;
    }
    return count;
}

int garbageExplained(Random &random, int shots)
{
    int explained = 0;
    for (int i = 0; i < shots; ++i) {
        const Shots shot = randomShots(random, 3);
        std::vector<glm::dvec3> points;
        for (int n = 0; n < 3; ++n) {
            const double x = random.uniform(-10.0, 10.0), y = random.uniform(-10.0, 10.0);
            points.push_back(inFourDecimals({x, y, random.uniform(-10.0, 10.0)}));
        }
        const doctor::Diagnosis diagnosis = diagnosed(shot, points);
        explained += diagnosis.verdict != "unknown" ? 1 : 0;
    }
    return explained;
}

} // namespace value_bar
