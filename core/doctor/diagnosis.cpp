#include "core/doctor/diagnosis.h"

#include "core/doctor/known_points.h"
#include "core/doctor/prepared_point.h"
#include "core/doctor/ranking.h"
#include "core/doctor/solved_mistakes.h"
#include "core/doctor/ties.h"
#include "core/geometry/finite.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

namespace unprojector::doctor {
using namespace geometry;

namespace {

/// The greatest chance of coincidence at which an explanation becomes the verdict. Most wrong
/// points come from one mistake. Two mistakes are rare, and there are thousands of pairs.
constexpr double kChanceOfOne = 0.2;
constexpr double kChanceOfTwo = 0.02;
/// The same for a point of the scene: people click round numbers, which such points are too.
constexpr double kChanceOfKnown = 0.01;

constexpr std::size_t kFewestCandidates = 5;
constexpr std::size_t kMostCandidates = 10;
/// Limits for the next click: the number of hypotheses to distinguish, and of hypotheses tried.
constexpr std::size_t kMostToldApart = 4;
constexpr std::size_t kMostTried = 20;

/// Orders solved values and a pair that both explain the points. Two solved mistakes come first if
/// the pair may well be chance, or if their values are round and less probably so by chance.
void orderSolvedAndPair(std::vector<Hypothesis> &best, const Evidence &evidence)
{
    const auto firstOf = [&](const auto &is) { return std::find_if(best.begin(), best.end(), is); };
    const auto isPair = [](const Hypothesis &each) { return each.count == 2 && each.worst <= kCutOff; };
    const auto isSolved = [](const Hypothesis &each) { return each.isSolved(); };
    if (!isPair(best.front()) && !isSolved(best.front()))
        return;
    const auto pair = firstOf(isPair), solved = firstOf(isSolved);
    if (pair == best.end() || solved == best.end())
        return;
    const double chanceOfPair = chanceOf(evidence, *pair);
    const bool areValuesBetter =
        chanceOfPair > kChanceOfTwo || (solved->isExpected() && chanceOf(evidence, *solved) < chanceOfPair);
    const Hypothesis two = *pair;
    best.erase(pair);
    std::stable_partition(best.begin(), best.end(), isSolved);
    const auto count = std::count_if(best.begin(), best.end(), isSolved);
    const std::ptrdiff_t place = areValuesBetter ? 2 : 0;
    best.insert(best.begin() + std::min<std::ptrdiff_t>(place, count), two);
}

/// False if the unit of a coordinate's last digit exceeds the distance from the eye.
bool countsIn(const Target &target, int axis)
{
    return target.lastDigit[axis] >= target.writtenDigit[axis];
}

Candidate candidateOf(const Hypothesis &hypothesis, const Given &given, std::span<const Prepared> points)
{
    Candidate candidate;
    candidate.id = idOf(hypothesis);
    for (std::size_t i = 0; i < hypothesis.count; ++i) {
        const Variant &part = *hypothesis.parts[i];
        if (!part.name.isEmpty())
            candidate.ways.push_back(part.name);
        candidate.values.insert(candidate.values.end(), part.values.begin(), part.values.end());
    }
    candidate.point = hypothesis.point;
    candidate.distance = hypothesis.distance;
    candidate.explains = hypothesis.worst <= kCutOff;
    candidate.isCutOff = candidate.explains && hypothesis.worst > kRounded;
    for (const Prepared &point : points) {
        const Target &target = hypothesis.count == 0 ? point.right : point.target;
        const auto found = hypothesis.nearest(given, target);
        for (int axis = 0; found && axis < 3; ++axis) {
            if (!countsIn(target, axis))
                continue;
            const int digits =
                digitsExplained(target.got[axis], target.lastDigit[axis], unitsOff(target, axis, found->point));
            candidate.digits += digits;
            if (&point == &points.front())
                candidate.digitsOfFirst[static_cast<std::size_t>(axis)] = digits;
        }
    }
    return candidate;
}

/// True if a hypothesis determines the depth of a point whose depth is unknown.
bool saysDepth(const Hypothesis &hypothesis, const Given &given, const Prepared &point)
{
    const auto a = hypothesis.answerTo(given, point.target.clicks[0]);
    const auto b = hypothesis.answerTo(given, point.target.clicks[1]);
    return a && b && isSameAnswer(*b, *a);
}

/// Puts a mistake that determines the depth first. With rays alone all depth mistakes explain a
/// point on the ray, so one that also fits in depth is the best.
void putDepthFirst(std::vector<Hypothesis> &best, const Given &given, std::span<const Prepared> points)
{
    const bool isByRay = std::all_of(points.begin(), points.end(), [](const Prepared &p) { return p.target.isLine; });
    if (!isByRay || best.front().count != 1)
        return;
    const auto found = std::find_if(best.begin(), best.end(), [&](const Hypothesis &hypothesis) {
        return hypothesis.count == 1 && hypothesis.worst <= kCutOff && saysDepth(hypothesis, given, points.front());
    });
    if (found != best.end())
        std::rotate(best.begin(), found, found + 1);
}

std::string verdictOf(const Hypothesis &best, std::span<const Hypothesis> list, double chance, const Given &given,
                      std::span<const Prepared> points)
{
    if (best.worst > kCutOff)
        return "unknown";
    if (best.count == 0)
        return "right";
    if (chance > (best.count == 1 ? kChanceOfOne : kChanceOfTwo))
        return "unknown";
    // All depth mistakes are alike with rays alone.
    const bool isByRay = std::any_of(points.begin(), points.end(), [](const Prepared &p) { return p.target.isLine; });
    const auto next = std::find_if(list.begin() + 1, list.end(), [&](const Hypothesis &other) {
        const bool isFitted = other.isSolved() && !best.isSolved();
        return !isFitted && (other.worst > kCutOff || !isSameHere(given, best, other));
    });
    if (isByRay && next != list.end() && next->worst <= kCutOff && !saysDepth(best, given, points.front()))
        return "unknown";
    return idOf(best);
}

/// True if no mistake, or a single one, explains the points better than a point of the scene.
bool explainsAsWell(const Hypothesis &best, const Diagnosis &diagnosis)
{
    return diagnosis.verdict == "right"
           || (diagnosis.namesMistake() && best.count == 1 && !best.isSolved() && best.worst <= kRounded);
}

/// Sets the known points, and the verdict if no mistake explains the points as well.
void lookAtKnown(Diagnosis &diagnosis, const Hypothesis &best, const Given &given, const Case &scene)
{
    if (diagnosis.verdict == "right")
        return;
    KnownPoints found = knownPoints(given, scene);
    const bool isSure = found.chance <= kChanceOfKnown;
    if (isSure || diagnosis.verdict == "unknown")
        diagnosis.known = std::move(found.points);
    if ((!isSure && !diagnosis.known.empty()) || explainsAsWell(best, diagnosis))
        return;
    if (diagnosis.known.empty())
        diagnosis.known = knownVertices(given, scene);
    if (!diagnosis.known.empty())
        diagnosis.verdict = "known-point";
}

/// The points that a hypothesis of fixed form leaves unexplained as the only ones.
std::vector<std::size_t> onlyMissed(std::span<const Hypothesis> all)
{
    std::vector<std::size_t> missed;
    for (const Hypothesis &each : all) {
        if (each.missed == 1 && !each.isSolved())
            missed.push_back(each.lastMissed);
    }
    std::sort(missed.begin(), missed.end());
    missed.erase(std::unique(missed.begin(), missed.end()), missed.end());
    return missed;
}

/// @param missed  receives onlyMissed() of the hypotheses
Result<Diagnosis> diagnosed(const Case &scene, std::span<const WrongPoint> wrongPoints, double epsilon,
                            std::vector<std::size_t> &missed)
{
    if (scene.otherSize) {
        if (const Check valid = check(*scene.otherSize); !valid)
            return valid.error();
    }
    Result<Given> input = Given::of(scene.setup, scene.distortion.value_or(cameras::Distortion{}));
    if (!input)
        return input.error();
    Given given = std::move(input).value();
    std::vector<Prepared> points;
    std::vector<ErrorKind> wrongs;
    for (const WrongPoint &point : wrongPoints) {
        if (const Check valid = checkPoint(scene, point); !valid)
            return valid.error();
        points.push_back(prepared(scene, given, point, epsilon));
        given.points.push_back(points.back().target);
        wrongs.push_back(wrongOf(given, points.back()));
    }
    const Hypothesis right = rightHypothesis(given, points);
    const bool isRight = right.worst <= kCutOff;
    const std::vector<Variant> list = variants(given, scene, !isRight);
    std::vector<Hypothesis> all = hypotheses(given, list);
    all.push_back(right);
    missed = onlyMissed(all);
    std::vector<Hypothesis> best = ranked(all);
    Evidence evidence{all, std::min(right.distance, sizeOf(given)), agreeing(points, wrongs)};
    orderSolvedAndPair(best, evidence);
    putDepthFirst(best, given, points);
    std::erase_if(best, [&, first = best.front()](const Hypothesis &other) {
        return other.worst <= kCutOff && isRestated(given, first, other);
    });

    Diagnosis diagnosis;
    if (diagnosis.projected = points.front().projected; diagnosis.projected) {
        const glm::dvec2 inImage = distorted(given, glm::dvec2(*diagnosis.projected));
        diagnosis.projected = glm::dvec3(inImage, diagnosis.projected->z);
    }
    if (const auto unsure = diagnosis.projected ? unsureOf(given, points.front()) : std::nullopt)
        diagnosis.depthUnsure = unsure->z;
    diagnosis.right = rightPoint(scene, wrongPoints.front(), points.front());
    if (diagnosis.right)
        diagnosis.rightLastDigit =
            rightLastDigit(given, points.front(), *diagnosis.right, wrongPoints.front().lastDigit);
    diagnosis.wrong = wrongs.front();
    diagnosis.tried = all.size();
    for (const Prepared &point : points) {
        diagnosis.depthKnown = std::max(diagnosis.depthKnown, point.depthKnown);
        for (int axis = 0; axis < 3; ++axis)
            diagnosis.digitsGiven +=
                countsIn(point.target, axis) ? digitsOf(point.target.got[axis], point.target.lastDigit[axis]) : 0;
    }
    for (const WrongPoint &point : wrongPoints) {
        for (int axis = 0; axis < 3; ++axis)
            diagnosis.digitsWritten += digitsOf(point.got[axis], point.lastDigit[axis]);
    }
    // Compare only with others that determine the depth, if the best hypothesis does. The rest
    // match any point of the ray.
    if (points.front().target.isLine && best.front().count > 0 && saysDepth(best.front(), given, points.front())) {
        std::erase_if(all, [&](const Hypothesis &each) { return !saysDepth(each, given, points.front()); });
        evidence.all = all;
    }
    diagnosis.chance = chanceOf(evidence, best.front());
    diagnosis.verdict = verdictOf(best.front(), best, diagnosis.chance, given, points);
    const bool hasTies = diagnosis.namesMistake();
    lookAtKnown(diagnosis, best.front(), given, scene);
    if (diagnosis.verdict == "unknown")
        diagnosis.lacking = lackOf(given);
    std::vector<Hypothesis> told, others;
    for (const Hypothesis &hypothesis : best) {
        const bool explains = hypothesis.worst <= kCutOff;
        const bool isFirst = diagnosis.candidates.empty();
        Alike alike = Alike::No;
        if (diagnosis.candidates.size() < (explains ? kMostCandidates : kFewestCandidates)) {
            diagnosis.candidates.push_back(candidateOf(hypothesis, given, points));
            Candidate &candidate = diagnosis.candidates.back();
            if (!isFirst && (hasTies ? explains : isSameHere(given, best.front(), hypothesis)))
                candidate.alike = alike = alikeOf(given, best.front(), hypothesis);
            if (alike == Alike::Here || alike == Alike::Always)
                candidate.shared = sharedOf(given, given.points.front().clicks.front(), best.front(), hypothesis);
        }
        // Candidates that another click can distinguish from the first come before ones that are
        // distinct already.
        if (isFirst || alike == Alike::Here || alike == Alike::InDigits)
            told.push_back(hypothesis);
        else if (others.size() < kMostToldApart)
            others.push_back(hypothesis);
    }
    const auto mostTold = [](const Hypothesis &each) { return each.worst <= kCutOff ? kMostToldApart : 2; };
    for (const Hypothesis &each : others) {
        if (told.size() < mostTold(each))
            told.push_back(each);
    }
    told.resize(std::min(told.size(), kMostToldApart));
    const glm::dvec3 &lastDigit = points.front().target.lastDigit;
    const double tellable = greatestOf(lastDigit);
    std::function<std::optional<double>(const DevicePoint &)> depthAt;
    if (scene.pointOnMesh)
        depthAt = [&scene](const DevicePoint &position) { return depthOnMesh(scene, position); };
    auto next = nextClick(given, points.front().click, told, depthAt, tellable);
    // Use the first hypothesis with another answer if theirs are the same everywhere.
    for (std::size_t i = 1; !next && i < std::min(best.size(), kMostTried); ++i) {
        const Hypothesis two[] = {best.front(), best[i]};
        next = nextClick(given, points.front().click, two, depthAt, tellable);
    }
    if (next) {
        diagnosis.next = next->pixel;
        diagnosis.nextApart = next->apart;
    }
    return diagnosis;
}

bool isSameClick(const WrongPoint &a, const WrongPoint &b)
{
    return a.pixel.x == b.pixel.x && a.pixel.y == b.pixel.y && a.depth == b.depth && a.space == b.space
           && a.model == b.model;
}

/// The indices of two answers to one click whose digits differ.
std::optional<std::array<std::size_t, 2>> contradictionOf(const Case &scene, std::span<const WrongPoint> points)
{
    for (std::size_t i = 0; i < points.size(); ++i) {
        for (std::size_t j = i + 1; j < points.size(); ++j) {
            const WrongPoint &a = points[i], &b = points[j];
            const glm::dvec3 off = glm::abs(a.got - b.got) / (a.lastDigit + b.lastDigit);
            if (isSameClick(a, b) && (a.depth || scene.pointOnMesh) && greatestOf(off) > kCutOff)
                return std::array{i, j};
        }
    }
    return std::nullopt;
}

/// The diagnosis with the digits of double precision, or else with those of single precision.
Result<Diagnosis> inEitherPrecision(const Case &scene, std::span<const WrongPoint> points,
                                    std::vector<std::size_t> &missed)
{
    Result<Diagnosis> exact = diagnosed(scene, points, std::numeric_limits<double>::epsilon(), missed);
    if (!exact || exact->verdict != "unknown")
        return exact;
    std::vector<std::size_t> missedInSingle;
    Result<Diagnosis> single = diagnosed(scene, points, double(std::numeric_limits<float>::epsilon()), missedInSingle);
    if (!single || single->digitsGiven == exact->digitsGiven)
        return exact;
    if (missed.empty())
        missed = std::move(missedInSingle);
    if (single->verdict == "unknown")
        return exact;
    Diagnosis found = std::move(single).value();
    found.isSinglePrecision = true;
    return found;
}

/// The verdict on all points but one, where a single one of them can be left out for it.
std::optional<Diagnosis> allButOne(const Case &scene, std::span<const WrongPoint> points,
                                   std::vector<std::size_t> missed)
{
    constexpr std::size_t kFewest = 3, kMostTriedInTurn = 8;
    if (points.size() < kFewest)
        return std::nullopt;
    // Solved values are those of all points, so each point is left out in turn.
    if (missed.empty() && points.size() <= kMostTriedInTurn) {
        missed.resize(points.size());
        std::iota(missed.begin(), missed.end(), std::size_t{0});
    }
    std::optional<Diagnosis> found;
    for (const std::size_t left : missed) {
        std::vector<WrongPoint> others(points.begin(), points.end());
        others.erase(others.begin() + std::ptrdiff_t(left));
        std::vector<std::size_t> ignored;
        Result<Diagnosis> one = inEitherPrecision(scene, others, ignored);
        // Any of the points might have been the one.
        const bool isChance = one && one->namesMistake() && one->chance * double(points.size()) > kChanceOfTwo;
        if (!one || one->verdict == "unknown" || isChance)
            continue;
        if (found)
            return std::nullopt;
        found = std::move(one).value();
        found->except = Except{left, points[left].pixel};
    }
    return found;
}

} // namespace

std::vector<Candidate> Diagnosis::alike() const
{
    return namesMistake() ? asWell() : std::vector<Candidate>();
}

std::vector<Candidate> Diagnosis::asWell() const
{
    constexpr std::size_t kMost = 3;
    std::vector<Candidate> found;
    for (std::size_t i = 1; i < candidates.size() && found.size() < kMost; ++i) {
        if (isAsGood(candidates[i]))
            found.push_back(candidates[i]);
    }
    return found;
}

bool Diagnosis::isAsGood(const Candidate &candidate) const
{
    return namesMistake() ? candidate.alike != Alike::No : verdict == "unknown" && candidate.explains;
}

bool Candidate::hasNumbers() const
{
    return std::any_of(values.begin(), values.end(), [](const SolvedValue &value) { return !value.numbers.empty(); });
}

const Candidate *Diagnosis::runnerUp() const
{
    for (std::size_t i = 1; i < candidates.size(); ++i) {
        if (candidates[i].alike == Alike::No && !isAsGood(candidates[i]))
            return &candidates[i];
    }
    return nullptr;
}

bool Diagnosis::isNextFromRunnerUp() const
{
    const std::vector<Candidate> found = alike();
    return next && !found.empty() && std::all_of(found.begin(), found.end(), [](const Candidate &each) {
               return each.alike == Alike::Always;
           });
}

Result<Diagnosis> diagnose(const Case &scene, std::span<const WrongPoint> given)
{
    // Repetitions are no further evidence.
    std::vector<WrongPoint> points;
    std::vector<std::size_t> places;
    for (std::size_t i = 0; i < given.size(); ++i) {
        if (std::any_of(points.begin(), points.end(),
                        [&](const WrongPoint &p) { return isSameClick(p, given[i]) && p.got == given[i].got; }))
            continue;
        points.push_back(given[i]);
        places.push_back(i);
    }
    std::vector<std::size_t> missed;
    Result<Diagnosis> ofAll = inEitherPrecision(scene, points, missed);
    if (!ofAll || ofAll->verdict != "unknown")
        return ofAll;
    if (std::optional<Diagnosis> found = allButOne(scene, points, missed)) {
        found->except->point = places[found->except->point];
        return std::move(*found);
    }
    Diagnosis unknown = std::move(ofAll).value();
    if (const auto two = contradictionOf(scene, points))
        unknown.contradiction = {places[(*two)[0]], places[(*two)[1]]};
    return unknown;
}

} // namespace unprojector::doctor
