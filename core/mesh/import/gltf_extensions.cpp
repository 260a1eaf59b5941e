#include "core/mesh/import/gltf_extensions.h"

#include "core/base/translation.h"
#include "core/mesh/import/gltf_draco.h"
#include "core/mesh/import/meshopt_view.h"

#include <algorithm>
#include <iterator>
#include <set>
#include <string>

namespace unprojector::mesh::reader {
using base::marked;
using base::tr;

namespace {

constexpr std::string_view kRead[] = {"EXT_mesh_gpu_instancing", "KHR_mesh_quantization", "KHR_node_visibility",
                                      "KHR_texture_transform", "KHR_materials_pbrSpecularGlossiness"};

/// Words in the names of extensions that move no vertex: of materials, images, lights, data, motion
/// and sound.
constexpr std::string_view kWordsBesideShape[] = {
    "material", "technique", "texture", "image",   "light", "animation",     "audio", "physics",
    "metadata", "features",  "xmp",     "outline", "ngon",  "articulations", "lod",   "VRM"};

bool leavesShape(std::string_view name)
{
    return std::ranges::any_of(kWordsBesideShape,
                               [name](std::string_view word) { return name.find(word) != name.npos; });
}

std::set<std::string> namesIn(const GltfFile &file, const char *key)
{
    std::set<std::string> names;
    for (const Json &name : file.array(key)) {
        if (!name.is_string())
            failMalformed(tr("\"%1\" holds other values than names", key));
        names.insert(name.get<std::string>());
    }
    return names;
}

} // namespace

bool isReadExtension(std::string_view name)
{
    return (name == kDracoExtension && hasDraco()) || (name == kMeshoptExtension && hasMeshopt())
           || std::ranges::find(kRead, name) != std::end(kRead);
}

const Json *extensionOf(const Json &object, const char *name)
{
    const Json *extensions = GltfFile::find(object, "extensions");
    return extensions ? GltfFile::find(*extensions, name) : nullptr;
}

void failWithoutLibrary(std::string_view name)
{
    const bool isDraco = name == kDracoExtension;
    failUnsupported(
        tr("it needs the glTF extension %1, and this program was built without the library %2, which unpacks it; "
           "build it with -D%3=ON, or export the file without the extension",
           name, isDraco ? "Draco" : "meshoptimizer", isDraco ? "UNPROJECTOR_DRACO" : "UNPROJECTOR_MESHOPTIMIZER"));
}

void checkExtensions(const GltfFile &file, std::vector<base::Note> &notes)
{
    for (const std::string &name : namesIn(file, "extensionsRequired")) {
        if (isReadExtension(name))
            continue;
        if (name == kDracoExtension || name == kMeshoptExtension)
            failWithoutLibrary(name);
        if (!leavesShape(name))
            failUnsupported(tr("it needs the glTF extension %1, which is not supported; export it without", name));
        notes.push_back({marked("the glTF extension \"%1\", which the file requires, is not applied: the shape is "
                                "whole without it, but colours, light, motion or data may be missing"),
                         {name}});
    }
    for (const std::string &name : namesIn(file, "extensionsUsed")) {
        if (!isReadExtension(name) && !leavesShape(name))
            notes.push_back(
                {marked("the glTF extension \"%1\" is not supported: the shape that the file has without it "
                        "is shown"),
                 {name}});
    }
}

} // namespace unprojector::mesh::reader
