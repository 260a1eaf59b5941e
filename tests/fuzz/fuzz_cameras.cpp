// Cameras of other programs, as `unproject scene` reads them and converts them to a scene.

#include "core/cameras/camera_reader.h"
#include "core/geometry/finite.h"
#include "tests/fuzz/fuzzing.h"

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

using namespace unprojector;
using namespace unprojector::cameras;

/// The first byte 0 in the input divides it into two texts, as COLMAP's two files.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size)
{
    const std::string all(fuzz::text(data, size));
    const std::size_t zero = std::min(all.find('\0'), all.size());
    std::vector<NamedText> texts{{"a", all.substr(0, zero)}};
    if (zero < all.size())
        texts.push_back({"b", all.substr(zero + 1)});
    CameraChoices choices;
    choices.isUndistorted = size % 2 == 1;
    if (size % 3 == 1)
        choices.size = ImageSize{640, 480};
    if (size % 5 == 1)
        choices.image = "1";
    const auto camera = readCamera(texts, choices);
    if (!camera)
        return 0;
    if (!*camera) {
        fuzz::require(!camera->error().text.empty(), "an error has a reason");
        return 0;
    }
    const geometry::Box box{glm::dvec3(-1.0), glm::dvec3(1.0)};
    const auto scene = sceneCamera(**camera, choices, size % 7 == 1 ? std::nullopt : std::optional(box));
    if (!scene) {
        fuzz::require(!scene.error().text.empty(), "an error has a reason");
        return 0;
    }
    fuzz::require(scene->size.width > 0 && scene->size.height > 0, "a camera has a size");
    fuzz::require(geometry::isFinite(scene->eyeFromWorld), "a view is finite");
    if (scene->nearDistance)
        fuzz::require(*scene->nearDistance > 0.0 && *scene->nearDistance < *scene->farDistance, "near is before far");
    return 0;
}
