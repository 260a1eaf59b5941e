#include "core/mesh/import/gltf_instances.h"

#include "core/base/number_text.h"
#include "core/base/translation.h"
#include "core/mesh/import/gltf_extensions.h"
#include "core/mesh/import/gltf_nodes.h"
#include "core/mesh/import/gltf_values.h"

#include <glm/gtc/quaternion.hpp>

#include <optional>

namespace unprojector::mesh::reader {
using namespace geometry;
using base::tr;

namespace {

constexpr const char *kAttributes[] = {"TRANSLATION", "ROTATION", "SCALE"};

/// The extension's attributes, or null if the node has none that transform an instance.
const Json *instanceAttributes(const Json &node)
{
    const Json *instancing = extensionOf(node, "EXT_mesh_gpu_instancing");
    const Json *attributes = instancing ? GltfFile::find(*instancing, "attributes") : nullptr;
    for (const char *name : kAttributes) {
        if (attributes && GltfFile::find(*attributes, name))
            return attributes;
    }
    return nullptr;
}

std::optional<GltfValues> values(GltfFile &file, const Json &attributes, const char *name, std::size_t components,
                                 std::size_t count)
{
    if (!GltfFile::find(attributes, name))
        return std::nullopt;
    GltfValues list(file, file.reference(attributes, name, "accessors"));
    if (list.components() != components || list.count() != count)
        failMalformed(tr("the attribute %1 of instances does not have %2 numbers for each of %3 instances", name,
                         components, count));
    return list;
}

} // namespace

std::size_t instanceCount(const GltfFile &file, const Json &node)
{
    const Json *attributes = instanceAttributes(node);
    for (const char *name : kAttributes) {
        if (attributes && GltfFile::find(*attributes, name))
            return static_cast<std::size_t>(
                GltfFile::number(file.reference(*attributes, name, "accessors"), "count", 0));
    }
    return 1;
}

std::vector<PreciseMatrix> nodeFromInstances(GltfFile &file, const Json &node)
{
    const Json *attributes = instanceAttributes(node);
    if (!attributes)
        return {PreciseMatrix(glm::dmat4(1.0))};
    const std::size_t count = instanceCount(file, node);
    const auto translations = values(file, *attributes, "TRANSLATION", 3, count);
    const auto rotations = values(file, *attributes, "ROTATION", 4, count);
    const auto scales = values(file, *attributes, "SCALE", 3, count);
    std::vector<PreciseMatrix> instances;
    instances.reserve(count);
    for (std::size_t i = 0; i < count; ++i) {
        Placement placement;
        if (translations)
            placement.translation = translations->vectorAt(i);
        if (rotations)
            placement.rotation =
                glm::dquat(rotations->at(i, 3), rotations->at(i, 0), rotations->at(i, 1), rotations->at(i, 2));
        if (scales)
            placement.scale = scales->vectorAt(i);
        if (!placement.isRotationUnit())
            failMalformed(tr("the rotation of instance %1 has the length %2; it must be 1", i,
                             base::shortestText(glm::length(placement.rotation))));
        instances.push_back(placement.matrix());
    }
    return instances;
}

} // namespace unprojector::mesh::reader
