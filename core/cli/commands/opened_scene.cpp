#include "core/cli/commands/opened_scene.h"

#include "core/base/path_text.h"
#include "core/cli/commands/size_text.h"
#include "core/cli/rows/scene_input.h"
#include "core/geometry/error_text.h"

#include <filesystem>
#include <utility>

namespace unprojector::cli {
using namespace geometry;
using namespace scene_file;
using namespace base;
namespace {

/// The value, or nothing with the error on stderr.
template <class Value>
std::optional<Value> valueOrComplaint(Result<Value, opening::OpeningError> result)
{
    if (result)
        return std::move(result).value();
    complain(result.error().message);
    return std::nullopt;
}

} // namespace

bool isMeantAsScene(const std::string &file)
{
    return file == "-" || opening::isMeantAsScene(pathFromUtf8(file));
}

std::optional<OpenedScene> openScene(const std::string &file)
{
    if (!isMeantAsScene(file))
        return valueOrComplaint(opening::openModel(pathFromUtf8(file)));
    std::optional<SceneFile> scene = readScene(file);
    if (!scene)
        return std::nullopt;
    const std::filesystem::path path = file == "-" ? std::filesystem::path() : pathFromUtf8(file);
    return valueOrComplaint(opening::withModels(*std::move(scene), path, file == "-" ? "stdin" : file));
}

bool areReachable(const OpenedScene &opened)
{
    const std::optional<opening::OpeningError> error = opening::unreachable(opened);
    if (error)
        complain(error->message);
    return !error;
}

std::optional<Setup> setupOf(const OpenedScene &opened, const std::string &size)
{
    std::optional<Surface> surface;
    if (!size.empty()) {
        const std::optional<SizeGiven> given = sizeGiven("--size", size);
        if (!given)
            return std::nullopt;
        surface = Surface{given->width, given->height, 1.0};
        if (const Check valid = check(*surface); !valid) {
            complain("--size " + size + ": " + errorText(valid.error()));
            return std::nullopt;
        }
    }
    return valueOrComplaint(opening::setupOf(opened, surface));
}

} // namespace unprojector::cli
