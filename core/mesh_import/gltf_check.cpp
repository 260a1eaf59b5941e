#include "core/mesh_import/mesh_reader.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <limits>
#include <string>
#include <string_view>

namespace unprojector::mesh_import::mesh_reader {

namespace {

using Json = nlohmann::json;

/// assimp's parser and its node reader call themselves for each level, which a deep enough file makes overflow.
constexpr int kDeepestJson = 256;
constexpr std::size_t kDeepestNode = 512;
/// Of an accessor that has no bytes of its own in the file.
constexpr std::uint64_t kMostElementsOutOfNothing = 1 << 26;

constexpr int kPoints = 0;
constexpr std::uint32_t kGlbMagic = 0x46546c67;
constexpr std::uint32_t kJsonChunk = 0x4e4f534a;
constexpr std::uint32_t kBinChunk = 0x004e4942;

std::uint32_t wordAt(std::span<const std::uint8_t> bytes, std::size_t at)
{
    return std::uint32_t{bytes[at]} | std::uint32_t{bytes[at + 1]} << 8 | std::uint32_t{bytes[at + 2]} << 16
           | std::uint32_t{bytes[at + 3]} << 24;
}

void appendWord(std::vector<std::uint8_t> &bytes, std::size_t word)
{
    for (int shift = 0; shift < 32; shift += 8)
        bytes.push_back(static_cast<std::uint8_t>(word >> shift));
}

struct Chunks {
    std::string_view json;
    std::span<const std::uint8_t> binary;
};

Chunks chunksOfGlb(const Source &source)
{
    const std::span<const std::uint8_t> bytes = source.bytes;
    if (bytes.size() < 20 || wordAt(bytes, 0) != kGlbMagic)
        failMalformed("the file does not begin with a GLB header");
    if (wordAt(bytes, 4) != 2)
        failMalformed("the file is GLB version " + std::to_string(wordAt(bytes, 4)) + ", only version 2 can be read");
    if (wordAt(bytes, 8) > bytes.size())
        failMalformed("the header declares " + std::to_string(wordAt(bytes, 8)) + " bytes, the file has "
                      + std::to_string(bytes.size()));
    Chunks chunks;
    for (std::size_t at = 12; at + 8 <= bytes.size();) {
        const std::size_t length = wordAt(bytes, at);
        const std::uint32_t kind = wordAt(bytes, at + 4);
        if (length > bytes.size() - at - 8)
            failMalformed("a chunk of " + std::to_string(length) + " bytes goes beyond the end of the file");
        if (kind == kJsonChunk && chunks.json.empty())
            chunks.json = source.text().substr(at + 8, length);
        else if (kind == kBinChunk && chunks.binary.empty())
            chunks.binary = bytes.subspan(at + 8, length);
        at += 8 + (length + 3) / 4 * 4;
    }
    return chunks;
}

Json parsed(std::string_view text)
{
    // Some writers fill the chunk up with zeros instead of blanks.
    while (!text.empty() && text.back() == '\0')
        text.remove_suffix(1);
    if (text.starts_with("\xef\xbb\xbf"))
        text.remove_prefix(3);
    const auto limitDepth = [](int depth, Json::parse_event_t, Json &) {
        if (depth > kDeepestJson)
            failMalformed("the JSON is nested too deeply");
        return true;
    };
    try {
        return Json::parse(text, limitDepth);
    } catch (const Json::parse_error &error) {
        const std::size_t end = std::min<std::size_t>(error.byte, text.size());
        const auto line = 1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(end), '\n');
        failMalformed("line " + std::to_string(line) + ": the JSON is broken or ends too early");
    }
}

class GltfChecker {
public:
    GltfChecker(Json &root, std::size_t binaryBytes, bool isGlb)
        : m_root(root), m_binaryBytes(binaryBytes), m_isGlb(isGlb)
    {
    }

