#include "tests/support/wrong_values.h"

#include <glm/geometric.hpp>

#include <cmath>
#include <numbers>
#include <sstream>

namespace wrong_programs {
namespace {

using glm::dvec3;

double numberOf(const WrongValue &wrong, const char *name)
{
    return wrong.values.at(name).front();
}

dvec3 signedPermutation(const dvec3 &p, const std::string &axes)
{
    std::istringstream words(axes);
    dvec3 result(0.0);
    std::string word;
    for (int axis = 0; std::getline(words, word, ','); ++axis)
        result[axis] = (word.front() == '-' ? -1.0 : 1.0) * p[word.back() - 'x'];
    return result;
}

/// The changes to the program's answer.
dvec3 changed(const Scene &scene, const dvec3 &p, const WrongValue &wrong)
{
    if (wrong.id == "scaled") {
        const dvec3 about = wrong.word == "eye" ? scene.eye : dvec3(0.0);
        return about + numberOf(wrong, "factor") * (p - about);
    }
    if (wrong.id == "frame-differs") {
        const std::vector<double> &r = wrong.values.at("rotation"), &t = wrong.values.at("translation");
        const double s = numberOf(wrong, "scale");
        return {s * (r[0] * p.x + r[1] * p.y + r[2] * p.z) + t[0], s * (r[3] * p.x + r[4] * p.y + r[5] * p.z) + t[1],
                s * (r[6] * p.x + r[7] * p.y + r[8] * p.z) + t[2]};
    }
    return wrong.id == "axes-differ" ? signedPermutation(p, wrong.word) : p;
}

} // namespace

const std::vector<std::string> &wrongValueIds()
{
    static const std::vector<std::string> ids{
        "far-differs",   "near-differs",          "near-far-differ",       "fovy-differs",
        "pixel-shifted", "viewport-size-differs", "ratio-differs",         "scaled",
        "frame-differs", "axes-differ",           "pixel-scaled-and-moved"};
    return ids;
}

std::optional<dvec3> printed(const Scene &scene, const Click &click, const WrongValue &wrong)
{
    Scene own = scene;
    Click at = click;
    const std::string &id = wrong.id;
    if (id == "far-differs" || id == "near-far-differ")
        own.lens.farDistance = numberOf(wrong, "far");
    if (id == "near-differs" || id == "near-far-differ")
        own.lens.nearDistance = numberOf(wrong, "near");
    if (id == "fovy-differs") {
        if (!own.lens.isPerspective)
            return std::nullopt;
        own.lens.fovyRadians = numberOf(wrong, "fovy") * std::numbers::pi / 180.0;
    }
    if (id == "pixel-shifted") {
        at.px += numberOf(wrong, "dx");
        at.py += numberOf(wrong, "dy");
    }
    if (id == "pixel-scaled-and-moved") {
        const double scale = numberOf(wrong, "scale"), dy = numberOf(wrong, "dy");
        at.px = scale * at.px + numberOf(wrong, "dx");
        at.py = scale * at.py + dy;
        if (wrong.variant == 1)
            own.framebufferHeight = scale * own.framebufferHeight + 2.0 * dy;
    }
    if (id == "viewport-size-differs") {
        own.viewport.z = numberOf(wrong, "width");
        own.viewport.w = numberOf(wrong, "height");
    }
    if (id == "ratio-differs") {
        const double ratio = numberOf(wrong, "ratio");
        at.px /= ratio;
        at.py /= ratio;
        if (wrong.variant == 1)
            own.framebufferHeight /= ratio;
    }
    if (!(own.lens.nearDistance < own.lens.farDistance))
        return std::nullopt;
    const std::optional<dvec3> point = printed(own, at, std::vector<Made>());
    return point ? std::optional(changed(scene, *point, wrong)) : std::nullopt;
}

} // namespace wrong_programs
