#pragma once

#include <filesystem>
#include <string_view>
#include <system_error>

// System functions for writing files, beyond standard C++: the only file of this folder where
// systems differ.

namespace unprojector::base {

/// A new file with a random name that is not in use yet. The destructor removes it unless moveTo()
/// has moved it. Until then only the user may read it, and a lock tells other programs that it is
/// in use.
class FreshFile {
public:
    FreshFile() = default;
    ~FreshFile() { remove(); }
    FreshFile(FreshFile &&other) noexcept;
    FreshFile &operator=(FreshFile &&other) noexcept;

    /// Creates the file, empty. It never opens an existing file and follows no link.
    /// @param replaced  the file to be replaced. The new file gets its owner and group where the
    ///         system allows it. It gets its permissions, except those for a group or an owner that
    ///         it did not get. If it does not exist, the permissions of any new file apply.
    std::error_code create(const std::filesystem::path &folder, const std::filesystem::path &replaced);
    std::error_code write(std::string_view bytes);
    /// Waits until all written data is on the disk.
    std::error_code sync();
    /// Replaces a file in one step. Call it after sync().
    std::error_code moveTo(const std::filesystem::path &target);
    /// The path; empty while there is no file.
    const std::filesystem::path &path() const { return m_path; }

private:
    std::error_code close();
    void remove();

    std::filesystem::path m_path;
#ifdef _WIN32
    void *m_handle = nullptr;
#else
    int m_descriptor = -1;
    unsigned m_permissions = 0; ///< permissions to set when it is moved
#endif
};

/// Removes the fresh files in a folder that a killed program left behind: files that no program
/// holds. Not every network folder shares locks. So a file of another computer, or of this one before
/// its restart, is removed only if it was not written for a day.
void removeAbandonedFiles(const std::filesystem::path &folder);

/// Removes all permissions except the owner's. On Windows a user's own folders are private anyway.
void keepToOwner(const std::filesystem::path &path);

/// Checks whether this process may write to an existing file.
std::error_code checkWritable(const std::filesystem::path &file);

/// True if a name means a target to write to directly, without contents to replace: a device, a
/// pipe, a socket, or one of the program's own open files of any kind (/dev/stdout).
bool isStream(const std::filesystem::path &file);

/// True if a name means one of the program's own open files, as /dev/stdin and the shell's
/// <(command) do.
bool isOwnDescriptor(const std::filesystem::path &file);

/// The file at the end of a chain of links, whether it exists or not; the path itself if it is no
/// link.
std::filesystem::path behindLinks(std::filesystem::path file, std::error_code &error);

} // namespace unprojector::base