    void check()
    {
        const Json *asset = find(m_root, "asset");
        const Json *version = asset ? find(*asset, "version") : nullptr;
        if (!version || !version->is_string() || !version->get_ref<const std::string &>().starts_with("2."))
            failMalformed("the file is no glTF version 2");
        checkExtensions();
        const Json &buffers = array("buffers");
        for (std::size_t i = 0; i < buffers.size(); ++i) {
            if (m_isGlb && i == 0 && !find(buffers[i], "uri") && number(buffers[i], "byteLength", 0) > m_binaryBytes)
                failMalformed("the binary chunk is shorter than the buffer");
        }
        for (const Json &view : array("bufferViews"))
            checkView(view);
        for (const Json &accessor : array("accessors"))
            checkAccessor(accessor);
        for (const Json &image : array("images"))
            checkImage(image);
        for (const Json &texture : array("textures")) {
            if (find(texture, "source"))
                reference(texture, "source", "images");
            if (find(texture, "sampler"))
                reference(texture, "sampler", "samplers");
        }
        checkNodes();
        if (array("meshes").empty())
            throw Failure(ImportErrorCode::NoTriangles);
        for (Json &mesh : m_root["meshes"])
            checkMesh(mesh);
        // What moves, deforms or lights a model is not shown: assimp need not read it, nor fail on it.
        for (const char *unused : {"animations", "skins", "cameras", "extras"})
            m_root.erase(unused);
    }

private:
    static const Json *find(const Json &object, const char *key)
    {
        if (!object.is_object())
            failMalformed("something else stands where a JSON object belongs");
        const auto found = object.find(key);
        return found == object.end() ? nullptr : &*found;
    }

    const Json &array(const char *key) const
    {
        static const Json kNone = Json::array();
        const Json *found = find(m_root, key);
        if (found && !found->is_array())
            failMalformed(std::string("\"") + key + "\" is no array");
        return found ? *found : kNone;
    }

    static std::uint64_t number(const Json &object, const char *key, std::uint64_t otherwise)
    {
        const Json *found = find(object, key);
        if (!found)
            return otherwise;
        if (!found->is_number_unsigned() || found->get<std::uint64_t>() > std::numeric_limits<std::uint32_t>::max())
            failMalformed(std::string("\"") + key + "\" is no number of a fitting size");
        return found->get<std::uint64_t>();
    }

    /// The object that `key` refers to by its number in the array `target`.
    const Json &reference(const Json &object, const char *key, const char *target) const
    {
        const std::uint64_t index = number(object, key, std::numeric_limits<std::uint64_t>::max());
        const Json &objects = array(target);
        if (index >= objects.size())
            failMalformed(std::string("\"") + key + "\" refers to number " + std::to_string(index) + " of \"" + target
                          + "\", the file has " + std::to_string(objects.size()));
        return objects[static_cast<std::size_t>(index)];
    }

    void checkExtensions() const
    {
        for (const Json &extension : array("extensionsRequired")) {
            if (extension == "KHR_draco_mesh_compression" || extension == "EXT_meshopt_compression")
                failMalformed("the file needs the glTF extension " + extension.get<std::string>()
                              + ", which is not supported");
        }
    }

    void checkView(const Json &view) const
    {
        const std::uint64_t buffer = number(reference(view, "buffer", "buffers"), "byteLength", 0);
        if (number(view, "byteOffset", 0) + number(view, "byteLength", 0) > buffer)
            failMalformed("a buffer view goes beyond its buffer of " + std::to_string(buffer) + " bytes");
    }

    static std::uint64_t componentBytes(const Json &object)
    {
        switch (number(object, "componentType", 0)) {
        case 5120:
        case 5121: return 1;
        case 5122:
        case 5123: return 2;
        case 5125:
        case 5126: return 4;
        default: failMalformed("an accessor has an unknown component type");
        }
    }

    static std::uint64_t elementBytes(const Json &accessor)
    {
        static constexpr std::pair<const char *, std::uint64_t> kTypes[] = {
            {"SCALAR", 1}, {"VEC2", 2}, {"VEC3", 3}, {"VEC4", 4}, {"MAT2", 4}, {"MAT3", 9}, {"MAT4", 16}};
        const Json *type = find(accessor, "type");
        for (const auto &[name, components] : kTypes) {
            if (type && *type == name)
                return components * componentBytes(accessor);
        }
        failMalformed("an accessor has an unknown type");
    }

