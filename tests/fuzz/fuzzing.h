#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

/// What the fuzz targets share. Each hands the fuzzer's bytes to one reader and ends the program where a promise is broken;
/// the sanitizers end it where memory is.
namespace fuzz {

/// Ends the program unless a promise is kept.
void require(bool isKept, const char *promise);

/// A file of the fuzzer's bytes in a folder that no other process has, for readers that take the name of one. It is written
/// over by the next.
/// @param name  without a folder
std::filesystem::path fileOf(const char *name, const std::uint8_t *data, std::size_t size);

/// That folder; it is gone with the process.
const std::filesystem::path &folder();

inline std::string_view text(const std::uint8_t *data, std::size_t size)
{
    return {reinterpret_cast<const char *>(data), size};
}

/// Readers say what is wrong on stderr, some thousand times a second: not here. The sanitizers write past it.
void silence();

} // namespace fuzz
