#include "core/base/number_text.h"
#include "core/base/source_text.h"
#include "core/base/text_scanner.h"
#include "core/base/translation.h"
#include "core/cameras/camera_reader.h"
#include "core/cameras/outline.h"
#include "core/geometry/numbers.h"

#include <glm/vec3.hpp>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

// Cameras of any program that has an eye, a target or direction, an up and a field of view, under the names that
// ray tracers and viewers give them.

namespace unprojector::cameras {
using namespace geometry;
using base::tr;

namespace {

constexpr std::string_view kEyes = "eye eyepos eyeposition position pos camerapos cameraposition location loc origin "
                                   "lookfrom from viewpoint",
                           kTargets = "target lookat lookingat viewtarget focalpoint focuspoint pointofinterest "
                                      "lookatpoint cameratarget",
                           kCentres = "center centre at to", ///< a target beside an eye
    kDirections = "direction dir forward front lookdir viewdir viewdirection lookdirection gaze heading",
                           kUps = "up upvector upvec viewup vup worldup cameraup updirection updir",
                           kAngles = "fov fovy fovx fieldofview viewangle angleofview fovdeg fovdegrees",
                           kOthers = "k fx focal focallength quaternion rotation matrix rvec intrinsics projection";

/// The values around an eye.
struct Look {
    const NamedValue *eye = nullptr, *target = nullptr, *direction = nullptr, *up = nullptr, *angle = nullptr,
                     *aspect = nullptr;
    std::string name{};
};

class LookReader {
public:
    explicit LookReader(Reading &reading) : m_values(reading.values()), m_outline(reading.text.text) {}

    std::vector<Look> looks() const
    {
        std::vector<Look> found;
        const std::vector<NamedValue> &all = m_values->all();
        for (const NamedValue &value : all) {
            const bool isTarget = isVector(value, kTargets), isDirection = isVector(value, kDirections);
            const bool isCentre = isVector(value, kCentres);
            if (!isTarget && !isDirection && !isCentre)
                continue;
            const auto nearest = [&](std::string_view names, std::size_t count) { return around(value, names, count); };
            Look look{
                nearest(kEyes, 3),   isDirection ? nullptr : &value,  isDirection ? &value : nullptr, nearest(kUps, 3),
                nearest(kAngles, 1), nearest("aspect aspectratio", 1)};
            if (!look.eye && isTarget) // "center" is the eye's where a target stands beside it
                look.eye = nearest("center centre", 3);
            if (!look.eye || !look.angle || nearest(kOthers, 1))
                continue;
            look.name = m_outline.nameOf(m_outline.nodeAt(value.at));
            // A direction beside a target is another one's.
            const bool isTwice =
                !found.empty() && m_outline.nodeAt(found.back().eye->at) == m_outline.nodeAt(look.eye->at);
            if (isTwice && !isDirection && found.back().direction)
                found.back() = look;
            else if (!isTwice || (!isDirection && !isCentre))
                found.push_back(look);
        }
        return found;
    }

private:
    static bool isVector(const NamedValue &value, std::string_view names)
    {
        return value.numbers.size() == 3 && isNamed(value, names);
    }

    static bool isNamed(const NamedValue &value, std::string_view names)
    {
        const auto all = split(names, ' ');
        return std::ranges::any_of(all, [&](std::string_view name) { return value.isNamed(name); });
    }

    /// The first value with one of the names in the part of the text that has another value, or in one around it.
    const NamedValue *around(const NamedValue &value, std::string_view names, std::size_t count) const
    {
        const std::vector<std::size_t> path = m_outline.pathTo(m_outline.nodeAt(value.at));
        for (auto node = path.rbegin(); node != path.rend(); ++node) {
            const auto found = std::ranges::find_if(m_values->all(), [&](const NamedValue &one) {
                return one.numbers.size() >= count && (count != 3 || one.numbers.size() == 3) && isNamed(one, names)
                       && m_outline.nodeAt(one.at) == *node;
            });
            if (found != m_values->all().end())
                return &*found;
        }
        return nullptr;
    }

    std::shared_ptr<const NamedValues> m_values;
    Outline m_outline;
};

Cameras lookingCameras(Reading &reading, const Node &text)
{
    constexpr std::size_t kLongest = std::size_t{1} << 20;
    if (reading.text.text.size() > kLongest)
        return {};
    const std::vector<Look> looks = LookReader(reading).looks();
    Cameras cameras;
    for (const Look &look : looks)
        cameras.push_back({looks.size() == 1   ? std::string()
                           : look.name.empty() ? std::to_string(cameras.size())
                                               : look.name,
                           {},
                           text,
                           text});
    return cameras;
}

glm::dvec3 vectorOf(Reading &reading, const NamedValue &value)
{
    if (!value.arithmetic.empty() || !value.unit.empty())
        reading.fail(tr("%1 has more than numbers; write its x, y and z", base::quoted(value.written)), value.line);
    return cameras::vectorOf(value.numbers);
}

void readLook(Reading &reading)
{
    const Look look = LookReader(reading).looks()[reading.camera.image];
    if (reading.text.text.find("rthographic\": true") != std::string::npos)
        reading.fail(tr("an orthographic camera of %1 is not read; give its matrices", reading.camera.program));
    for (const NamedValue *one : {look.eye, look.target, look.direction, look.up, look.angle, look.aspect}) {
        if (one)
            reading.used.insert(plain(one->written));
    }
    if (!look.up)
        reading.fail(tr("the up direction is missing; give up = 0 1 0, or up = 0 0 1"), look.eye->line);
    const glm::dvec3 eye = vectorOf(reading, *look.eye), ahead = look.direction ? vectorOf(reading, *look.direction)
                                                                                : vectorOf(reading, *look.target) - eye;
    reading.setLooking(eye, -ahead, vectorOf(reading, *look.up));
    const NamedValue &angle = *look.angle;
    const double value = angle.number();
    const auto hasWord = [&](std::string_view words) {
        return std::ranges::any_of(angle.words, [&](const std::string &one) { return base::isListed(words, one); });
    };
    const bool isAcross = hasWord("x h horizontal hor fovx");
    const bool areRadians =
        angle.unit.starts_with("rad") || hasWord("rad radians") || (angle.unit.empty() && value <= kPi);
    if (!isAcross && !hasWord("y v vertical vert fovy"))
        reading.say(tr("%1 is read as the vertical field of view; a horizontal one has the name fov_x.",
                       base::quoted(angle.written)));
    if (areRadians && angle.unit.empty() && !hasWord("rad radians"))
        reading.say(tr("%1 is read in radians, because it is at most pi.", base::quoted(angle.written)));
    const double radians = areRadians ? value : base::radiansFromDegrees(value);
    const std::optional<double> aspect = look.aspect ? std::optional(look.aspect->number()) : std::nullopt;
    if (isAcross)
        reading.setHorizontalAngle(radians);
    else
        reading.setVerticalAngle(radians, aspect);
    const ImageSize size = reading.neededSize();
    constexpr double kVisible = 0.01;
    if (aspect && !isAcross && std::abs(*aspect * size.height / size.width - 1.0) > kVisible)
        reading.say(
            tr("The aspect %1 is not that of the size: the picture is stretched.", base::shortestText(*aspect)));
    reading.say(tr("The world is read as right-handed."));
}

constexpr Form kForms[]{{"look-at", "", kOpenGl, lookingCameras, readLook, {.planes = "near far"}}};

} // namespace

std::span<const Form> lookAtForms()
{
    return kForms;
}

} // namespace unprojector::cameras
