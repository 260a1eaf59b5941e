#pragma once

#include "core/mesh_import/mesh_reader.h"

#include <assimp/IOStream.hpp>
#include <assimp/IOSystem.hpp>
#include <assimp/ProgressHandler.hpp>

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace unprojector::mesh_import::mesh_reader {

/// Bytes in memory as a file of assimp's.
class MemoryStream : public Assimp::IOStream {
public:
    explicit MemoryStream(std::span<const std::uint8_t> bytes, ProgressReporter &progress);
    explicit MemoryStream(std::vector<std::uint8_t> owned, ProgressReporter &progress);

    std::size_t Read(void *buffer, std::size_t size, std::size_t count) override;
    std::size_t Write(const void *buffer, std::size_t size, std::size_t count) override;
    aiReturn Seek(std::size_t offset, aiOrigin origin) override;
    std::size_t Tell() const override { return m_at; }
    std::size_t FileSize() const override { return m_bytes.size(); }
    void Flush() override {}

private:
    std::vector<std::uint8_t> m_owned;
    std::span<const std::uint8_t> m_bytes;
    std::size_t m_at = 0;
    ProgressReporter &m_progress;
};

/// assimp's view of the disk: the model under the plain name "model.suffix", so that no file name's encoding or
/// folder matters, and what it refers to.
class AssimpFiles : public Assimp::IOSystem {
public:
    explicit AssimpFiles(const Source &source);

    bool Exists(const char *file) const override;
    char getOsSeparator() const override { return '/'; }
    Assimp::IOStream *Open(const char *file, const char *mode) override;
    void Close(Assimp::IOStream *stream) override;

private:
    bool isModel(const std::string &file) const;
    std::filesystem::path resolved(std::string file) const;

    const Source &m_source;
    std::string m_modelName;
};

/// Passes assimp's progress on; throws Failure (Cancelled) through assimp to stop it, since its importers do not
/// look at what Update returns.
class AssimpProgress : public Assimp::ProgressHandler {
public:
    explicit AssimpProgress(ProgressReporter &progress) : m_progress(progress) {}

    bool Update(float share) override;
    void UpdateFileRead(int step, int count) override;

private:
    ProgressReporter &m_progress;
    int m_lastStep = 0;
};

} // namespace unprojector::mesh_import::mesh_reader
