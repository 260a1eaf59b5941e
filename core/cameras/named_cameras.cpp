// The cameras of a text, which value is of which, and which one is read.

#include "core/base/translation.h"
#include "core/cameras/camera_values.h"
#include "core/cameras/reader_parts.h"
#include "core/cameras/scan.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace unprojector::cameras {
using base::tr;
using enum Part;
namespace {

constexpr std::array kPoseParts{Part::Rotation, Part::Quaternion, Part::Translation, Part::Center, Part::Pose};

/// Fails for parts of one camera beside several lenses.
void refuseCount(const std::vector<CameraValue> &values, std::size_t lenses)
{
    throw values.front().error(
        tr("the text has %1 camera matrices, but %2 of this. Give the text of one camera", lenses, values.size()));
}

/// The names of some values; where two have the same name, those of the parts of the text around them,
/// else their indexes.
std::vector<std::string> namesOf(const CameraValues &values, Part part)
{
    std::vector<std::string> names, labels, indexes;
    for (const CameraValue &value : values.all(part)) {
        names.push_back(value.name);
        labels.push_back(values.outline(value.text).node(value.node).label);
        indexes.push_back(std::to_string(indexes.size()));
    }
    for (const std::vector<std::string> *some : {&names, &labels}) {
        const std::set<std::string> different(some->begin(), some->end());
        if (different.size() == some->size() && !different.contains({}))
            return *some;
    }
    return indexes;
}

/// Chooses one of the images that name their cameras. Returns whether there are any.
bool chooseImageOfCamera(Reading &reading, CameraValues &values)
{
    const std::vector<CameraValues::Image> images = values.images();
    if (images.empty() || std::ranges::count(values.cameras(), reading.choices.image) > 0)
        return false;
    for (const CameraValues::Image &image : images)
        reading.camera.images.push_back(image.name);
    reading.chooseImage();
    const CameraValues::Image &image = images[reading.camera.image];
    if (!values.keepImage(image))
        reading.fail(tr("the image %1 is of the camera %2, but no camera has this id", image.name, image.camera));
    return true;
}

/// Returns whether the second of two cameras is chosen, beside OpenCV's stereo R and T from the first.
bool isStereo(Reading &reading, const CameraValues &values)
{
    const auto isShared = [&](Part part, const char *name) {
        const std::vector<CameraValue> &all = values.all(part);
        const auto first = std::ranges::find_if(all, [&](const CameraValue &one) { return !values.isOfCamera(one); });
        return first != all.end() && first->name == name;
    };
    const std::vector<CameraValue> &lenses = values.all(Intrinsics);
    const bool isOpenCv = reading.camera.images == std::vector<std::string>{"1", "2"} && lenses.size() == 2
                          && (lenses[0].name == "M1" || lenses[0].name == "cameraMatrix1");
    if (!isOpenCv || reading.camera.image != 1 || !isShared(Rotation, "R") || !isShared(Translation, "T"))
        return false;
    reading.say(tr("R and T are OpenCV's of two cameras: the world is the camera %1's.", lenses[0].name));
    return true;
}

/// Fails for R or t that no camera of several has for its own, which may lead from one camera to the
/// other, and for several such poses where no camera is chosen.
void refuseShared(const Reading &reading, const CameraValues &values)
{
    for (const Part part : {Rotation, Translation, Pose}) {
        if (!reading.choices.image.empty() && (part == Pose || values.all(Translation).empty()))
            continue;
        const auto count =
            std::ranges::count_if(values.all(part), [&](const CameraValue &one) { return !values.isOfCamera(one); });
        if (count > (part == Pose ? 1 : 0))
            refuseCount(values.all(part), values.cameras().size());
    }
}

/// Fails if several K stand beside fewer or more parts of another kind: nothing tells which
/// belong together, unless the user chooses a K by its name.
void refuseMixed(const Reading &reading, const CameraValues &values)
{
    const std::vector<std::string> names = namesOf(values, Intrinsics);
    if (std::ranges::count(names, reading.choices.image) > 0 && names[0] != "0")
        return;
    for (const Part part : {Rotation, Quaternion, Translation, Pose, Distortion}) {
        const std::vector<CameraValue> &some = values.all(part);
        if (!some.empty() && some.size() != names.size())
            refuseCount(some, names.size());
    }
}

} // namespace

/// Where the values with a focal length stand, each once.
std::vector<Spot> CameraValues::lenses() const
{
    std::vector<Spot> found;
    std::set<Spot> seen;
    for (const Part part : {Part::Intrinsics, Part::CameraMatrix, Part::Focal, Part::Number}) {
        for (const CameraValue &value : all(part)) {
            if ((part != Part::Number || value.isNamed("fx")) && seen.insert(value).second)
                found.push_back(value);
        }
    }
    return found;
}

