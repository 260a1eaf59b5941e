#pragma once

#include "core/scene/mesh.h"

#include <memory>
#include <utility>

/// A model of one mesh, as an importer makes it.
inline std::shared_ptr<unprojector::scene::Model> modelOf(unprojector::scene::Mesh mesh)
{
    auto model = std::make_shared<unprojector::scene::Model>();
    model->meshes.push_back(std::move(mesh));
    model->bounds = boundsOf(model->meshes);
    return model;
}
