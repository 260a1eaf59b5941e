#pragma once

#include <cstdint>
#include <filesystem>
#include <string_view>

namespace unprojector::files {

/// What a file held at some moment: equal stamps are of equal contents. Whoever only touches a file has not changed it.
struct FileStamp {
    bool exists = false;
    std::uint64_t size = 0; ///< bytes; 0 too of a folder and of what cannot be read
    std::uint64_t hash = 0; ///< of the contents

    friend bool operator==(const FileStamp &, const FileStamp &) = default;
};

/// Reads the whole file. To know whether what was read from a file is still what it holds, take the stamp before
/// reading it: what changes in between is then seen as a change.
FileStamp stampOf(const std::filesystem::path &file);

/// The stamp of a file that holds these bytes.
FileStamp stampOfContents(std::string_view bytes);

/// Whether a file is as it was, which asks for reading it only where it still has its size.
bool isAsAt(const FileStamp &stamp, const std::filesystem::path &file);

} // namespace unprojector::files
