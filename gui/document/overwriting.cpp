#include "gui/document/overwriting.h"

#include "core/base/replace_file.h"
#include "core/mesh/import/named_files.h"
#include "gui/document/scene_document.h"
#include "gui/document/session.h"
#include "gui/text/error_text.h"

#include <QCoreApplication>

#include <algorithm>
#include <filesystem>
#include <set>
#include <system_error>
#include <vector>

namespace unprojector::gui {
namespace {

struct SceneFiles {
    Q_DECLARE_TR_FUNCTIONS(unprojector::gui::SceneFiles)
};

/// Returns whether a model is read from a file, or refers to it. Many objects may share one model.
bool isOfAny(const std::vector<scene::SceneObject> &objects, const std::filesystem::path &file)
{
    std::set<std::filesystem::path> models, read;
    for (const scene::SceneObject &object : objects) {
        models.insert(object.file);
        read.insert(object.model->otherFiles.begin(), object.model->otherFiles.end());
        for (const mesh::Texture &texture : object.model->textures)
            read.insert(texture.file);
    }
    const auto isIt = [&file](const std::filesystem::path &other) { return base::isSameFile(other, file); };
    const auto isAmong = [&isIt](const auto &list) { return std::any_of(list.begin(), list.end(), isIt); };
    if (isAmong(models) || isAmong(read))
        return true;
    // The models are searched for file names only if an existing file could be lost.
    std::error_code error;
    return std::filesystem::is_regular_file(file, error)
           && std::any_of(models.begin(), models.end(),
                          [&isAmong](const std::filesystem::path &model) { return isAmong(mesh::namedFiles(model)); });
}

} // namespace

QString overwritingText(const SceneDocument &document, const Session &session, const std::filesystem::path &file)
{
    const std::vector<scene::SceneObject> &objects = document.objects();
    const bool isScene = base::isSameFile(session.file(), file);
    return isScene || isOfAny(objects, file)
               ? SceneFiles::tr("%1: the open scene uses this file and would destroy it. Choose another name.")
                     .arg(pathText(file))
               : QString();
}

} // namespace unprojector::gui
