#include "core/files/system_file.h"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <random>
#include <string>
#include <utility>

#ifdef _WIN32
#include "core/files/windows_api.h"
#else
#include <cerrno>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>
#endif

namespace unprojector::files {
namespace {

constexpr int kMostLinks = 40; // as Linux has it

/// Short, so that it fits beside the longest name, and hidden where a dot hides.
std::string randomName()
{
    std::random_device random;
    std::string name = ".unprojector-";
    for (int i = 0; i < 16; ++i)
        name += "0123456789abcdef"[random() % 16];
    return name + ".tmp";
}

/// Where a link points to; nothing where there is no link.
std::optional<std::filesystem::path> linkTarget(const std::filesystem::path &file)
{
    std::error_code error;
    if (!std::filesystem::is_symlink(std::filesystem::symlink_status(file, error)))
        return std::nullopt;
    const std::filesystem::path target = std::filesystem::read_symlink(file, error);
    if (error)
        return std::nullopt;
    return file.parent_path() / target;
}

#ifdef _WIN32
std::error_code lastError()
{
    return {static_cast<int>(GetLastError()), std::system_category()};
}

HANDLE opened(const std::filesystem::path &file, DWORD access)
{
    return CreateFileW(file.c_str(), access, FILE_SHARE_READ | FILE_SHARE_WRITE | FILE_SHARE_DELETE, nullptr,
                       OPEN_EXISTING, FILE_ATTRIBUTE_NORMAL, nullptr);
}
#else
std::error_code lastError()
{
    return {errno, std::system_category()};
}

/// What of a replaced file's permissions the new one may have: none that were meant for an owner or a group that it does
/// not have.
mode_t permissionsAfter(mode_t before, bool isOwnerKept, bool isGroupKept)
{
    mode_t refused = 0;
    if (!isOwnerKept)
        refused |= S_ISUID | S_ISGID;
    if (!isGroupKept)
        refused |= S_ISGID | S_IRWXG;
    return before & mode_t{07777} & ~refused;
}
#endif

} // namespace

FreshFile::FreshFile(FreshFile &&other) noexcept
{
    *this = std::move(other);
}

FreshFile &FreshFile::operator=(FreshFile &&other) noexcept
{
    std::swap(m_path, other.m_path);
#ifdef _WIN32
    std::swap(m_handle, other.m_handle);
#else
    std::swap(m_descriptor, other.m_descriptor);
#endif
    return *this;
}

void FreshFile::remove()
{
    close();
    std::error_code ignored;
    if (!m_path.empty())
        std::filesystem::remove(m_path, ignored);
    m_path.clear();
}

#ifdef _WIN32

std::error_code FreshFile::create(const std::filesystem::path &folder, const std::filesystem::path &)
{
    for (int i = 0; i < 100; ++i) { // the new file gets the folder's rights; a file's attributes are not copied
        const std::filesystem::path path = folder / randomName();
        HANDLE handle = CreateFileW(path.c_str(), GENERIC_WRITE, FILE_SHARE_READ | FILE_SHARE_DELETE, nullptr,
                                    CREATE_NEW, FILE_ATTRIBUTE_NORMAL, nullptr);
        if (handle != INVALID_HANDLE_VALUE) {
            m_path = path;
            m_handle = handle;
            return {};
        }
        if (GetLastError() != ERROR_FILE_EXISTS)
            break;
    }
    return lastError();
}

std::error_code FreshFile::write(std::string_view bytes)
{
    while (!bytes.empty()) {
        DWORD count = 0;
        const auto most = static_cast<DWORD>(std::min(bytes.size(), std::size_t{1} << 30));
        if (WriteFile(m_handle, bytes.data(), most, &count, nullptr) == 0)
            return lastError();
        bytes.remove_prefix(count);
    }
    return {};
}

std::error_code FreshFile::sync()
{
    return FlushFileBuffers(m_handle) == 0 ? lastError() : std::error_code();
}

std::error_code FreshFile::close()
{
    HANDLE handle = std::exchange(m_handle, nullptr);
    return handle != nullptr && CloseHandle(handle) == 0 ? lastError() : std::error_code();
}

std::error_code FreshFile::moveTo(const std::filesystem::path &target)
{
    if (const std::error_code error = close())
        return error;
    if (MoveFileExW(m_path.c_str(), target.c_str(), MOVEFILE_REPLACE_EXISTING | MOVEFILE_WRITE_THROUGH) == 0)
        return lastError();
    m_path.clear();
    return {};
}

std::error_code checkWritable(const std::filesystem::path &file)
{
    HANDLE handle = opened(file, GENERIC_WRITE);
    if (handle == INVALID_HANDLE_VALUE)
        return lastError();
    CloseHandle(handle);
    return {};
}

bool isOwnDescriptor(const std::filesystem::path &)
{
    return false;
}

bool isStream(const std::filesystem::path &file)
{
    HANDLE handle = opened(file, GENERIC_WRITE); // NUL and CON have no entry in any folder
    if (handle == INVALID_HANDLE_VALUE)
        return false;
    const bool isOnDisk = GetFileType(handle) == FILE_TYPE_DISK;
    CloseHandle(handle);
    return !isOnDisk;
}

#else

std::error_code FreshFile::create(const std::filesystem::path &folder, const std::filesystem::path &replaced)
{
    struct stat before {};
    const bool isReplacing = ::stat(replaced.c_str(), &before) == 0;
    // What replaces a private file is private from its first byte on.
    const mode_t mode = isReplacing ? S_IRUSR | S_IWUSR : S_IRUSR | S_IWUSR | S_IRGRP | S_IWGRP | S_IROTH | S_IWOTH;
    for (int i = 0; i < 100 && m_descriptor < 0; ++i) {
        const std::filesystem::path path = folder / randomName();
        m_descriptor = ::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, mode);
        if (m_descriptor >= 0)
            m_path = path;
        else if (errno != EEXIST)
            break;
    }
    if (m_descriptor < 0)
        return lastError();
    if (!isReplacing)
        return {};
    // Who may not give files away keeps them. The group comes first, as another's file cannot be given to one; the
    // permissions last, as a change of owner may clear some.
    const bool isGroupKept = ::fchown(m_descriptor, static_cast<uid_t>(-1), before.st_gid) == 0;
    const bool isOwnerKept = ::fchown(m_descriptor, before.st_uid, static_cast<gid_t>(-1)) == 0;
    const mode_t permissions = permissionsAfter(before.st_mode, isOwnerKept, isGroupKept);
    return ::fchmod(m_descriptor, permissions) == 0 ? std::error_code() : lastError();
}

