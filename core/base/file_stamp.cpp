#include "core/base/file_stamp.h"

#include <array>
#include <fstream>
#include <system_error>

namespace unprojector::base {
namespace {

// FNV-1a: fast, and sufficient to detect ordinary changes. It does not protect against a file made
// on purpose with the same hash and length.
constexpr std::uint64_t kHashStart = 14695981039346656037u;

std::uint64_t hashed(std::uint64_t hash, std::string_view bytes)
{
    for (const char byte : bytes)
        hash = (hash ^ static_cast<unsigned char>(byte)) * 1099511628211u;
    return hash;
}

} // namespace

FileStamp stampOf(const std::filesystem::path &file)
{
    std::error_code error;
    const std::filesystem::file_status status = std::filesystem::status(file, error);
    FileStamp stamp{std::filesystem::exists(status)};
    if (!std::filesystem::is_regular_file(status)) // reading a pipe would block
        return stamp;
    std::ifstream stream(file, std::ios::binary);
    if (!stream)
        return stamp;
    std::array<char, 65536> block;
    stamp.hash = kHashStart;
    do {
        stream.read(block.data(), block.size());
        const auto count = static_cast<std::size_t>(stream.gcount());
        stamp.hash = hashed(stamp.hash, {block.data(), count});
        stamp.size += count;
    } while (stream);
    return stamp;
}

FileStamp stampOfContents(std::string_view bytes)
{
    return {true, bytes.size(), hashed(kHashStart, bytes)};
}

bool isAsAt(const FileStamp &stamp, const std::filesystem::path &file)
{
    std::error_code error;
    const std::uintmax_t size = std::filesystem::file_size(file, error);
    return (error || size == stamp.size) && stampOf(file) == stamp;
}

} // namespace unprojector::base
