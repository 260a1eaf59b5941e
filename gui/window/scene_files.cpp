#include "gui/window/scene_files.h"

#include "core/files/replace_file.h"
#include "core/mesh_import/named_files.h"
#include "gui/document/scene_document.h"
#include "gui/document/session.h"
#include "gui/text/error_text.h"

#include <QCoreApplication>

#include <algorithm>
#include <system_error>
#include <vector>

namespace unprojector::gui {
namespace {

struct SceneFiles {
    Q_DECLARE_TR_FUNCTIONS(unprojector::gui::SceneFiles)
};

bool isOf(const scene::SceneObject &object, const std::filesystem::path &file)
{
    const scene::Model &model = *object.model;
    const auto isIt = [&file](const std::filesystem::path &other) { return files::isSameFile(other, file); };
    // The model is read for the names in it only where one of these could be lost.
    const auto isNamed = [&] {
        const std::vector<std::filesystem::path> named = mesh_import::namedFiles(object.file);
        return std::any_of(named.begin(), named.end(), isIt);
    };
    std::error_code error;
    return isIt(object.file) || std::any_of(model.otherFiles.begin(), model.otherFiles.end(), isIt)
           || std::any_of(model.textures.begin(), model.textures.end(),
                          [&isIt](const scene::Texture &texture) { return isIt(texture.file); })
           || (std::filesystem::is_regular_file(file, error) && isNamed());
}

} // namespace

QString overwritingText(const SceneDocument &document, const Session &session, const std::filesystem::path &file)
{
    const std::vector<scene::SceneObject> &objects = document.objects();
    const bool isScene = files::isSameFile(session.file(), file);
    const bool isOfObject = std::any_of(objects.begin(), objects.end(),
                                        [&file](const scene::SceneObject &object) { return isOf(object, file); });
    return isScene || isOfObject
               ? SceneFiles::tr(
                     "%1: the scene that is open uses this file, which would be destroyed. Give another name.")
                     .arg(pathText(file))
               : QString();
}

} // namespace unprojector::gui