std::error_code FreshFile::write(std::string_view bytes)
{
    while (!bytes.empty()) {
        const ssize_t count = ::write(m_descriptor, bytes.data(), bytes.size());
        if (count < 0 && errno != EINTR)
            return lastError();
        bytes.remove_prefix(static_cast<std::size_t>(std::max(count, ssize_t{0})));
    }
    return {};
}

std::error_code FreshFile::sync()
{
    while (::fsync(m_descriptor) != 0) {
        if (errno != EINTR)
            return lastError();
    }
    return {};
}

std::error_code FreshFile::close()
{
    const int descriptor = std::exchange(m_descriptor, -1);
    return descriptor >= 0 && ::close(descriptor) != 0 && errno != EINTR ? lastError() : std::error_code();
}

std::error_code FreshFile::moveTo(const std::filesystem::path &target)
{
    if (const std::error_code error = close())
        return error;
    if (::rename(m_path.c_str(), target.c_str()) != 0)
        return lastError();
    // The new name is on the disk when its folder is. Some file systems cannot be told so, and the file is there anyway.
    const std::filesystem::path folder = m_path.parent_path();
    m_path.clear();
    const int descriptor = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (descriptor >= 0) {
        ::fsync(descriptor);
        ::close(descriptor);
    }
    return {};
}

std::error_code checkWritable(const std::filesystem::path &file)
{
    return ::faccessat(AT_FDCWD, file.c_str(), W_OK, AT_EACCESS) == 0 ? std::error_code() : lastError();
}

bool isOwnDescriptor(const std::filesystem::path &file)
{
    std::error_code error;
    std::optional<std::filesystem::path> at = std::filesystem::absolute(file, error);
    for (int i = 0; i < kMostLinks && at && !error; ++i) {
        const std::filesystem::path folder = std::filesystem::canonical(at->parent_path(), error);
        if (folder == "/dev/fd" || folder == "/proc/" + std::to_string(::getpid()) + "/fd")
            return true;
        at = linkTarget(*at);
    }
    return false;
}

bool isStream(const std::filesystem::path &file)
{
    std::error_code error;
    const std::filesystem::file_status status = std::filesystem::status(file, error);
    return isOwnDescriptor(file)
           || (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status)
               && !std::filesystem::is_directory(status));
}

#endif

std::filesystem::path behindLinks(std::filesystem::path file, std::error_code &error)
{
    error.clear();
    for (int i = 0; i < kMostLinks; ++i) {
        const std::optional<std::filesystem::path> target = linkTarget(file);
        if (!target)
            return file;
        file = *target;
    }
    error = std::make_error_code(std::errc::too_many_symbolic_link_levels);
    return file;
}

} // namespace unprojector::files
