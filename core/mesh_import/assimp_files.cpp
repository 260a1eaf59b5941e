#include "core/mesh_import/assimp_files.h"

#include <algorithm>
#include <cstring>

namespace unprojector::mesh_import::mesh_reader {

namespace {

/// The share of assimp's stage that its parsing and its triangulation take; the conversion takes the rest.
constexpr double kParsingShare = 0.6;
constexpr double kProcessingShare = 0.7;
constexpr int kBytesBetweenReports = 1 << 18;

} // namespace

MemoryStream::MemoryStream(std::span<const std::uint8_t> bytes, ProgressReporter &progress)
    : m_bytes(bytes), m_progress(progress)
{
}

MemoryStream::MemoryStream(std::vector<std::uint8_t> owned, ProgressReporter &progress)
    : m_owned(std::move(owned)), m_bytes(m_owned), m_progress(progress)
{
}

std::size_t MemoryStream::Read(void *buffer, std::size_t size, std::size_t count)
{
    m_progress.report(0.0);
    if (size == 0 || count == 0)
        return 0;
    const std::size_t whole = std::min(count, (m_bytes.size() - m_at) / size);
    if (whole > 0)
        std::memcpy(buffer, m_bytes.data() + m_at, whole * size);
    m_at += whole * size;
    return whole;
}

std::size_t MemoryStream::Write(const void *, std::size_t, std::size_t)
{
    return 0;
}

aiReturn MemoryStream::Seek(std::size_t offset, aiOrigin origin)
{
    // Backwards offsets come as large unsigned numbers and wrap round to the right place.
    const std::size_t base = origin == aiOrigin_SET ? 0 : origin == aiOrigin_CUR ? m_at : m_bytes.size();
    const std::size_t target = base + offset;
    if (target > m_bytes.size())
        return aiReturn_FAILURE;
    m_at = target;
    return aiReturn_SUCCESS;
}

AssimpFiles::AssimpFiles(const Source &source) : m_source(source), m_modelName("model." + source.suffix) {}

bool AssimpFiles::isModel(const std::string &file) const
{
    return file == m_modelName || file == "./" + m_modelName;
}

std::filesystem::path AssimpFiles::resolved(std::string file) const
{
    return resolveReference(m_source.file, file);
}

bool AssimpFiles::Exists(const char *file) const
{
    return isModel(file) || !resolved(file).empty();
}

Assimp::IOStream *AssimpFiles::Open(const char *file, const char *)
{
    if (isModel(file))
        return new MemoryStream(m_source.bytes, m_source.progress);
    const std::filesystem::path path = resolved(file);
    if (path.empty())
        return nullptr;
    try {
        return new MemoryStream(readFile(path), m_source.progress);
    } catch (const Failure &) {
        return nullptr;
    }
}

void AssimpFiles::Close(Assimp::IOStream *stream)
{
    delete stream;
}

bool AssimpProgress::Update(float share)
{
    m_progress.report(share > 0.0f ? kParsingShare + (kProcessingShare - kParsingShare) * static_cast<double>(share)
                                   : 0.0);
    return true;
}

void AssimpProgress::UpdateFileRead(int step, int count)
{
    // OBJ's parser calls this for every line or so.
    if (step - m_lastStep < kBytesBetweenReports && step >= m_lastStep)
        return;
    m_lastStep = step;
    m_progress.report(count > 0 ? kParsingShare * step / count : 0.0);
}

} // namespace unprojector::mesh_import::mesh_reader
