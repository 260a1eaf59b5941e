#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

/// Helpers that the fuzz targets share. Each target hands the fuzzer's bytes to one reader and ends
/// the program when a promise is broken; the sanitizers end it on memory errors.
namespace fuzz {

/// Ends the program unless a promise is kept.
void require(bool isKept, const char *promise);

/// Writes the fuzzer's bytes to a file in a folder of this process alone, for readers that take a
/// file name. The next call overwrites it. @param name  without a folder
std::filesystem::path fileOf(const char *name, const std::uint8_t *data, std::size_t size);

/// The folder of those files; it is removed with the process.
const std::filesystem::path &folder();

inline std::string_view text(const std::uint8_t *data, std::size_t size)
{
    return {reinterpret_cast<const char *>(data), size};
}

/// Silences stderr: readers write their errors there some thousand times a second. The sanitizers
/// bypass this.
void silence();

} // namespace fuzz
