#include "core/base/number_text.h"
#include "core/base/source_text.h"
#include "core/base/text_scanner.h"
#include "core/base/translation.h"
#include "core/cameras/camera_reader.h"
#include "core/cameras/outline.h"
#include "core/cameras/scan.h"
#include "core/geometry/numbers.h"

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
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
                     *aspect = nullptr, *twice = nullptr;
    std::string name{};
};

/// Names of things that are no cameras.
constexpr std::string_view kThings = "light lamp sun mesh object actor model primitive sphere box spot";
/// Names of values that turn or change the picture.
constexpr std::string_view kChanges = "zoom roll shift shiftx shifty lensshift ortho orthographic handedness "
                                      "coordinatesystem parent fovaxis fovmode fovunit units sensorfit projectiontype";

/// The names before a value's own: "camera" of "camera.position".
std::string_view ownerOf(const NamedValue &value)
{
    return base::namesBefore(value.written);
}

bool isAmong(const NamedValue &value, std::string_view names)
{
    const auto all = split(names, ' ');
    return std::ranges::any_of(all, [&](std::string_view name) { return value.isNamed(name); });
}

bool isThing(std::string_view name)
{
    const std::string lower = base::lowerCase(name);
    return std::ranges::any_of(split(kThings, ' '), [&](auto thing) { return lower.find(thing) != lower.npos; });
}

class LookReader {
public:
    explicit LookReader(Reading &reading) : m_values(reading.values()), m_outline(reading.text.text)
    {
        for (const NamedValue &value : m_values->all()) {
            if (!value.written.empty())
                m_parts[m_outline.nodeAt(value.at)].push_back(&value);
        }
    }

    std::vector<Look> looks()
    {
        std::vector<Look> found;
        for (const NamedValue &value : m_values->all()) {
            const bool isTarget = isVector(value, kTargets), isDirection = isVector(value, kDirections),
                       isCentre = isVector(value, kCentres);
            if (!isTarget && !isDirection && !isCentre)
                continue;
            m_path = m_outline.pathTo(m_outline.nodeAt(value.at));
            m_owner = ownerOf(value);
            m_twice = nullptr;
            Look look{nearest(kEyes, 3)};
            if (!look.eye && isTarget) // "center" is the eye's where a target stands beside it
                look.eye = nearest("center centre", 3);
            look.target = isTarget ? nearest(kTargets, 3) : isCentre ? &value : nearest(kTargets, 3);
            if (!look.target && isDirection)
                look.target = nearest(kCentres, 3);
            look.direction = nearest(kDirections, 3);
            look.up = nearest(kUps, 3);
            look.angle = nearest(kAngles, 1);
            look.aspect = nearest("aspect aspectratio", 1);
            look.twice = m_twice;
            look.name = m_owner.empty() ? m_outline.nameOf(m_path.back()) : std::string(m_owner);
            const bool isCounted = std::ranges::any_of(found, [&](const Look &one) { return one.eye == look.eye; });
            const bool isOfThing = isThing(m_owner) || std::ranges::any_of(m_path, [&](std::size_t node) {
                                       return node > 0 && isThing(m_outline.node(node).name);
                                   });
            if (look.eye && look.eye != look.target && look.angle && !isCounted && !isOfThing && !nearest(kOthers, 1))
                found.push_back(look);
        }
        return found;
    }

    /// The first value around the last look that changes the picture; null: there is none.
    const NamedValue *change(const Look &look) const
    {
        for (const std::size_t node : m_outline.pathTo(m_outline.nodeAt(look.eye->at))) {
            const auto part = m_parts.find(node);
            if (part == m_parts.end())
                continue;
            for (const NamedValue *one : part->second) {
                const bool isNothing =
                    one->word.empty() && one->numbers == std::vector{isAmong(*one, "zoom") ? 1.0 : 0.0};
                const bool isPart =
                    ownerOf(*one) == look.eye->written || (look.target && ownerOf(*one) == look.target->written);
                if (isPart) // eye.x = 2
                    return one;
                if (isAmong(*one, kChanges) && !isNothing && !isThing(ownerOf(*one)))
                    return one;
            }
        }
        return nullptr;
    }

private:
    static bool isVector(const NamedValue &value, std::string_view names)
    {
        return value.numbers.size() == 3 && isAmong(value, names);
    }

    /// The value with one of the names in the part of the text that has the target, or in one around it. Notes another
    /// one with other numbers there.
    const NamedValue *nearest(std::string_view names, std::size_t count)
    {
        for (auto node = m_path.rbegin(); node != m_path.rend(); ++node) {
            const NamedValue *found = nullptr;
            const auto part = m_parts.find(*node);
            if (part == m_parts.end())
                continue;
            for (const NamedValue *one : part->second) {
                const std::string_view owner = ownerOf(*one);
                const bool isOwn = owner == m_owner || (owner.empty() && count != 3);
                if (!isOwn || one->numbers.empty() || !isAmong(*one, names))
                    continue;
                if (!found && one->numbers.size() == count)
                    found = one;
                else if (!m_twice && (!found || found->numbers != one->numbers))
                    m_twice = one;
            }
            if (found)
                return found;
        }
        return nullptr;
    }

