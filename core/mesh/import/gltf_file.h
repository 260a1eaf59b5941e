#pragma once

#include "core/mesh/import/file_bytes.h"
#include "core/mesh/import/mesh_reader.h"

#include <nlohmann/json.hpp>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <map>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

namespace unprojector::mesh::reader {

using Json = nlohmann::json;

/// A glTF or GLB file: its JSON, and the bytes that it refers to. All functions throw Damage
/// if the file violates glTF 2.0.
class GltfFile {
public:
    /// @param notes  gets one for each file read outside the model's folder
    /// Throws Damage if the file is neither glTF nor GLB, base::Error for
    /// another version than 2.
    GltfFile(const Source &source, std::vector<base::Note> &notes);

    const Source &source() const { return m_source; }
    const Json &root() const { return m_root; }
    Json &root() { return m_root; }
    /// The files of buffers that were read.
    const std::vector<std::filesystem::path> &bufferFiles() const { return m_bufferFiles; }

    /// The value of an object's key, or null.
    static const Json *find(const Json &object, const char *key);
    /// An array of the file, empty if it has none.
    const Json &array(const char *key) const { return array(m_root, key); }
    static const Json &array(const Json &object, const char *key);
    /// A size or an index; `otherwise` if the key is missing.
    static std::uint64_t number(const Json &object, const char *key, std::uint64_t otherwise);
    /// A number of any kind.
    static double real(const Json &value);
    /// The object that `key` refers to by its index in the array `target`.
    const Json &reference(const Json &object, const char *key, const char *target) const;

    /// The bytes of the buffer view that an object refers to, unpacked if EXT_meshopt_compression
    /// packs them.
    std::span<const std::uint8_t> viewBytes(const Json &object);

    /// Adds unpacked bytes to the file, and an accessor for them. Invalidates references to its
    /// buffers, views and accessors.
    /// @param accessor  without a buffer view
    /// @return the accessor's index
    std::size_t addAccessor(Json accessor, std::vector<std::uint8_t> bytes);

private:
    /// The bytes of a buffer, embedded in the JSON or in a separate file.
    struct Buffer {
        std::vector<std::uint8_t> embedded;
        std::unique_ptr<FileBytes> file;
        std::span<const std::uint8_t> bytes() const { return file ? file->bytes() : embedded; }
    };
    Buffer readBuffer(const std::string &address);
    std::span<const std::uint8_t> bufferBytes(std::uint64_t buffer);
    /// The part of its buffer that a view or its packing refers to.
    std::span<const std::uint8_t> bytesOf(const Json &view);

    const Source &m_source;
    std::vector<base::Note> &m_notes;
    Json m_root;
    bool m_isGlb = false;
    std::span<const std::uint8_t> m_binary;         ///< GLB's chunk
    std::vector<std::unique_ptr<Buffer>> m_buffers; ///< null until read
    std::map<std::uint64_t, std::vector<std::uint8_t>> m_unpackedViews;
    std::vector<std::filesystem::path> m_bufferFiles;
};

/// The contents of a "data:" address; nothing for any other address.
/// Throws Damage if they are broken.
std::optional<std::vector<std::uint8_t>> dataFromUri(std::string_view uri);

} // namespace unprojector::mesh::reader