    void checkInView(const Json &object, std::uint64_t count, std::uint64_t bytesEach) const
    {
        const Json &view = reference(object, "bufferView", "bufferViews");
        const std::uint64_t stride = std::max(number(view, "byteStride", 0), bytesEach);
        const std::uint64_t bytes = count == 0 ? 0 : stride * (count - 1) + bytesEach;
        if (number(object, "byteOffset", 0) + bytes > number(view, "byteLength", 0))
            failMalformed("an accessor of " + std::to_string(count) + " elements goes beyond its buffer view");
    }

    void checkAccessor(const Json &accessor) const
    {
        const std::uint64_t count = number(accessor, "count", 0);
        const std::uint64_t bytesEach = elementBytes(accessor);
        if (find(accessor, "bufferView"))
            checkInView(accessor, count, bytesEach);
        else if (count > kMostElementsOutOfNothing)
            failMalformed("an accessor declares " + std::to_string(count) + " elements without any bytes");
        if (const Json *sparse = find(accessor, "sparse")) {
            // Left out, assimp takes whatever its memory held.
            if (!find(*sparse, "count"))
                failMalformed("a sparse accessor has no count");
            const std::uint64_t patches = number(*sparse, "count", 0);
            const Json *indices = find(*sparse, "indices");
            const Json *values = find(*sparse, "values");
            if (!indices || !values)
                failMalformed("a sparse accessor lacks its indices or values");
            // assimp steps through its patched, tightly packed copy with the stride of the original.
            if (find(accessor, "bufferView")
                && number(reference(accessor, "bufferView", "bufferViews"), "byteStride", bytesEach) != bytesEach)
                failMalformed("a sparse accessor over interleaved data is not supported");
            checkInView(*indices, patches, componentBytes(*indices));
            checkInView(*values, patches, bytesEach);
        }
    }

    void checkImage(const Json &image) const
    {
        if (find(image, "bufferView"))
            reference(image, "bufferView", "bufferViews");
        const Json *mediaType = find(image, "mimeType");
        const Json *uri = find(image, "uri");
        for (const Json *text : {mediaType, uri}) {
            if (text && !text->is_string())
                failMalformed("an image's media type or address is no text");
        }
        // assimp looks for what follows the slash of a media type, and does not ask whether there is one.
        if (mediaType && mediaType->get_ref<const std::string &>().find('/') == std::string::npos)
            failMalformed("an image has a media type without a slash");
        if (uri) {
            const std::string_view address = uri->get_ref<const std::string &>();
            if (address.starts_with("data:")
                && address.substr(0, address.find_first_of(";,")).find('/') == address.npos)
                failMalformed("an image has a media type without a slash");
        }
    }

    void checkMesh(Json &mesh) const
    {
        const Json *primitives = find(mesh, "primitives");
        if (!primitives || !primitives->is_array())
            failMalformed("a mesh has no primitives");
        for (Json &primitive : mesh["primitives"]) {
            const Json *attributes = find(primitive, "attributes");
            if (!attributes || !attributes->is_object())
                failMalformed("a mesh primitive has no attributes");
            if (find(primitive, "material"))
                reference(primitive, "material", "materials");
            number(primitive, "mode", 0);
            std::uint64_t corners = 0;
            if (find(primitive, "indices")) {
                const Json &indices = reference(primitive, "indices", "accessors");
                corners = number(indices, "count", 0);
                if (*find(indices, "type") != "SCALAR" || number(indices, "componentType", 0) == 5126)
                    failMalformed("the indices of a mesh are no integers");
            }
            if (!find(*attributes, "POSITION")) {
                primitive["mode"] = kPoints;
                continue;
            }
            const Json &positions = reference(*attributes, "POSITION", "accessors");
            if (*find(positions, "type") != "VEC3" || number(positions, "componentType", 0) != 5126)
                failMalformed("the positions of a mesh are not three floats each");
            for (const auto &[name, value] : attributes->items()) {
                const Json &attribute = reference(*attributes, name.c_str(), "accessors");
                if (number(attribute, "count", 0) != number(positions, "count", 0))
                    failMalformed("the attribute " + name + " of a mesh has "
                                  + std::to_string(number(attribute, "count", 0)) + " values for "
                                  + std::to_string(number(positions, "count", 0)) + " vertices");
            }
            if (!find(primitive, "indices"))
                corners = number(positions, "count", 0);
            // assimp subtracts two from a strip's corner count to get its triangle count, zero or not.
            if (corners < 3)
                primitive["mode"] = kPoints;
        }
    }

