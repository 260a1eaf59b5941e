#pragma once

#include "core/files/file_error.h"
#include "core/files/file_stamp.h"
#include "core/files/system_file.h"

#include <filesystem>
#include <optional>
#include <string_view>

namespace unprojector::files {

/// Writes a file by way of a new one beside it, which takes its place when all is written: whatever happens meanwhile, a
/// full disk or a crash, what was there stays as it was. Of a link it is the file behind it that is replaced; the
/// permissions stay, but for those of a group that the new file cannot have.
class ReplacingFile {
public:
    /// Makes the new file; nothing of the old one is touched before commit().
    /// @return IsDirectory; NotAFile, see isStream; IsReadOnly; NoFolder; System
    static geometry::Result<ReplacingFile, FileError> open(const std::filesystem::path &file);

    /// @return System
    Written write(std::string_view bytes);
    /// Waits for the disk and puts the new file in the old one's place. Without it, or where it fails, the new file goes
    /// away with this object.
    /// @param onlyIf  what the old file must still hold, so that nobody else's work is overwritten unseen
    /// @return ChangedMeanwhile; System
    Written commit(const std::optional<FileStamp> &onlyIf = std::nullopt);
    /// The new file, for whoever must remove it where this object cannot; empty after commit().
    const std::filesystem::path &freshFile() const { return m_fresh.path(); }

private:
    ReplacingFile() = default;

    std::filesystem::path m_target;
    FreshFile m_fresh;
};

/// Writes a whole file by way of a ReplacingFile.
Written replaceFile(const std::filesystem::path &file, std::string_view contents,
                    const std::optional<FileStamp> &onlyIf = std::nullopt);

/// Whether two names mean the same regular file, by whatever links and ways they lead there: an output that is the same
/// file as an input would destroy it. False of devices, pipes and folders: writing to a device destroys no input.
bool isSameFile(const std::filesystem::path &a, const std::filesystem::path &b);

} // namespace unprojector::files