    std::shared_ptr<const NamedValues> m_values;
    Outline m_outline;
    std::map<std::size_t, std::vector<const NamedValue *>> m_parts; ///< the values of each part of the text
    std::vector<std::size_t> m_path;
    std::string_view m_owner;
    const NamedValue *m_twice = nullptr;
};

Cameras lookingCameras(Reading &reading, const Node &text)
{
    constexpr std::size_t kLongest = std::size_t{1} << 20;
    if (reading.text.text.size() > kLongest)
        return {};
    const std::string lower = base::lowerCase(reading.text.text);
    for (const char *other : {"distortion", "fisheye", "panoram", "spherical"}) { // lenses that are no pinhole
        if (lower.find(other) != lower.npos)
            return {};
    }
    LookReader reader(reading);
    const std::vector<Look> looks = reader.looks();
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

/// Returns whether the line of a value has a word.
bool hasInLine(const Reading &reading, const NamedValue &value, std::string_view word)
{
    const std::string_view rest = std::string_view(reading.text.text).substr(value.at);
    return base::lowerCase(rest.substr(0, rest.find('\n'))).find(word) != std::string::npos;
}

void setAngle(Reading &reading, const Look &look)
{
    const NamedValue &angle = *look.angle;
    const double value = angle.number();
    const auto hasWord = [&](std::string_view words) {
        return std::ranges::any_of(angle.words, [&](const std::string &one) { return base::isListed(words, one); })
               || std::ranges::any_of(wordsOf(angle.written),
                                      [&](const std::string &one) { return base::isListed(words, one); });
    };
    const bool isAcross = hasWord("x h horizontal hor fovx hfov xfov") || hasInLine(reading, angle, "horizontal"),
               areWrittenDegrees = angle.unit.starts_with("deg") || hasWord("deg degrees degree fovdeg fovdegrees")
                                   || hasInLine(reading, angle, "degree"),
               areWrittenRadians = angle.unit.starts_with("rad") || hasWord("rad radians"),
               areRadians = areWrittenRadians || (!areWrittenDegrees && angle.unit.empty() && value <= kPi);
    if (!isAcross && !hasWord("y v vertical vert fovy vfov yfov"))
        reading.say(tr("%1 is read as the vertical field of view; a horizontal one has the name fov_x.",
                       base::quoted(angle.written)));
    if (areRadians && !areWrittenRadians)
        reading.say(tr("%1 is read in radians, because it is at most pi.", base::quoted(angle.written)));
    const double radians = areRadians ? value : base::radiansFromDegrees(value);
    const std::optional<double> aspect = look.aspect ? std::optional(look.aspect->number()) : std::nullopt;
    if (isAcross)
        reading.setHorizontalAngle(radians);
    else
        reading.setVerticalAngle(radians, aspect);
    const ImageSize size = reading.neededSize();
    constexpr double kVisible = 0.01;
    if (aspect && std::abs(*aspect * size.height / size.width - 1.0) > kVisible)
        reading.say(
            tr("The aspect %1 is not that of the size: the picture is stretched.", base::shortestText(*aspect)));
}

void readLook(Reading &reading)
{
    LookReader looks(reading);
    const Look look = looks.looks()[reading.camera.image];
    if (look.twice)
        reading.fail(tr("%1 has several values. Give the text of one camera", look.twice->written), look.twice->line);
    const std::string text = base::lowerCase(reading.text.text);
    const bool isTurned = text.find("orthographic") != text.npos || text.find("left-handed") != text.npos
                          || text.find("left_handed") != text.npos || text.find("lefthanded") != text.npos;
    if (const NamedValue *change = looks.change(look); change || isTurned)
        reading.fail(tr("%1 is not read beside eye, target and up; leave it out, or give the matrices",
                        change ? change->written : std::string("orthographic, left-handed")),
                     change ? change->line : 0);
    for (const NamedValue *one : {look.eye, look.target, look.direction, look.up, look.angle, look.aspect}) {
        if (one)
            reading.used.insert(plain(one->written));
    }
    if (!look.up)
        reading.fail(tr("the up direction is missing; give up = 0 1 0, or up = 0 0 1"), look.eye->line);
    const glm::dvec3 eye = vectorOf(reading, *look.eye);
    const auto toTarget = look.target ? std::optional(vectorOf(reading, *look.target) - eye) : std::nullopt;
    const glm::dvec3 ahead = toTarget ? *toTarget : vectorOf(reading, *look.direction);
    constexpr double kSame = 1e-3;
    if (toTarget && look.direction
        && glm::distance(glm::normalize(ahead), glm::normalize(vectorOf(reading, *look.direction))) > kSame)
        reading.fail(
            tr("%1 and %2 say different directions; leave one out", look.target->written, look.direction->written),
            look.direction->line);
    reading.setLooking(eye, -ahead, vectorOf(reading, *look.up));
    setAngle(reading, look);
    reading.say(tr("The world is read as right-handed."));
}

constexpr Form kForms[]{{"look-at", "", kOpenGl, lookingCameras, readLook, {.planes = "near far"}}};

} // namespace

std::span<const Form> lookAtForms()
{
    return kForms;
}

} // namespace unprojector::cameras