/// The innermost id around a value, with the part of the text that has it; null if there is none.
const CameraValues::Ids::value_type *CameraValues::idAround(const Spot &value, const Ids &ids) const
{
    for (std::size_t node = value.node; node > 0; node = m_outlines[value.text].node(node).parent) {
        if (const auto found = ids.find({value.text, node}); found != ids.end())
            return &*found;
    }
    return nullptr;
}

/// The id of a lens, or the name of its camera.
std::string CameraValues::idOf(const Spot &lens) const
{
    for (const Ids *ids : {&m_ids, &m_references}) {
        if (const auto *found = idAround(lens, *ids))
            return found->second;
    }
    return cameraOf(lens);
}

/// Returns whether a value is of another camera than a lens: they stand in two items of a list, or in
/// parts that have the names of two cameras, or the value names another one.
bool CameraValues::isOfOtherThan(const Spot &lens, const Spot &value) const
{
    const auto differ = [](const std::string &one, const std::string &other) {
        return !one.empty() && !other.empty() && one != other;
    };
    if (lens.text != value.text || differ(lens.camera, value.camera))
        return differ(lens.camera, value.camera);
    const Outline &outline = m_outlines[lens.text];
    const std::vector<std::size_t> first = pathTo(lens), second = pathTo(value);
    const auto [a, b] = std::ranges::mismatch(first, second);
    if (a == first.end() || b == second.end())
        return false;
    const Outline::Node &one = outline.node(*a), &other = outline.node(*b);
    const std::string name = outline.nameOf(*a);
    const auto *reference = idAround(value, m_references);
    return (one.isOfSeveral && other.isOfSeveral && one.name == other.name)
           || differ(cameras::cameraOf(name), cameras::cameraOf(outline.nameOf(*b)))
           || (reference && differ(reference->second, idOf(lens)) && reference->second != name);
}

/// Sets apart what stands with other things than the camera ("imu", "display"), poses of other
/// cameras, and the transform to the camera before.
void CameraValues::dropElsewhere()
{
    using enum Part;
    const std::vector<Spot> lenses = this->lenses();
    std::set<std::pair<std::size_t, std::size_t>> nodes; // texts and nodes around the lenses
    std::set<std::string> around;                        // their names
    for (const Spot &lens : lenses) {
        for (const std::size_t node : pathTo(lens)) {
            if (nodes.emplace(lens.text, node).second)
                around.insert(m_outlines[lens.text].nameOf(node));
        }
    }
    const auto isApart = [&](const CameraValue &value) {
        return std::ranges::any_of(sectionsOf(value), [&](const std::string &section) {
            return !around.contains(section) && isElsewhere(section);
        });
    };
    std::map<Spot, bool> known; // a text has many values in one place
    const auto isOfOther = [&](const CameraValue &value) {
        const auto &[one, isNew] = known.try_emplace(value, false);
        if (isNew && !lenses.empty())
            one->second = std::ranges::all_of(lenses, [&](const Spot &lens) { return isOfOtherThan(lens, value); });
        return one->second;
    };
    const auto split = [&](Part part, const auto &isOther) {
        std::vector<CameraValue> kept;
        for (CameraValue &value : of(part))
            (isOther(value) ? of(Other) : kept).push_back(std::move(value));
        of(part) = std::move(kept);
    };
    // A pose in the camera's own part of the text counts before one elsewhere.
    const auto depthOf = [&](const CameraValue &value) {
        return std::ranges::count_if(pathTo(value), [&](std::size_t node) {
            return nodes.contains({value.text, node});
        });
    };
    for (const Part part : kPoseParts) {
        std::ptrdiff_t deepest = 0;
        for (const CameraValue &value : all(part))
            deepest = m_cameras.empty() ? std::max(deepest, depthOf(value)) : 0;
        split(part,
              [&](const CameraValue &value) { return isOfOther(value) || isApart(value) || depthOf(value) < deepest; });
    }
    split(Size, isApart);
    const auto isToCameraBefore = [](const CameraValue &value) { return value.role.world == "camera before"; };
    if (!std::ranges::all_of(all(Pose), isToCameraBefore))
        split(Pose, isToCameraBefore);
    // The chip's size is in millimetres.
    const auto isOfSensor = [&](const CameraValue &value) {
        std::vector<std::string> names = sectionsOf(value);
        std::erase_if(names, [&](const std::string &section) { return around.contains(section); });
        names.push_back(value.written);
        return std::ranges::any_of(
            names, [](const std::string &name) { return std::ranges::count(wordsOf(name), "sensor") > 0; });
    };
    std::erase_if(of(Number), [&](const CameraValue &number) {
        const bool isOfRegion = number.isNamed("xoffset") || number.isNamed("yoffset"); // see readRectification
        return !number.isNamed("fx") && !isOfRegion && (isApart(number) || isOfSensor(number));
    });
}