    void checkNodes() const
    {
        const Json &nodes = array("nodes");
        std::vector<std::size_t> parents(nodes.size(), nodes.size());
        for (std::size_t n = 0; n < nodes.size(); ++n) {
            if (find(nodes[n], "mesh"))
                reference(nodes[n], "mesh", "meshes");
            for (const std::size_t child : nodeList(nodes[n], "children")) {
                if (parents[child] != nodes.size())
                    failMalformed("node " + std::to_string(child) + " has two parents");
                parents[child] = n;
            }
        }
        for (std::size_t n = 0; n < nodes.size(); ++n) {
            std::size_t depth = 0;
            for (std::size_t at = n; at != nodes.size(); at = parents[at]) {
                if (++depth > kDeepestNode)
                    failMalformed("the nodes form a circle or are nested too deeply");
            }
        }
        for (const Json &scene : array("scenes"))
            nodeList(scene, "nodes");
        if (find(m_root, "scene"))
            reference(m_root, "scene", "scenes");
    }

    std::vector<std::size_t> nodeList(const Json &object, const char *key) const
    {
        std::vector<std::size_t> list;
        const Json *found = find(object, key);
        if (!found)
            return list;
        const std::size_t count = array("nodes").size();
        if (!found->is_array())
            failMalformed(std::string("\"") + key + "\" is no array");
        for (const Json &entry : *found) {
            if (!entry.is_number_unsigned() || entry.get<std::uint64_t>() >= count)
                failMalformed(std::string("\"") + key + "\" refers to a node that the file does not have");
            list.push_back(entry.get<std::size_t>());
        }
        return list;
    }

    Json &m_root;
    std::size_t m_binaryBytes;
    bool m_isGlb;
};

} // namespace

std::vector<std::uint8_t> checkedGltf(const Source &source)
{
    const bool isGlb = source.suffix == "glb" || (source.bytes.size() >= 20 && wordAt(source.bytes, 0) == kGlbMagic);
    const Chunks chunks = isGlb ? chunksOfGlb(source) : Chunks{source.text(), {}};
    Json root = parsed(chunks.json);
    GltfChecker(root, chunks.binary.size(), isGlb).check();
    std::string json = root.dump(-1, ' ', false, Json::error_handler_t::replace);
    if (!isGlb)
        return {json.begin(), json.end()};

    json.append((4 - json.size() % 4) % 4, ' ');
    std::vector<std::uint8_t> glb;
    const std::size_t binaryBytes = (chunks.binary.size() + 3) / 4 * 4;
    const std::size_t total = 12 + 8 + json.size() + (binaryBytes > 0 ? 8 + binaryBytes : 0);
    glb.reserve(total);
    for (const std::size_t word : {std::size_t{kGlbMagic}, std::size_t{2}, total, json.size(), std::size_t{kJsonChunk}})
        appendWord(glb, word);
    glb.insert(glb.end(), json.begin(), json.end());
    if (binaryBytes > 0) {
        appendWord(glb, binaryBytes);
        appendWord(glb, kBinChunk);
        glb.insert(glb.end(), chunks.binary.begin(), chunks.binary.end());
        glb.resize(total);
    }
    return glb;
}

} // namespace unprojector::mesh_import::mesh_reader
