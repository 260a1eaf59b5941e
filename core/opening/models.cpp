#include "core/opening/models.h"

#include "core/base/path_text.h"
#include "core/base/text_scanner.h"
#include "core/base/translation.h"
#include "core/examples/examples.h"

#include <algorithm>
#include <new>
#include <set>
#include <system_error>
#include <utility>

namespace unprojector::opening {
using namespace geometry;
using namespace scene;
using namespace mesh;
using namespace scene_file;

ModelFiles::State ModelFiles::stateOf(const std::filesystem::path &file)
{
    std::error_code error;
    State state;
    state.size = std::filesystem::file_size(file, error);
    if (!error)
        state.time = std::filesystem::last_write_time(file, error);
    state.isKnown = !error;
    return state;
}

ReadModel ModelFiles::read(const std::filesystem::path &file, const base::Progress &progress,
                           const std::function<bool(Model &)> &prepare)
{
    std::error_code error;
    const std::filesystem::path path = std::filesystem::weakly_canonical(file, error);
    // Taken before the file is read, so that a change during reading is detected.
    const State state = error ? State() : stateOf(file);
    ModelPointer known;
    if (state.isKnown) {
        const std::lock_guard lock(m_mutex);
        const auto found = m_files.find(path);
        if (found != m_files.end() && found->second.state == state)
            known = found->second.model.lock();
    }
    if (known && progress && !progress(1.0))
        return stoppedReading(file);
    if (known)
        return known;
    auto imported = importModel(file, progress);
    if (!imported)
        return imported.error();
    const std::shared_ptr<Model> model = std::move(imported).value();
    try {
        if (prepare && !prepare(*model))
            return stoppedReading(file);
    } catch (const std::bad_alloc &) {
        return tooLargeForMemory(file);
    }
    if (state.isKnown) {
        const std::lock_guard lock(m_mutex);
        if (m_files.size() >= m_sizeOfNextCleaning) { // looking at all for each new one takes long for many
            std::erase_if(m_files, [](const auto &entry) { return entry.second.model.expired(); });
            m_sizeOfNextCleaning = 2 * m_files.size() + 1;
        }
        m_files[path] = {state, model};
    }
    return ModelPointer(model);
}

bool isMeantAsScene(const std::filesystem::path &file)
{
    const std::string name = base::utf8FromPath(file.filename()); // also of ".json", which has no extension
    return base::lowerCase(name).ends_with(".json") || isSceneFile(file);
}

std::vector<std::filesystem::path> modelFiles(const SceneFile &scene, const std::filesystem::path &sceneFile)
{
    std::vector<std::filesystem::path> files;
    std::set<std::filesystem::path> known;
    for (const SceneFileObject &object : scene.objects) {
        if (!object.bundled.empty())
            continue;
        std::filesystem::path file = objectFile(object, sceneFile);
        if (known.insert(file).second)
            files.push_back(std::move(file));
    }
    return files;
}

base::Expected<std::vector<SceneObject>, base::Error>
objectsOf(const SceneFile &scene, const std::filesystem::path &sceneFile,
          const std::function<ReadModel(const std::filesystem::path &)> &read)
{
    std::map<std::filesystem::path, ModelPointer> models;
    std::vector<SceneObject> objects;
    for (const SceneFileObject &object : scene.objects) {
        const std::filesystem::path file = objectFile(object, sceneFile);
        ModelPointer model = object.bundled.empty() ? models[file] : nullptr;
        if (!object.bundled.empty()) {
            const auto &bundled = examples::bundledModels();
            const auto found = bundled.find(object.bundled);
            if (found == bundled.end())
                return base::Error{base::tr("there is no bundled model \"%1\"", object.bundled), object.name};
            model = found->second;
        } else if (!model) {
            ReadModel of = read(file);
            if (!of)
                return base::Error{.text = of.error().message(), .subject = object.name, .kind = of.error().kind};
            model = models[file] = std::move(of).value();
        }
        objects.push_back({object.name, file, std::move(model), object.transform, object.isHidden, object.extra});
    }
    return objects;
}

} // namespace unprojector::opening
