#pragma once

#include "core/base/error.h"
#include "core/base/file_stamp.h"
#include "core/base/system_file.h"

#include <filesystem>
#include <optional>
#include <string_view>

namespace unprojector::base {

/// Writes a file through a new one beside it, which replaces it when all is written. After a full
/// disk or a crash the old file is unchanged. For a link, the file behind it is replaced. The
/// permissions stay, except a group's where the new file cannot have that group.
class ReplacingFile {
public:
    /// Creates the new file; the old one stays unchanged until commit().
    /// @return an error for a folder; a stream, see isStream; a read-only file; a missing folder; the
    ///         system's errors. None names the file.
    static Expected<ReplacingFile, Error> open(const std::filesystem::path &file);

    /// @return the system's errors
    Done write(std::string_view bytes);
    /// Waits for the disk and replaces the old file with the new one. Without this call, or if it
    /// fails, the destructor removes the new file.
    /// @param onlyIf  the expected stamp of the old file, so that no other program's work is
    ///         overwritten unnoticed
    /// @return an error of kind Changed; the system's errors
    Done commit(const std::optional<FileStamp> &onlyIf = std::nullopt);

private:
    ReplacingFile() = default;

    std::filesystem::path m_target;
    FreshFile m_fresh;
};

/// Writes a whole file through a ReplacingFile.
Done replaceFile(const std::filesystem::path &file, std::string_view contents,
                 const std::optional<FileStamp> &onlyIf = std::nullopt);

/// True if two names mean the same regular file, through any links and paths. An output that is the
/// same file as an input would destroy it. False for devices, pipes and folders: writing to a
/// device destroys no input.
bool isSameFile(const std::filesystem::path &a, const std::filesystem::path &b);

} // namespace unprojector::base
