// Cameras and matrices of any text, as `unproject scene` and Paste Camera read them, with all corrections.

#include "core/cameras/pasted_camera.h"
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
    PasteChoices choices;
    choices.camera.isUndistorted = size % 2 == 1;
    if (size % 3 == 1)
        choices.camera.size = ImageSize{640, 480};
    if (size % 5 == 1)
        choices.camera.image = "1";
    choices.isScene = size % 11 == 1;
    choices.conventions = geometry::kApis[size % geometry::kApis.size()];
    const geometry::Box box{glm::dvec3(-1.0), glm::dvec3(1.0)};
    const std::optional<geometry::Box> objects = size % 7 == 1 ? std::nullopt : std::optional(box);
    const PastedCamera camera = pastedCamera(texts, choices, objects);
    if (camera.fault)
        fuzz::require(!camera.fault->text.empty(), "an error has a reason");
    else
        fuzz::require(camera.scene || camera.isViewportSet || !camera.matrices.empty(),
                      "a text without an error has a camera");
    for (const ReadMatrix &one : camera.matrices) {
        for (const pipeline::MatrixFinding &finding : one.findings)
            choices.corrections.push_back({one.role, finding});
    }
    if (!choices.corrections.empty())
        pastedCamera(texts, choices, objects);
    const auto &scene = camera.scene;
    if (!scene)
        return 0;
    fuzz::require(scene->size.width > 0 && scene->size.height > 0, "a camera has a size");
    fuzz::require(geometry::isFinite(scene->eyeFromWorld), "a view is finite");
    if (scene->nearDistance)
        fuzz::require(*scene->nearDistance > 0.0 && *scene->nearDistance < *scene->farDistance, "near is before far");
    return 0;
}
