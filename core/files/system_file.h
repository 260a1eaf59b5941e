#pragma once

#include <filesystem>
#include <string_view>
#include <system_error>

// What writing files asks of the system beyond standard C++: the only place of this folder where systems differ.

namespace unprojector::files {

/// A new file of a random name that belongs to nobody yet. It goes away with this object unless it has been moved to its
/// place. Until then only the user may read it, and the system tells other programs that it is held.
class FreshFile {
public:
    FreshFile() = default;
    ~FreshFile() { remove(); }
    FreshFile(FreshFile &&other) noexcept;
    FreshFile &operator=(FreshFile &&other) noexcept;

    /// Makes it, empty. A file that exists is never opened, and no link is followed.
    /// @param replaced  the file whose place it will take: it gets that one's owner and group, where the system lets it,
    ///                  and its permissions but for what a group or an owner that it did not get may do; none there:
    ///                  those of any new file
    std::error_code create(const std::filesystem::path &folder, const std::filesystem::path &replaced);
    std::error_code write(std::string_view bytes);
    /// Waits until the disk has all that was written.
    std::error_code sync();
    /// Takes a file's place, in one step. After sync().
    std::error_code moveTo(const std::filesystem::path &target);
    /// Empty while there is no file.
    const std::filesystem::path &path() const { return m_path; }

private:
    std::error_code close();
    void remove();

    std::filesystem::path m_path;
#ifdef _WIN32
    void *m_handle = nullptr;
#else
    int m_descriptor = -1;
    unsigned m_permissions = 0; ///< that it gets in its place
#endif
};

/// Removes the fresh files of a folder that a program left behind when it was killed: those that no program holds and that
/// nobody has written to for ten minutes. The time is for what the system cannot tell: a program between making its file
/// and holding it, or on another computer that shares the folder without its locks.
void removeAbandonedFiles(const std::filesystem::path &folder);

/// Takes a file or a folder from all but its owner. Windows keeps what a user's own folders hold so anyway.
void keepToOwner(const std::filesystem::path &path);

/// Whether this process may write to a file that exists.
std::error_code checkWritable(const std::filesystem::path &file);

/// Whether a name means something to write to as it comes, with nothing in it to be replaced: a device, a pipe, a socket,
/// or one of the program's own open files (/dev/stdout), whatever that is.
bool isStream(const std::filesystem::path &file);

/// Whether a name means one of the program's own open files, as /dev/stdin and the shell's <(command) do.
bool isOwnDescriptor(const std::filesystem::path &file);

/// The file that a chain of links ends at, be it there or not; the path itself where it is no link.
std::filesystem::path behindLinks(std::filesystem::path file, std::error_code &error);

} // namespace unprojector::files