/// The names of the parts of a text around a place, the outermost first.
std::vector<std::string> CameraValues::sectionsOf(const Spot &value) const
{
    std::vector<std::string> names;
    for (const std::size_t around : pathTo(value))
        names.push_back(m_outlines[value.text].nameOf(around));
    return names;
}

/// Finds the cameras of the text: where the sections of the lenses part, else the ends of the names
/// of the lenses.
void CameraValues::findCameras()
{
    const std::vector<Spot> lenses = this->lenses();
    const auto setCameras = [&](std::size_t depth) {
        m_depth = depth;
        for (const Spot &lens : lenses) {
            if (const auto &[name, isNew] = m_cameraNames.insert(cameraOf(lens)); isNew)
                m_cameras.push_back(*name);
        }
        if (m_cameras.size() < 2 || m_cameraNames.contains({})) {
            m_cameras.clear();
            m_cameraNames.clear();
        }
        return !m_cameras.empty();
    };
    const std::size_t deepest = lenses.empty() ? 0 : pathTo(lenses.front()).size();
    for (std::size_t depth = 1; depth < deepest; ++depth) {
        if (setCameras(depth))
            return;
    }
    setCameras(0);
}

void CameraValues::keepCamera(const std::string &name, const Spot &image)
{
    const auto isOfOther = [&](const CameraValue &value) {
        const bool isOfImage =
            image.node > 0 && value.text == image.text && std::ranges::count(pathTo(value), image.node) > 0;
        return !isOfImage && cameraOf(value) != name && isOfCamera(value);
    };
    for (std::size_t kind = 0; kind < std::size_t(Part::Empty); ++kind)
        std::erase_if(m_parts[kind], isOfOther);
    dropElsewhere();
}

std::vector<CameraValues::Image> CameraValues::images() const
{
    std::vector<Image> images;
    std::set<Spot> seen;
    for (const Part part : kPoseParts) {
        for (const CameraValue &value : all(part)) {
            const auto *reference = idAround(value, m_references);
            if (reference && seen.insert(reference->first).second)
                images.push_back({m_outlines[reference->first.text].nameOf(reference->first.node), reference->second,
                                  reference->first});
        }
    }
    return images;
}

bool CameraValues::keepImage(const Image &image)
{
    const std::vector<Spot> lenses = this->lenses();
    const auto lens = std::ranges::find_if(
        lenses, [&](const Spot &one) { return idOf(one) == image.camera || cameraOf(one) == image.camera; });
    if (lens == lenses.end())
        return false;
    for (const Part part : kPoseParts) {
        std::erase_if(of(part), [&](const CameraValue &value) {
            const auto *reference = idAround(value, m_references);
            return reference && reference->first != image.place;
        });
    }
    keepCamera(cameraOf(*lens), image.place);
    return true;
}

/// The name of the camera that a value may be of.
std::string CameraValues::cameraOf(const Spot &value) const
{
    if (m_depth == 0)
        return value.camera;
    const std::vector<std::size_t> path = pathTo(value);
    return m_depth < path.size() ? m_outlines[value.text].nameOf(path[m_depth]) : std::string();
}

void chooseCamera(Reading &reading, CameraValues &values)
{
    std::vector<std::string> &images = reading.camera.images;
    if (values.cameras().size() > 1) {
        if (chooseImageOfCamera(reading, values))
            return;
        images = values.cameras();
        std::vector<std::string> lenses;
        for (const Part part : {Intrinsics, CameraMatrix}) {
            if (lenses.empty() && values.all(part).size() == images.size())
                lenses = namesOf(values, part);
        }
        reading.chooseImage(lenses);
        if (!isStereo(reading, values))
            refuseShared(reading, values);
        values.keepCamera(images[reading.camera.image]);
        return;
    }
    const std::vector<CameraValue> &lenses = values.all(Intrinsics);
    const bool areSeveral =
        std::ranges::any_of(lenses, [&lenses](const CameraValue &k) { return k.numbers != lenses.front().numbers; });
    std::vector<Part> parts{Rotation, Quaternion, Translation, Pose, CameraMatrix};
    if (values.isCameraInfo())
        parts = {Intrinsics};
    else if (areSeveral)
        parts.push_back(Intrinsics);
    const Part most = *std::ranges::max_element(parts, {}, [&](Part part) { return values.all(part).size(); });
    if (values.all(most).size() > 1)
        images = namesOf(values, most);
    if (areSeveral)
        refuseMixed(reading, values);
    reading.chooseImage();
}

} // namespace unprojector::cameras
