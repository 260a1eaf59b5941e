#pragma once

#include "core/mesh/mesh.h"

#include <memory>
#include <utility>

/// A model of one mesh, as an importer makes it.
inline std::shared_ptr<unprojector::mesh::Model> modelOf(unprojector::mesh::Mesh mesh)
{
    auto model = std::make_shared<unprojector::mesh::Model>();
    model->meshes.push_back(std::move(mesh));
    model->bounds = boundsOf(model->meshes);
    return model;
}
