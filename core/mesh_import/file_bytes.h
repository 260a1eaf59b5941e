#pragma once

#include "core/mesh_import/mesh_reader.h"

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <vector>

namespace unprojector::mesh_import::mesh_reader {

/// A regular file's bytes: mapped into memory where it is large and the system can, else read.
class FileBytes {
public:
    /// Throws Failure (NotReadable, Cancelled).
    FileBytes(const std::filesystem::path &file, ProgressReporter &progress);
    ~FileBytes();
    FileBytes(const FileBytes &) = delete;
    FileBytes &operator=(const FileBytes &) = delete;

    std::span<const std::uint8_t> bytes() const;

private:
    struct Mapping;

    std::unique_ptr<Mapping> m_mapping;
    std::vector<std::uint8_t> m_read;
};

} // namespace unprojector::mesh_import::mesh_reader
