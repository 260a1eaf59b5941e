#include "core/mesh/import/gltf_extensions.h"

#include "core/base/text_scanner.h"
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

/// Extensions that move no vertex and whose names have none of kHarmlessParts, or one of kWordsOfShape. A "*" at the
/// end matches any ending, but no kWordsOfShape.
constexpr std::string_view kHarmless[] = {
    // other ways to draw the same vertices; the vertices of a splatting are points
    "KHR_blend", "EXT_blend", "KHR_gaussian_splatting", "KHR_environment_map", "KHR_displayencoding*",
    "KHR_displaymapping_*", "KHR_framebuffer_value_mapping", "EXT_pbr_attributes", "EXT_mesh_opacity_micromap",
    "EXT_mesh_primitive_edge_visibility", "ADOBE_render_order", "ASOBO_normal_map_convention",
    "CESIUM_primitive_outline", "CESIUM_tile_edges", "EPIC_hdri_backdrops", "GOOGLE_backgrounds", "GOOGLE_tilt_brush_*",
    "MSFT_packing_*",
    // data
    "KHR_data_sizes", "KHR_mesh_annotation", "EXT_geopose", "EXT_manifold", "EXT_mesh_features", "EXT_mesh_manifold",
    "AGI_*", "ASOBO_tags", "ASOBO_unique_id", "CESIUM_geopose", "FB_geometry_metadata", "FB_ngon_encoding",
    "GODOT_single_root", "GRIFFEL_bim_data", "NEEDLE_components", "NEEDLE_gameobject_data", "NEEDLE_persistent_assets",
    // variants: the default of the file is shown
    "MAXAR_mesh_variants",
    // motion, behaviour and physics: nodes stay where the file has them
    "KHR_avatar*", "KHR_behavior", "KHR_character*", "KHR_collision_shapes", "KHR_interactivity",
    "KHR_node_hoverability", "KHR_node_selectability", "KHR_rigid_bodies", "DRACO_animation_compression",
    "HUBS_components", "MAXAR_collision_geometry", "MOZ_hubs_components", "MPEG_anchor", "MPEG_haptic*", "MPEG_media",
    "OMI_*", "VRMC_*"};

/// The same as a part of any name, also in the plural: of materials, images, lights, data, motion and sound.
constexpr std::string_view kHarmlessParts[] = {"material", "technique", "texture",  "textureinfo", "image",     "light",
                                               "lighting", "lightmap",  "camera",   "variant",     "animation", "audio",
                                               "physics",  "feature",   "metadata", "xmp",         "lod",       "vrm"};

/// Such an extension may move vertices.
constexpr std::string_view kWordsOfShape[] = {"mesh",         "geometry", "compression",
                                              "displacement", "accessor", "primitive"};

bool isHarmlessPart(std::string_view part)
{
    return std::ranges::any_of(kHarmlessParts, [part](std::string_view known) {
        return part.starts_with(known) && (part.size() == known.size() || part.substr(known.size()) == "s");
    });
}

/// Whether the shape is whole without the extension.
bool leavesShape(std::string_view name)
{
    if (std::ranges::find(kHarmless, name) != std::end(kHarmless))
        return true;
    std::string lower = base::lowerCase(name);
    if (std::ranges::any_of(kWordsOfShape, [&](std::string_view word) { return lower.find(word) != lower.npos; }))
        return false;
    if (std::ranges::any_of(kHarmless, [name](std::string_view pattern) {
            return pattern.ends_with('*') && name.starts_with(pattern.substr(0, pattern.size() - 1));
        }))
        return true;
    std::ranges::replace(lower, '_', ' ');
    base::TextScanner parts(lower);
    for (std::string_view part = parts.nextWord(); !part.empty(); part = parts.nextWord()) {
        if (isHarmlessPart(part))
            return true;
    }
    return false;
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
