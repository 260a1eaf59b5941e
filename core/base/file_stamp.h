#pragma once

#include <cstdint>
#include <filesystem>
#include <string_view>

namespace unprojector::base {

/// A fingerprint of a file's contents: equal stamps mean equal contents. Touching a file does not
/// change it.
struct FileStamp {
    bool exists = false;
    std::uint64_t size = 0; ///< bytes; 0 also for a folder and an unreadable file
    std::uint64_t hash = 0; ///< of the contents

    friend bool operator==(const FileStamp &, const FileStamp &) = default;
};

/// Reads the whole file. To detect whether a file still has the contents that were read, take the
/// stamp before reading: a change in between then shows.
FileStamp stampOf(const std::filesystem::path &file);

/// The stamp of a file with these bytes.
FileStamp stampOfContents(std::string_view bytes);

/// True if a file is unchanged; reads it only if the size is equal.
bool isAsAt(const FileStamp &stamp, const std::filesystem::path &file);

} // namespace unprojector::base
