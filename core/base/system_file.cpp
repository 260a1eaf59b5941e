#include "core/base/system_file.h"

#include "core/base/file_stamp.h"
#include "core/base/path_text.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <fstream>
#include <optional>
#include <random>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#ifdef _WIN32
#include "core/base/windows_api.h"
#else
#include <cerrno>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>
#endif

namespace unprojector::base {
namespace {

constexpr int kMostLinks = 40; // as on Linux

// Parts of a fresh file's name. It is short, to fit where the target's name has the greatest
// length, and hidden where a dot hides. The first half of its digits is its lockDomain().
constexpr std::string_view kNameStart = ".unprojector-", kNameEnd = ".tmp", kDigits = "0123456789abcdef";
constexpr std::size_t kNameDigits = 16, kDomainDigits = 8;

/// Names the programs whose locks this one sees: all of one run of Linux, in containers too; elsewhere,
/// those of one computer.
std::string lockDomain()
{
    std::string name;
#ifdef _WIN32
    std::array<wchar_t, MAX_COMPUTERNAME_LENGTH + 1> computer{};
    DWORD length = MAX_COMPUTERNAME_LENGTH + 1;
    if (GetComputerNameW(computer.data(), &length) != 0)
        name = utf8FromPath(computer.data());
#else
    std::ifstream run("/proc/sys/kernel/random/boot_id");
    if (!std::getline(run, name)) {
        std::array<char, 256> computer{};
        if (::gethostname(computer.data(), computer.size() - 1) == 0)
            name = computer.data();
    }
#endif
    return name;
}

/// The start of the names of this program's fresh files.
const std::string &ownStart()
{
    static const std::string start = [] {
        std::uint64_t hash = stampOfContents(lockDomain()).hash;
        std::string name(kNameStart);
        for (std::size_t i = 0; i < kDomainDigits; ++i, hash /= kDigits.size())
            name += kDigits[hash % kDigits.size()];
        return name;
    }();
    return start;
}

std::string randomName()
{
    std::random_device random;
    std::string name = ownStart();
    for (std::size_t i = kDomainDigits; i < kNameDigits; ++i)
        name += kDigits[random() % kDigits.size()];
    return name.append(kNameEnd);
}

bool isRandomName(const std::filesystem::path &path)
{
    const std::filesystem::path::string_type name = path.filename().native(); // may be invalid Unicode
    if (name.size() != kNameStart.size() + kNameDigits + kNameEnd.size())
        return false;
    const auto digits = name.begin() + static_cast<std::ptrdiff_t>(kNameStart.size());
    const auto end = digits + static_cast<std::ptrdiff_t>(kNameDigits);
    return std::equal(kNameStart.begin(), kNameStart.end(), name.begin())
           && std::equal(end, name.end(), kNameEnd.begin()) && std::all_of(digits, end, [](auto c) {
                  return std::find(kDigits.begin(), kDigits.end(), c) != kDigits.end();
              });
}

/// Whether a fresh file's name shows that its program's lock would be seen here.
bool isLockSeen(const std::filesystem::path &path)
{
    const std::filesystem::path::string_type name = path.filename().native();
    return std::equal(ownStart().begin(), ownStart().end(), name.begin());
}

constexpr std::chrono::hours kAbandonedAfter{24};

/// The target of a link; empty if there is no link.
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

/// The permissions of a replaced file that the new one may have: none for an owner or a group that
/// it did not get.
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

/// Removes a file that no program holds.
void removeUnlessHeld(const std::filesystem::path &file)
{
#ifdef _WIN32
    // A program that still writes the file has it open for writing, and this call does not share
    // that access.
    HANDLE handle = CreateFileW(file.c_str(), DELETE, 0, nullptr, OPEN_EXISTING,
                                FILE_FLAG_DELETE_ON_CLOSE | FILE_FLAG_OPEN_REPARSE_POINT, nullptr);
    if (handle != INVALID_HANDLE_VALUE)
        CloseHandle(handle);
#else
    const int descriptor = ::open(file.c_str(), O_RDWR | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
    if (descriptor < 0)
        return;
    if (::flock(descriptor, LOCK_EX | LOCK_NB) == 0)
        ::unlink(file.c_str());
    ::close(descriptor);
#endif
}

} // namespace

void removeAbandonedFiles(const std::filesystem::path &folder)
{
    std::error_code error;
    std::vector<std::filesystem::path> abandoned;
    for (std::filesystem::directory_iterator it(folder, error), end; !error && it != end; it.increment(error)) {
        std::error_code ignored;
        if (!isRandomName(it->path()) || !std::filesystem::is_regular_file(it->symlink_status(ignored)))
            continue;
        const std::filesystem::file_time_type written = std::filesystem::last_write_time(it->path(), ignored);
        if (isLockSeen(it->path())
            || (!ignored && std::filesystem::file_time_type::clock::now() - written > kAbandonedAfter))
            abandoned.push_back(it->path());
    }
    for (const std::filesystem::path &file : abandoned)
        removeUnlessHeld(file);
}

void keepToOwner([[maybe_unused]] const std::filesystem::path &path)
{
#ifndef _WIN32
    using std::filesystem::perms;
    std::error_code ignored; // some file systems have no permissions
    std::filesystem::permissions(path, perms::group_all | perms::others_all, std::filesystem::perm_options::remove,
                                 ignored);
#endif
}

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
    std::swap(m_permissions, other.m_permissions);
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
    // The file stays open until it has its name, so that no other program removes it. sync() has put
    // all its data on the disk.
    if (MoveFileExW(m_path.c_str(), target.c_str(), MOVEFILE_REPLACE_EXISTING | MOVEFILE_WRITE_THROUGH) == 0)
        return lastError();
    close();
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
    // A new file is created with the permissions from the folder and the user's mask; they are
    // restored when it is moved.
    const mode_t mode = isReplacing ? S_IRUSR | S_IWUSR : S_IRUSR | S_IWUSR | S_IRGRP | S_IWGRP | S_IROTH | S_IWOTH;
    struct stat made {};
    for (int i = 0; i < 100 && m_descriptor < 0; ++i) {
        const std::filesystem::path path = folder / randomName();
        m_descriptor = ::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, mode);
        if (m_descriptor < 0 && errno != EEXIST)
            break;
        if (m_descriptor < 0)
            continue;
        m_path = path;
        // Another program's removeAbandonedFiles may have found the file before it was locked. Where
        // there are no locks, nothing is removed.
        const bool isTaken = ::flock(m_descriptor, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK;
        if (isTaken || ::lstat(path.c_str(), &made) != 0)
            remove();
    }
    if (m_descriptor < 0 || ::fstat(m_descriptor, &made) != 0)
        return lastError();
    m_permissions = made.st_mode & mode_t{07777};
    if (isReplacing) {
        // A user who may not give files away stays the owner. The group comes first, because
        // another user's file cannot be given to a group. The permissions come last, because a
        // change of owner may clear some.
        const bool isGroupKept = ::fchown(m_descriptor, static_cast<uid_t>(-1), before.st_gid) == 0;
        const bool isOwnerKept = ::fchown(m_descriptor, before.st_uid, static_cast<gid_t>(-1)) == 0;
        m_permissions = permissionsAfter(before.st_mode, isOwnerKept, isGroupKept);
    }
    ::fchmod(m_descriptor, S_IRUSR | S_IWUSR); // not all file systems have permissions
    return {};
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
    struct stat now {};
    if (::fstat(m_descriptor, &now) != 0)
        return lastError();
    if ((now.st_mode & mode_t{07777}) != m_permissions
        && ::fchmod(m_descriptor, static_cast<mode_t>(m_permissions)) != 0)
        return lastError();
    // The lock is held until the file has its name, so that no other program removes it. sync() has
    // put all its data on the disk.
    if (::rename(m_path.c_str(), target.c_str()) != 0)
        return lastError();
    close();
    // The new name is on the disk when its folder is. Some file systems cannot sync a folder; the
    // file is there anyway.
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

} // namespace unprojector::base
