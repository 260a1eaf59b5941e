#include "core/mesh/import/gltf_file.h"

#include "core/base/byte_order.h"
#include "core/base/json.h"
#include "core/base/translation.h"
#include "core/mesh/import/gltf_extensions.h"
#include "core/mesh/import/meshopt_view.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <string>

namespace unprojector::mesh::reader {
using base::tr;

namespace {

/// Deep enough for every legitimate file.
constexpr std::size_t kDeepestJson = 256;

constexpr std::uint32_t kGlbMagic = 0x46546c67;
constexpr std::uint32_t kJsonChunk = 0x4e4f534a;
constexpr std::uint32_t kBinChunk = 0x004e4942;

std::uint32_t wordAt(std::span<const std::uint8_t> bytes, std::size_t at)
{
    return base::numberAt<std::uint32_t>(bytes.data() + at);
}

bool isGlb(const Source &source)
{
    return source.suffix == "glb" || (source.bytes.size() >= 20 && wordAt(source.bytes, 0) == kGlbMagic);
}

[[noreturn]] void failOtherVersion(const std::string &version)
{
    failUnsupported(tr("it is glTF %1, and only glTF 2.0 can be read; convert it to glTF 2.0", version));
}

struct Chunks {
    std::string_view json;
    std::span<const std::uint8_t> binary;
};

Chunks chunksOfGlb(const Source &source, std::vector<base::Note> &notes)
{
    std::span<const std::uint8_t> bytes = source.bytes;
    if (bytes.size() < 4 || wordAt(bytes, 0) != kGlbMagic)
        failMalformed(tr("the file does not begin with a GLB header"));
    if (bytes.size() < 20)
        failMalformed(tr("the file ends within the header"));
    if (wordAt(bytes, 4) != 2)
        failOtherVersion(std::to_string(wordAt(bytes, 4)) + ".0");
    const std::size_t declared = wordAt(bytes, 8);
    const auto failOtherSize = [&] {
        failMalformed(tr("the header declares %1 bytes, the file has %2", declared, source.bytes.size()));
    };
    if (declared > bytes.size() || declared < 20)
        failOtherSize();
    noteBytesBehind(notes, bytesThatMean(bytes.subspan(declared)));
    bytes = bytes.first(declared);
    Chunks chunks;
    for (std::size_t at = 12; at + 8 <= bytes.size();) {
        const std::size_t length = wordAt(bytes, at);
        const std::uint32_t kind = wordAt(bytes, at + 4);
        if (length > bytes.size() - at - 8 && length <= source.bytes.size() - at - 8)
            failOtherSize();
        if (length > bytes.size() - at - 8)
            failMalformed(tr("a chunk of %1 bytes goes beyond the end of the file", length));
        if (kind == kJsonChunk && chunks.json.empty())
            chunks.json = source.text().substr(at + 8, length);
        else if (kind == kBinChunk && chunks.binary.empty())
            chunks.binary = bytes.subspan(at + 8, length);
        at += 8 + length;
        // A chunk ends at a multiple of four; some writers omit the padding.
        const std::size_t padded = (at + 3) / 4 * 4;
        const bool isUnpadded = at + 8 <= bytes.size() && wordAt(bytes, at + 4) == kBinChunk;
        if (!isUnpadded)
            at = padded;
    }
    return chunks;
}

/// Returns whether the importer ignores a key's value, so that it may hold anything.
/// @param object  the key whose value is the object that contains the key
bool isUnread(std::string_view object, std::string_view key)
{
    return key == "extras" || key == "asset" || (object == "extensions" && !isReadExtension(key));
}

Json parsed(std::string_view text)
{
    // Some writers pad the chunk with zeros instead of blanks.
    while (!text.empty() && text.back() == '\0')
        text.remove_suffix(1);
    if (text.starts_with("\xef\xbb\xbf"))
        text.remove_prefix(3);
    if (const base::Done valid = base::checkJson(text, kDeepestJson, isUnread); !valid) {
        const base::Error &error = valid.error();
        failMalformed(error.line > 0 ? tr("line %1, column %2: %3", error.line, error.column, error.text) : error.text);
    }
    return Json::parse(text);
}

/// The beginning of a value as in the file, for a message.
std::string written(const Json &value)
{
    constexpr std::size_t kMost = 24;
    const std::string all = value.dump(-1, ' ', true, Json::error_handler_t::replace);
    return all.size() > kMost ? all.substr(0, kMost) + "\xE2\x80\xA6" : all;
}

/// The version of a file: "2.0". Empty if missing.
std::string versionOf(const Json &root)
{
    const Json *asset = GltfFile::find(root, "asset");
    const Json *version = asset ? GltfFile::find(*asset, "version") : nullptr;
    if (version && version->is_string())
        return version->get<std::string>();
    if (version && version->is_number())
        return written(*version);
    // glTF 1.0 does not require a version; its objects have names instead of indices.
    const Json *meshes = GltfFile::find(root, "meshes");
    return meshes && meshes->is_object() ? "1.0" : std::string();
}

/// The values of the digits of base64, by character; 64 for others.
constexpr std::array<std::uint8_t, 256> kBase64 = [] {
    std::array<std::uint8_t, 256> values{};
    values.fill(64);
    std::uint8_t value = 0;
    for (const char c : std::string_view("ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/"))
        values[static_cast<unsigned char>(c)] = value++;
    values['-'] = 62;
    values['_'] = 63;
    return values;
}();

std::vector<std::uint8_t> fromBase64(std::string_view text)
{
    std::vector<std::uint8_t> bytes;
    bytes.reserve(text.size() / 4 * 3);
    std::uint32_t bits = 0;
    int count = 0;
    for (const char c : text) {
        if (c == '=' || c == '\n' || c == '\r' || c == ' ')
            continue;
        const std::uint8_t value = kBase64[static_cast<unsigned char>(c)];
        if (value > 63)
            failMalformed(tr("embedded data is not base64"));
        bits = bits << 6 | value;
        count += 6;
        if (count >= 8) {
            count -= 8;
            bytes.push_back(static_cast<std::uint8_t>(bits >> count));
        }
    }
    return bytes;
}

} // namespace

std::optional<std::vector<std::uint8_t>> dataFromUri(std::string_view uri)
{
    if (!uri.starts_with("data:"))
        return std::nullopt;
    const std::size_t comma = uri.find(',');
    if (comma == uri.npos || !uri.substr(0, comma).ends_with(";base64"))
        failMalformed(tr("embedded data is not base64"));
    return fromBase64(uri.substr(comma + 1));
}

GltfFile::GltfFile(const Source &source, std::vector<base::Note> &notes) : m_source(source), m_notes(notes)
{
    m_isGlb = isGlb(source);
    const Chunks chunks = m_isGlb ? chunksOfGlb(source, m_notes) : Chunks{source.text(), {}};
    m_root = parsed(chunks.json);
    m_binary = chunks.binary;
    const std::string version = versionOf(m_root);
    if (version.empty())
        failMalformed(tr("it names no version of glTF: \"version\" in \"asset\" is missing"));
    if (version.substr(0, version.find('.')) != "2")
        failOtherVersion(version);
    m_buffers.resize(array("buffers").size());
}

const Json *GltfFile::find(const Json &object, const char *key)
{
    if (!object.is_object())
        failMalformed(tr("%1 found where an object with \"%2\" is expected", written(object), key));
    const auto found = object.find(key);
    return found == object.end() ? nullptr : &*found;
}

const Json &GltfFile::array(const Json &object, const char *key)
{
    static const Json kNone = Json::array();
    const Json *found = find(object, key);
    if (found && !found->is_array())
        failMalformed(tr("\"%1\" is %2, which is not an array", key, written(*found)));
    return found ? *found : kNone;
}

std::uint64_t GltfFile::number(const Json &object, const char *key, std::uint64_t otherwise)
{
    const Json *found = find(object, key);
    if (!found)
        return otherwise;
    if (!found->is_number_unsigned() || found->get<std::uint64_t>() > std::numeric_limits<std::uint32_t>::max())
        failMalformed(tr("\"%1\" is %2, which is not a number in range", key, written(*found)));
    return found->get<std::uint64_t>();
}

double GltfFile::real(const Json &value)
{
    if (!value.is_number())
        failMalformed(tr("%1 found where a number is expected", written(value)));
    return value.get<double>();
}

const Json &GltfFile::reference(const Json &object, const char *key, const char *target) const
{
    const std::uint64_t index = number(object, key, std::numeric_limits<std::uint64_t>::max());
    const Json &objects = array(target);
    if (index >= objects.size())
        failMalformed(tr("\"%1\" refers to index %2 of \"%3\", but the length of that array is %4", key, index, target,
                         objects.size()));
    return objects[static_cast<std::size_t>(index)];
}

GltfFile::Buffer GltfFile::readBuffer(const std::string &address)
{
    Buffer buffer;
    if (std::optional<std::vector<std::uint8_t>> embedded = dataFromUri(address)) {
        buffer.embedded = std::move(*embedded);
        return buffer;
    }
    const std::filesystem::path file = resolveReference(m_source.file, address);
    if (file.empty())
        failMalformed(tr("the file \"%1\", which it needs, does not exist", address));
    try {
        buffer.file = std::make_unique<FileBytes>(file);
        m_bufferFiles.push_back(file);
    } catch (const base::Error &) {
        throw base::Error{.text = tr("the file \"%1\", which it needs, cannot be read; check its permissions", address),
                          .kind = base::Error::Kind::File};
    }
    noteIfOutside(m_notes, m_source.file, file, address);
    return buffer;
}

std::span<const std::uint8_t> GltfFile::bufferBytes(std::uint64_t buffer)
{
    const Json &described = array("buffers")[static_cast<std::size_t>(buffer)];
    const Json *uri = find(described, "uri");
    const std::uint64_t declared = number(described, "byteLength", 0);
    auto &slot = m_buffers[static_cast<std::size_t>(buffer)];
    if (!uri && !slot) {
        if (!m_isGlb || buffer != 0)
            failMalformed(tr("buffer %1 has no bytes", buffer));
        if (declared > m_binary.size())
            failMalformed(tr("the binary chunk is shorter than the buffer"));
        return m_binary.first(static_cast<std::size_t>(declared));
    }
    if (uri && !uri->is_string())
        failMalformed(tr("the address of a buffer is not a text"));
    if (!slot)
        slot = std::make_unique<Buffer>(readBuffer(uri->get_ref<const std::string &>()));
    if (declared > slot->bytes().size())
        failMalformed(tr("a buffer of %1 bytes is declared as %2", slot->bytes().size(), declared));
    return slot->bytes().first(static_cast<std::size_t>(declared));
}

std::span<const std::uint8_t> GltfFile::bytesOf(const Json &view)
{
    reference(view, "buffer", "buffers");
    const std::span<const std::uint8_t> buffer = bufferBytes(number(view, "buffer", 0));
    const std::uint64_t offset = number(view, "byteOffset", 0), length = number(view, "byteLength", 0);
    if (offset + length > buffer.size())
        failMalformed(tr("a buffer view goes beyond its buffer of %1 bytes", buffer.size()));
    return buffer.subspan(static_cast<std::size_t>(offset), static_cast<std::size_t>(length));
}

std::span<const std::uint8_t> GltfFile::viewBytes(const Json &object)
{
    const Json &view = reference(object, "bufferView", "bufferViews");
    const Json *packed = extensionOf(view, kMeshoptExtension);
    if (!packed)
        return bytesOf(view);
    if (!hasMeshopt()) {
        // The fallback for the packed bytes may be missing.
        if (!find(reference(view, "buffer", "buffers"), "uri") && (!m_isGlb || number(view, "buffer", 0) != 0))
            failWithoutLibrary(kMeshoptExtension);
        return bytesOf(view);
    }
    const std::uint64_t place = number(object, "bufferView", 0);
    auto unpacked = m_unpackedViews.find(place);
    if (unpacked == m_unpackedViews.end())
        unpacked = m_unpackedViews.emplace(place, unpackedView(view, *packed, bytesOf(*packed))).first;
    return unpacked->second;
}

std::size_t GltfFile::addAccessor(Json accessor, std::vector<std::uint8_t> bytes)
{
    const std::size_t length = bytes.size();
    m_buffers.push_back(std::make_unique<Buffer>());
    m_buffers.back()->embedded = std::move(bytes);
    m_root["buffers"].push_back({{"byteLength", length}});
    m_root["bufferViews"].push_back({{"buffer", m_buffers.size() - 1}, {"byteLength", length}});
    accessor["bufferView"] = m_root["bufferViews"].size() - 1;
    m_root["accessors"].push_back(std::move(accessor));
    return m_root["accessors"].size() - 1;
}

} // namespace unprojector::mesh::reader
