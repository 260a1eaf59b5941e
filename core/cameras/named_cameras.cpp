// Which of several cameras and images of a text is read.

#include "core/base/translation.h"
#include "core/cameras/camera_values.h"
#include "core/cameras/reader_parts.h"

#include <algorithm>
#include <set>

namespace unprojector::cameras {
using base::tr;
using enum Part;
namespace {

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
