#include "core/mesh/import/gltf_materials.h"

#include "core/base/translation.h"
#include "core/mesh/import/gltf_extensions.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace unprojector::mesh::reader {
using base::marked;
using base::tr;

namespace {

constexpr std::uint64_t kClampToEdge = 33071;

std::optional<glm::vec4> colorOf(const Json &object, const char *key)
{
    const Json &numbers = GltfFile::array(object, key);
    if (numbers.size() < 3)
        return std::nullopt;
    glm::vec4 color(1.0f);
    for (int i = 0; i < std::min(4, static_cast<int>(numbers.size())); ++i)
        color[i] = static_cast<float>(GltfFile::real(numbers[static_cast<std::size_t>(i)]));
    return color;
}

/// The transform of KHR_texture_transform: scale, then rotation, then translation.
glm::dmat3 textureTransform(const Json &transform)
{
    const auto pair = [&transform](const char *key, double otherwise) {
        const Json &numbers = GltfFile::array(transform, key);
        return numbers.size() < 2 ? glm::dvec2(otherwise)
                                  : glm::dvec2(GltfFile::real(numbers[0]), GltfFile::real(numbers[1]));
    };
    const glm::dvec2 offset = pair("offset", 0.0), scale = pair("scale", 1.0);
    const Json *rotation = GltfFile::find(transform, "rotation");
    const double angle = rotation ? GltfFile::real(*rotation) : 0.0;
    const double c = std::cos(angle), s = std::sin(angle);
    return glm::dmat3({c * scale.x, -s * scale.x, 0.0}, {s * scale.y, c * scale.y, 0.0}, {offset.x, offset.y, 1.0});
}

} // namespace

GltfMaterial GltfMaterials::of(const Json &primitive)
{
    if (!GltfFile::find(primitive, "material"))
        return {};
    const Json &described = m_file.reference(primitive, "material", "materials");
    const auto [known, isNew] = m_materials.try_emplace(GltfFile::number(primitive, "material", 0));
    if (!isNew)
        return known->second;
    GltfMaterial material;
    material.baseColor = glm::vec4(1.0f);
    material.hasBaseColor = true;
    const Json *info = nullptr;
    if (const Json *gloss = extensionOf(described, "KHR_materials_pbrSpecularGlossiness")) {
        material.baseColor = colorOf(*gloss, "diffuseFactor").value_or(material.baseColor);
        info = GltfFile::find(*gloss, "diffuseTexture");
    }
    if (const Json *roughness = GltfFile::find(described, "pbrMetallicRoughness")) {
        material.baseColor = colorOf(*roughness, "baseColorFactor").value_or(material.baseColor);
        if (const Json *texture = GltfFile::find(*roughness, "baseColorTexture"))
            info = texture;
    }
    if (info)
        readTexture(*info, material);
    known->second = material;
    return material;
}

void GltfMaterials::readTexture(const Json &textureInfo, GltfMaterial &material)
{
    const std::optional<int> texture = textureNumber(m_file.reference(textureInfo, "index", "textures"));
    if (!texture)
        return;
    material.texture = *texture;
    material.texcoordSet = GltfFile::number(textureInfo, "texCoord", 0);
    if (const Json *transform = extensionOf(textureInfo, "KHR_texture_transform")) {
        material.textureFromTexcoord = textureTransform(*transform);
        material.texcoordSet = GltfFile::number(*transform, "texCoord", material.texcoordSet);
    }
    // Some programs write black beside an image and mean the image alone.
    if (glm::vec3(material.baseColor) == glm::vec3(0.0f))
        material.baseColor = glm::vec4(1.0f, 1.0f, 1.0f, material.baseColor.a);
}

std::optional<int> GltfMaterials::textureNumber(const Json &texture)
{
    bool wrapRepeat = true;
    if (GltfFile::find(texture, "sampler")) {
        const Json &sampler = m_file.reference(texture, "sampler", "samplers");
        wrapRepeat = GltfFile::number(sampler, "wrapS", 0) != kClampToEdge;
    }
    if (!GltfFile::find(texture, "source")) {
        // Unless an extension has it.
        base::addNote(m_model.notes, 1,
                      marked("%1 texture has neither a PNG nor a JPEG image: its surfaces are shown without it"),
                      marked("%1 textures have neither PNG nor JPEG images: their surfaces are shown without them"));
        return std::nullopt;
    }
    const Json &image = m_file.reference(texture, "source", "images");
    const auto [known, isNew] = m_textures.try_emplace({GltfFile::number(texture, "source", 0), wrapRepeat}, 0);
    if (isNew) {
        const Json *uri = GltfFile::find(image, "uri");
        const bool isFile = uri && uri->is_string() && !uri->get_ref<const std::string &>().starts_with("data:");
        if (isFile) {
            known->second = addTexture(m_model, m_file.source().file, uri->get_ref<const std::string &>());
        } else {
            known->second = static_cast<int>(m_model.textures.size());
            m_model.textures.push_back(imageOf(image));
        }
        m_model.textures[static_cast<std::size_t>(known->second)].wrapRepeat = wrapRepeat;
    }
    return known->second;
}

Texture GltfMaterials::imageOf(const Json &image)
{
    Texture texture;
    texture.file = m_file.source().file;
    if (const Json *uri = GltfFile::find(image, "uri")) {
        if (!uri->is_string())
            failMalformed(tr("the address of an image is not a text"));
        texture.encoded = dataFromUri(uri->get_ref<const std::string &>()).value_or(std::vector<std::uint8_t>());
    } else {
        const std::span<const std::uint8_t> bytes = m_file.viewBytes(image);
        texture.encoded.assign(bytes.begin(), bytes.end());
    }
    return texture;
}

} // namespace unprojector::mesh::reader
