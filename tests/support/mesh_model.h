#pragma once

#include "core/mesh/mesh.h"

#include <cstdint>
#include <memory>
#include <utility>

/// The triangles of a mesh without vertex numbers: each has three vertices of its own.
inline unprojector::mesh::Mesh soupOf(const unprojector::mesh::Mesh &mesh)
{
    unprojector::mesh::Mesh soup;
    for (const std::uint32_t index : mesh.indices)
        soup.positions.push_back(mesh.positions[index]);
    return soup;
}

/// A model of one mesh, as an importer makes it.
inline std::shared_ptr<unprojector::mesh::Model> modelOf(unprojector::mesh::Mesh mesh)
{
    auto model = std::make_shared<unprojector::mesh::Model>();
    model->meshes.push_back(std::move(mesh));
    model->bounds = boundsOf(model->meshes);
    return model;
}
