#include "core/mesh/import/gltf_extensions.h"

#include "core/base/translation.h"
#include "core/mesh/import/draco_mesh.h"
#include "core/mesh/import/meshopt_view.h"

#include <algorithm>
#include <iterator>
#include <set>
#include <string>

namespace unprojector::mesh::reader {
using base::marked;
using base::tr;

namespace {

struct Entry {
    std::string_view name; ///< a "*" at the end matches any ending
    GltfExtension meaning;
};

/// The first entry that matches a name counts.
constexpr Entry kExtensions[] = {
    {"EXT_mesh_gpu_instancing", GltfExtension::Read},
    {"KHR_mesh_quantization", GltfExtension::Read},
    {"KHR_node_visibility", GltfExtension::Read},
    {"KHR_texture_transform", GltfExtension::Read},
    {"KHR_materials_pbrSpecularGlossiness", GltfExtension::Read},
    {kDracoExtension, GltfExtension::Unpacked},
    {kMeshoptExtension, GltfExtension::Unpacked},

    // Vertices and faces are packed, or have another source.
    {"KHR_meshopt_compression", GltfExtension::ChangesShape},
    {"MESHOPT_compression", GltfExtension::ChangesShape},
    {"ALI_amc_mesh_compression", GltfExtension::ChangesShape},
    {"KHR_quantized_geometry", GltfExtension::ChangesShape},
    {"WEB3D_quantized_attributes", GltfExtension::ChangesShape},
    {"KHR_accessor_float16", GltfExtension::ChangesShape},
    {"KHR_accessor_float64", GltfExtension::ChangesShape},
    {"EXT_accessor_additional_types", GltfExtension::ChangesShape},
    {"KHR_mesh_primitive_restart", GltfExtension::ChangesShape},
    {"EXT_mesh_primitive_restart", GltfExtension::ChangesShape},
    {"BENTLEY_primitive_restart", GltfExtension::ChangesShape},
    {"KHR_gaussian_splatting_*", GltfExtension::ChangesShape},
    {"KHR_instancing", GltfExtension::ChangesShape},
    {"KHR_implicit_shapes", GltfExtension::ChangesShape},
    {"EXT_implicit_*", GltfExtension::ChangesShape},
    {"EXT_primitive_voxels", GltfExtension::ChangesShape},
    {"EXT_mesh_polygon", GltfExtension::ChangesShape},
    {"EXT_volumetricvideo", GltfExtension::ChangesShape},
    {"KITTYCAD_boundary_representation", GltfExtension::ChangesShape},
    {"FRAUNHOFER_external_model", GltfExtension::ChangesShape},
    {"CESIUM_RTC", GltfExtension::ChangesShape},
    {"CESIUM_z_up", GltfExtension::ChangesShape},
    {"MPEG_accessor_timed", GltfExtension::ChangesShape},
    {"MPEG_buffer_circular", GltfExtension::ChangesShape},
    {"MPEG_mesh_linking", GltfExtension::ChangesShape},
    {"MPEG_gaussian_splatting_transport", GltfExtension::ChangesShape},
    {"ASOBO_asset_optimized", GltfExtension::ChangesShape},

    // Materials.
    {"KHR_materials_*", GltfExtension::LeavesShape},
    {"KHR_techniques_webgl", GltfExtension::LeavesShape},
    {"KHR_technique_webgl", GltfExtension::LeavesShape},
    {"KHR_blend", GltfExtension::LeavesShape},
    {"EXT_blend", GltfExtension::LeavesShape},
    {"EXT_materials_*", GltfExtension::LeavesShape},
    {"EXT_pbr_attributes", GltfExtension::LeavesShape},
    {"EXT_mesh_opacity_micromap", GltfExtension::LeavesShape},
    {"ADOBE_materials_*", GltfExtension::LeavesShape},
    {"ADOBE_render_order", GltfExtension::LeavesShape},
    {"ASOBO_material_*", GltfExtension::LeavesShape},
    {"ASOBO_normal_map_convention", GltfExtension::LeavesShape},
    {"BENTLEY_materials_*", GltfExtension::LeavesShape},
    {"FB_material_*", GltfExtension::LeavesShape},
    {"FB_materials_*", GltfExtension::LeavesShape},
    {"GOOGLE_tilt_brush_*", GltfExtension::LeavesShape},
    {"MOZ_alt_materials", GltfExtension::LeavesShape},
    {"MSFT_packing_*", GltfExtension::LeavesShape},
    {"NEEDLE_techniques_webgl", GltfExtension::LeavesShape},
    {"NV_materials_*", GltfExtension::LeavesShape},
    {"VRMC_*", GltfExtension::LeavesShape},

    // Images.
    {"KHR_texture_*", GltfExtension::LeavesShape},
    {"KHR_image_*", GltfExtension::LeavesShape},
    {"EXT_texture_*", GltfExtension::LeavesShape},
    {"EXT_textureInfo_*", GltfExtension::LeavesShape},
    {"EXT_image_*", GltfExtension::LeavesShape},
    {"GOOGLE_texture_basis", GltfExtension::LeavesShape},
    {"MPEG_texture_video", GltfExtension::LeavesShape},
    {"MOZ_texture_rgbe", GltfExtension::LeavesShape},
    {"MSFT_texture_dds", GltfExtension::LeavesShape},
    {"MAXAR_image_ortho", GltfExtension::LeavesShape},

    // Lights and rendering.
    {"KHR_lights*", GltfExtension::LeavesShape},
    {"KHR_environment_map", GltfExtension::LeavesShape},
    {"KHR_displayencoding*", GltfExtension::LeavesShape},
    {"KHR_displaymapping_*", GltfExtension::LeavesShape},
    {"KHR_framebuffer_value_mapping", GltfExtension::LeavesShape},
    {"KHR_image_formation", GltfExtension::LeavesShape},
    {"EXT_lights_*", GltfExtension::LeavesShape},
    {"EXT_camera_physical", GltfExtension::LeavesShape},
    {"EPIC_hdri_backdrops", GltfExtension::LeavesShape},
    {"EPIC_lightmap_textures", GltfExtension::LeavesShape},
    {"GOOGLE_backgrounds", GltfExtension::LeavesShape},
    {"GOOGLE_camera_settings", GltfExtension::LeavesShape},
    {"INTEL_lights_*", GltfExtension::LeavesShape},
    {"MAXAR_temporal_light_traits", GltfExtension::LeavesShape},
    {"MOZ_lightmap", GltfExtension::LeavesShape},
    {"MPEG_lights_*", GltfExtension::LeavesShape},
    {"NEEDLE_lightmaps", GltfExtension::LeavesShape},

    // Data, and other ways to draw the same vertices.
    {"KHR_xmp*", GltfExtension::LeavesShape},
    {"KHR_XMP*", GltfExtension::LeavesShape},
    {"KHR_data_sizes", GltfExtension::LeavesShape},
    {"KHR_gaussian_splatting", GltfExtension::LeavesShape}, // its vertices are points
    {"KHR_mesh_annotation", GltfExtension::LeavesShape},
    {"EXT_3d_metadata", GltfExtension::LeavesShape},
    {"EXT_feature_metadata", GltfExtension::LeavesShape},
    {"EXT_instance_features", GltfExtension::LeavesShape},
    {"EXT_mesh_features", GltfExtension::LeavesShape},
    {"EXT_structural_metadata", GltfExtension::LeavesShape},
    {"EXT_geopose", GltfExtension::LeavesShape},
    {"EXT_manifold", GltfExtension::LeavesShape},
    {"EXT_mesh_manifold", GltfExtension::LeavesShape},
    {"EXT_mesh_primitive_edge_visibility", GltfExtension::LeavesShape},
    {"AGI_*", GltfExtension::LeavesShape},
    {"ASOBO_tags", GltfExtension::LeavesShape},
    {"ASOBO_unique_id", GltfExtension::LeavesShape},
    {"CESIUM_geopose", GltfExtension::LeavesShape},
    {"CESIUM_primitive_outline", GltfExtension::LeavesShape},
    {"CESIUM_tile_edges", GltfExtension::LeavesShape},
    {"CVTOOLS_unity_metadata", GltfExtension::LeavesShape},
    {"FB_geometry_metadata", GltfExtension::LeavesShape},
    {"FB_ngon_encoding", GltfExtension::LeavesShape},
    {"GODOT_single_root", GltfExtension::LeavesShape},
    {"GRIFFEL_bim_data", GltfExtension::LeavesShape},
    {"NEEDLE_components", GltfExtension::LeavesShape},
    {"NEEDLE_gameobject_data", GltfExtension::LeavesShape},
    {"NEEDLE_persistent_assets", GltfExtension::LeavesShape},

    // Variants: the file's default is shown.
    {"FB_asset_variants", GltfExtension::LeavesShape},
    {"MAXAR_mesh_variants", GltfExtension::LeavesShape},
    {"EPIC_level_variant_sets", GltfExtension::LeavesShape},
    {"MSFT_lod", GltfExtension::LeavesShape},

    // Animation, behaviour, sound and physics: nodes stay where the file has them.
    {"KHR_animation*", GltfExtension::LeavesShape},
    {"KHR_audio*", GltfExtension::LeavesShape},
    {"KHR_avatar*", GltfExtension::LeavesShape},
    {"KHR_behavior", GltfExtension::LeavesShape},
    {"KHR_character*", GltfExtension::LeavesShape},
    {"KHR_collision_shapes", GltfExtension::LeavesShape},
    {"KHR_interactivity", GltfExtension::LeavesShape},
    {"KHR_node_hoverability", GltfExtension::LeavesShape},
    {"KHR_node_selectability", GltfExtension::LeavesShape},
    {"KHR_physics_rigid_bodies", GltfExtension::LeavesShape},
    {"KHR_rigid_bodies", GltfExtension::LeavesShape},
    {"EXT_animation_*", GltfExtension::LeavesShape},
    {"EXT_property_animation", GltfExtension::LeavesShape},
    {"ASOBO_property_animation", GltfExtension::LeavesShape},
    {"DRACO_animation_compression", GltfExtension::LeavesShape},
    {"EPIC_animation_hotspots", GltfExtension::LeavesShape},
    {"HUBS_components", GltfExtension::LeavesShape},
    {"MAXAR_collision_geometry", GltfExtension::LeavesShape},
    {"MOZ_hubs_components", GltfExtension::LeavesShape},
    {"MPEG_anchor", GltfExtension::LeavesShape},
    {"MPEG_animation_timing", GltfExtension::LeavesShape},
    {"MPEG_audio_spatial", GltfExtension::LeavesShape},
    {"MPEG_haptic*", GltfExtension::LeavesShape},
    {"MPEG_media", GltfExtension::LeavesShape},
    {"MSFT_audio_emitter", GltfExtension::LeavesShape},
    {"OMI_*", GltfExtension::LeavesShape},
    {"VRM", GltfExtension::LeavesShape},
};

/// The library that unpacks an extension, and its build option.
struct Unpacker {
    const char *library;
    const char *option;
    bool isThere;
};

Unpacker unpackerOf(std::string_view extension)
{
    return extension == kDracoExtension ? Unpacker{"Draco", "UNPROJECTOR_DRACO", hasDraco()}
                                        : Unpacker{"meshoptimizer", "UNPROJECTOR_MESHOPTIMIZER", hasMeshopt()};
}

bool fits(std::string_view pattern, std::string_view name)
{
    return pattern.ends_with('*') ? name.starts_with(pattern.substr(0, pattern.size() - 1)) : name == pattern;
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

GltfExtension gltfExtension(std::string_view name)
{
    const auto *found = std::find_if(std::begin(kExtensions), std::end(kExtensions),
                                     [name](const Entry &entry) { return fits(entry.name, name); });
    return found == std::end(kExtensions) ? GltfExtension::Unknown : found->meaning;
}

const Json *extensionOf(const Json &object, const char *name)
{
    const Json *extensions = GltfFile::find(object, "extensions");
    return extensions ? GltfFile::find(*extensions, name) : nullptr;
}

void failWithoutLibrary(std::string_view name)
{
    const Unpacker unpacker = unpackerOf(name);
    failUnsupported(
        tr("it needs the glTF extension %1, and this program was built without the library %2, which unpacks it; "
           "build it with -D%3=ON, or export the file without the extension",
           name, unpacker.library, unpacker.option));
}

void checkExtensions(const GltfFile &file, std::vector<base::Note> &notes)
{
    const std::set<std::string> required = namesIn(file, "extensionsRequired");
    for (const std::string &name : required) {
        switch (gltfExtension(name)) {
        case GltfExtension::Read: break;
        case GltfExtension::Unpacked:
            if (!unpackerOf(name).isThere)
                failWithoutLibrary(name);
            break;
        case GltfExtension::LeavesShape:
            notes.push_back({marked("the glTF extension \"%1\", which the file requires, is not applied: the shape is "
                                    "whole without it, but colours, light, motion or data may be missing"),
                             {name}});
            break;
        case GltfExtension::ChangesShape:
            failUnsupported(tr("it needs the glTF extension %1, which is not supported; export it without", name));
        case GltfExtension::Unknown:
            failUnsupported(
                tr("it needs the glTF extension %1, which is not known here and may change the shape; export "
                   "it without",
                   name));
        }
    }
    for (const std::string &name : namesIn(file, "extensionsUsed")) {
        const GltfExtension meaning = gltfExtension(name);
        if (meaning == GltfExtension::ChangesShape || (meaning == GltfExtension::Unpacked && !unpackerOf(name).isThere))
            notes.push_back(
                {marked("the glTF extension \"%1\" is not supported: the shape that the file has without it "
                        "is shown"),
                 {name}});
    }
}

} // namespace unprojector::mesh::reader
