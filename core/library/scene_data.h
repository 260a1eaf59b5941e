#pragma once

#include "unprojector/scene.h"

#include "core/opening/opened_scene.h"

#include <memory>
#include <mutex>
#include <utility>
#include <vector>

namespace unprojector {

struct Scene::Data {
    Data(opening::OpenedScene openedScene, const Setup &itsSetup, std::vector<SceneObject> itsObjects)
        : opened(std::move(openedScene)), setup(itsSetup), objects(std::move(itsObjects))
    {
    }

    opening::OpenedScene opened;
    Setup setup;
    std::vector<SceneObject> objects;
    /// Built for the first pick: a scene that is only read needs none.
    mutable std::once_flag areCastersBuilt;
    mutable std::vector<std::shared_ptr<const ray::RayCaster>> casters;
};

/// The way of the library's own code into a Scene.
struct SceneAccess {
    static Scene make(opening::OpenedScene opened, const Setup &setup);
    static const opening::OpenedScene &of(const Scene &scene) { return scene.m_data->opened; }

    using Rays = Result<std::shared_ptr<const ray::SceneRays>>;
    /// The rays of a setup's pixels. Builds the search trees at the first call.
    static Rays rays(const Scene &scene, const geometry::Setup &setup);
};

} // namespace unprojector
