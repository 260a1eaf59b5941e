#include "core/mesh_import/file_bytes.h"

// On Windows paths are of wchar_t, which Boost.Interprocess takes since 1.77 only: there files are read.
#ifndef _WIN32
#include <boost/interprocess/file_mapping.hpp>
#include <boost/interprocess/mapped_region.hpp>
#endif

#include <system_error>

namespace unprojector::mesh_import::mesh_reader {

#ifdef _WIN32

struct FileBytes::Mapping {};

FileBytes::FileBytes(const std::filesystem::path &file, ProgressReporter &progress) : m_read(readFile(file, &progress))
{
}

std::span<const std::uint8_t> FileBytes::bytes() const
{
    return m_read;
}

#else

namespace {

/// Below this, reading is as fast, and a file that someone shortens meanwhile does no harm.
constexpr std::uintmax_t kLeastMappedBytes = 4 << 20;

} // namespace

struct FileBytes::Mapping {
    explicit Mapping(const std::filesystem::path &file)
        : mapping(file.c_str(), boost::interprocess::read_only), region(mapping, boost::interprocess::read_only)
    {
    }

    boost::interprocess::file_mapping mapping;
    boost::interprocess::mapped_region region;
};

FileBytes::FileBytes(const std::filesystem::path &file, ProgressReporter &progress)
{
    std::error_code error;
    if (std::filesystem::is_regular_file(file, error) && std::filesystem::file_size(file, error) >= kLeastMappedBytes
        && !error) {
        try {
            m_mapping = std::make_unique<Mapping>(file);
            return;
        } catch (const boost::interprocess::interprocess_exception &) {
            // Some file systems cannot map; reading says what is wrong, if anything is.
        }
    }
    m_read = readFile(file, &progress);
}

std::span<const std::uint8_t> FileBytes::bytes() const
{
    if (!m_mapping)
        return m_read;
    return {static_cast<const std::uint8_t *>(m_mapping->region.get_address()), m_mapping->region.get_size()};
}

#endif

FileBytes::~FileBytes() = default;

} // namespace unprojector::mesh_import::mesh_reader
