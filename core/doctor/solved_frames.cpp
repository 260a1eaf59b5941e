#include "core/base/number_text.h"
#include "core/base/translation.h"
#include "core/doctor/frame_fit.h"
#include "core/doctor/solved_mistakes.h"
#include "core/geometry/numbers.h"

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

/// Another frame of the program's points: turned, moved, scaled, or with other axes.
namespace unprojector::doctor {
using base::marked;
namespace {

/// The right points and the program's.
struct Points {
    std::vector<glm::dvec3> right, got;
    glm::dvec3 lastDigit{0.0}; ///< the greatest of all points
};

std::optional<Points> pointsOf(const Given &given)
{
    Points points;
    for (const Target &target : given.points) {
        const auto right = answer(given, middleOf(given, target), {});
        if (!right)
            return std::nullopt;
        points.right.push_back(*right);
        points.got.push_back(target.got);
        points.lastDigit = glm::max(points.lastDigit, target.lastDigit);
    }
    return points;
}

/// A frame, and the number of its values that were solved for.
struct Solved {
    FrameFit frame;
    int unknowns = 0;
};

bool explains(const FrameFit &frame, const Points &points, double most)
{
    for (std::size_t i = 0; i < points.right.size(); ++i) {
        const glm::dvec3 off = glm::abs(frame.mapped(points.right[i]) - points.got[i]) / points.lastDigit;
        if (!(greatestOf(off) <= most))
            return false;
    }
    return true;
}

/// The roundest number that leaves the points explained as well.
void roundOff(double &value, const FrameFit &frame, const Points &points)
{
    const double exact = value;
    value = 0.0;
    if (exact == 0.0 || explains(frame, points, kRounded))
        return;
    const int first = int(std::floor(std::log10(std::abs(exact)))) + 1;
    for (int exponent = first; exponent > first - 12; --exponent) {
        const double scale = std::pow(10.0, -exponent);
        value = std::round(exact * scale) / scale;
        if (explains(frame, points, kRounded))
            return;
    }
    value = exact;
}

/// The frames whose axes are the right ones in another order, or reversed.
void addPermutations(std::vector<Solved> &all, const Points &points)
{
    const double count = double(points.right.size());
    glm::dvec3 from(0.0), to(0.0);
    for (std::size_t i = 0; i < points.right.size(); ++i) {
        from += points.right[i] / count;
        to += points.got[i] / count;
    }
    for (const AxisPermutation &permutation : axisPermutations()) {
        const auto scaleAbout = [&](const glm::dvec3 &a, const glm::dvec3 &b) {
            double squares = 0.0, products = 0.0;
            for (std::size_t i = 0; i < points.right.size(); ++i) {
                squares += glm::dot(points.right[i] - a, points.right[i] - a);
                products += glm::dot(permutation.matrix * (points.right[i] - a), points.got[i] - b);
            }
            return products / squares;
        };
        const auto offer = [&](double scale, bool isMoved, int unknowns) {
            FrameFit frame{permutation.matrix};
            frame.scale = scale;
            if (isMoved)
                frame.translation = to - scale * (permutation.matrix * from);
            frame.isHandednessKnown = true;
            if (scale > 0.0 && explains(frame, points, kCutOff))
                all.push_back({frame, unknowns});
        };
        const bool isIdentity = &permutation == &axisPermutations().front();
        if (!isIdentity) // a factor alone is "scaled"
            offer(scaleAbout(glm::dvec3(0.0), glm::dvec3(0.0)), false, 1);
        offer(1.0, true, 3);
        offer(scaleAbout(from, to), true, 4);
    }
}

std::string textOf(const glm::dvec3 &v)
{
    return valueText(v.x) + ", " + valueText(v.y) + ", " + valueText(v.z);
}

/// The rotation, or the one that follows a reflection through the origin, by 180 degrees at most.
glm::dquat turnOf(const FrameFit &frame)
{
    const glm::dquat turn = glm::quat_cast(frame.isMirrored() ? -frame.rotation : frame.rotation);
    return turn.w < 0.0 ? -turn : turn;
}

/// A rotation's axis in four digits.
std::string axisText(const glm::dquat &turn)
{
    constexpr double kUnits = 1e4;
    return textOf(glm::round(glm::axis(turn) * kUnits) / kUnits + 0.0); // no -0
}

VariantName nameOf(const FrameFit &frame, const AxisPermutation *otherAxes, bool isTurned)
{
    const std::string scale = valueText(frame.scale), moved = textOf(frame.translation);
    if (otherAxes) {
        const std::string &axes = otherAxes->axes;
        if (frame.translation == glm::dvec3(0.0))
            return {marked("%1, scaled by %2"), {axes, scale}, marked("Your program's axes are %1, scaled by %2.")};
        if (frame.scale == 1.0)
            return {marked("%1, then moved by %2"),
                    {axes, moved},
                    marked("Your program's axes are %1; then it moves its points by %2.")};
        return {marked("%1, then scaled and moved: %2"),
                {axes, scale + "; " + moved},
                marked("Your program's axes are %1; then it scales and moves its points: %2.")};
    }
    if (!isTurned && frame.scale == 1.0)
        return {marked("moved by %1"), {moved}, marked("Your program moves its points by %1.")};
    if (!isTurned)
        return {marked("scaled by %1, then moved by %2"),
                {scale, moved},
                marked("Your program scales its points by %1, then moves them by %2.")};
    const glm::dquat turn = turnOf(frame);
    const std::string angle = base::significantText(geometry::degreesFromRadians(glm::angle(turn)), 4);
    const std::vector<std::string> values{angle, scale, axisText(turn), moved};
    if (!frame.isHandednessKnown)
        return {marked("turned by %1 degrees about %3, scaled by %2, moved by %4; the points lie in a plane, "
                       "so that a mirror image fits too"),
                values,
                marked("Your program turns its points by %1 degrees about %3, scales them by %2 and moves them "
                       "by %4. The points lie in a plane, so that a mirror image fits too.")};
    if (frame.isMirrored())
        return {marked("mirrored, turned by %1 degrees about %3, scaled by %2, moved by %4"), values,
                marked("Your program mirrors its points, turns them by %1 degrees about %3, scales them by %2 "
                       "and moves them by %4.")};
    return {marked("turned by %1 degrees about %3, scaled by %2, moved by %4"), values,
            marked("Your program turns its points by %1 degrees about %3, scales them by %2 and moves them "
                   "by %4.")};
}

/// The units in 1 of a rotation's last digit that the points determine: a power of ten.
double rotationUnits(const FrameFit &frame, const Points &points)
{
    constexpr double kShare = 0.1;
    double size = 0.0;
    for (const glm::dvec3 &right : points.right)
        size = std::max(size, frame.scale * glm::distance(right, points.right.front()));
    const double digit = greatestOf(points.lastDigit);
    return std::pow(10.0, std::ceil(-std::log10(kShare * digit / size)));
}

void add(VariantList &list, const Solved &solved, const Points &points)
{
    FrameFit frame = solved.frame;
    roundOff(frame.scale, frame, points);
    for (int axis = 0; axis < 3; ++axis)
        roundOff(frame.translation[axis], frame, points);
    const auto all = axisPermutations();
    const auto found =
        std::find_if(all.begin(), all.end(), [&](const AxisPermutation &p) { return p.matrix == frame.rotation; });
    const bool isTurned = found == all.end();
    const AxisPermutation *permutation = isTurned || found == all.begin() ? nullptr : &*found;
    const SolvedValue moved{"translation", {frame.translation.x, frame.translation.y, frame.translation.z}};
    const SolvedValue scaled{"scale", {frame.scale}};
    Variant variant{.stage = Stage::Point,
                    .apply = [](Run &run) { run.point = glm::dvec3(*run.matrix * glm::dvec4(run.point, 1.0)); },
                    .matrix = glm::dmat4(frame.scale * frame.rotation),
                    .name = nameOf(frame, permutation, isTurned),
                    .unknowns = solved.unknowns};
    variant.matrix[3] = glm::dvec4(frame.translation, 1.0);
    if (permutation) {
        variant.values = {{"axes", {}, permutation->axes}};
        if (solved.unknowns != 3)
            variant.values.push_back(scaled);
        if (solved.unknowns > 1)
            variant.values.push_back(moved);
    } else {
        SolvedValue rotation{"rotation"};
        const double units = rotationUnits(frame, points);
        for (int i = 0; i < 9; ++i)
            rotation.numbers.push_back(std::round(frame.rotation[i % 3][i / 3] * units) / units + 0.0); // no -0
        variant.values = {rotation, moved, scaled};
    }
    list.add(permutation ? "axes-differ" : "frame-differs", std::move(variant));
}

} // namespace

void addSolvedFrames(VariantList &list, const Given &given)
{
    const std::optional<Points> points = pointsOf(given);
    if (!points || extentOf(points->right) == Extent::Point)
        return;
    std::vector<Solved> all;
    addPermutations(all, *points);
    if (all.empty()) {
        for (const bool hasScale : {false, true}) {
            if (const auto frame = fittedFrame(points->right, points->got, hasScale))
                all.push_back({*frame, hasScale ? 7 : 6});
        }
    }
    for (const Solved &solved : all)
        add(list, solved, *points);
}

} // namespace unprojector::doctor
