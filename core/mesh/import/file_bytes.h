#pragma once

#include "core/mesh/import/mesh_reader.h"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string_view>

namespace unprojector::mesh::reader {

/// A regular file's bytes, read by all cores. Not memory-mapped: a program that truncates a mapped
/// file crashes its readers.
class FileBytes {
public:
    /// Throws base::Error, base::Stopped.
    explicit FileBytes(const std::filesystem::path &file, base::Reporter *progress = nullptr);

    std::span<const std::uint8_t> bytes() const { return {m_bytes.get(), m_size}; }
    std::string_view text() const { return {reinterpret_cast<const char *>(m_bytes.get()), m_size}; }

private:
    std::size_t m_size = 0;
    std::unique_ptr<std::uint8_t[]> m_bytes;
};

} // namespace unprojector::mesh::reader
