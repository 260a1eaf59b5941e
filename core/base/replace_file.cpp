#include "core/base/replace_file.h"

#include "core/base/system_error.h"
#include "core/base/translation.h"

#include <system_error>
#include <utility>
#include <variant>

namespace unprojector::base {
namespace {

Error fileError(std::string text)
{
    return {.text = std::move(text), .kind = Error::Kind::File};
}

Error systemError(const std::error_code &error)
{
    return fileError(tr("the file cannot be written%1", tr(" (%1)", systemErrorText(error))));
}

Done checked(const std::error_code &error)
{
    if (error)
        return systemError(error);
    return std::monostate{};
}

/// Checks the target before anything is written.
Done checkTarget(const std::filesystem::path &target)
{
    std::error_code error;
    const std::filesystem::file_status status = std::filesystem::status(target, error);
    if (status.type() == std::filesystem::file_type::none) // not even whether it exists is known
        return systemError(error);
    if (std::filesystem::is_directory(status))
        return fileError(tr("this is a folder; give the name of a file"));
    if (isStream(target))
        return fileError(tr("this is a device or a pipe; give the name of a file"));
    if (!std::filesystem::exists(status)) {
        const std::filesystem::path folder = target.parent_path();
        if (!target.has_filename() || (!folder.empty() && !std::filesystem::exists(folder, error)))
            return fileError(tr("there is no such folder; make it or give another name"));
        return std::monostate{};
    }
    const auto readOnly = [](const std::string &reason) {
        return fileError(tr("the file is read-only%1; allow writing to it or give another name", reason));
    };
    // An administrator may write anything. But a file without any write permission was protected on
    // purpose.
    using std::filesystem::perms;
    if ((status.permissions() & (perms::owner_write | perms::group_write | perms::others_write)) == perms::none)
        return readOnly({});
    if (const std::error_code closed = checkWritable(target))
        return readOnly(tr(" (%1)", systemErrorText(closed)));
    return std::monostate{};
}

} // namespace

Expected<ReplacingFile, Error> ReplacingFile::open(const std::filesystem::path &file)
{
    if (isOwnDescriptor(file)) // the link may lead to a file, but that file is already open
        return fileError(tr("this is a device or a pipe; give the name of a file"));
    std::error_code error;
    ReplacingFile replacing;
    replacing.m_target = behindLinks(file, error);
    if (error)
        return systemError(error);
    if (const Done free = checkTarget(replacing.m_target); !free)
        return free.error();
    const std::filesystem::path folder = replacing.m_target.has_parent_path() ? replacing.m_target.parent_path() : ".";
    removeAbandonedFiles(folder);
    if (const std::error_code failed = replacing.m_fresh.create(folder, replacing.m_target))
        return systemError(failed);
    return replacing;
}

Done ReplacingFile::write(std::string_view bytes)
{
    return checked(m_fresh.write(bytes));
}

Done ReplacingFile::commit(const std::optional<FileStamp> &onlyIf)
{
    if (const std::error_code error = m_fresh.sync())
        return systemError(error);
    if (onlyIf && !isAsAt(*onlyIf, m_target))
        return Error{.text = tr("the file was changed by another program or window since it was opened"),
                     .kind = Error::Kind::Changed};
    return checked(m_fresh.moveTo(m_target));
}

Done replaceFile(const std::filesystem::path &file, std::string_view contents, const std::optional<FileStamp> &onlyIf)
{
    Expected<ReplacingFile, Error> replacing = ReplacingFile::open(file);
    if (!replacing)
        return replacing.error();
    ReplacingFile writing = std::move(replacing).value();
    if (const Done written = writing.write(contents); !written)
        return written.error();
    return writing.commit(onlyIf);
}

bool isSameFile(const std::filesystem::path &a, const std::filesystem::path &b)
{
    std::error_code error;
    return std::filesystem::is_regular_file(a, error) && std::filesystem::is_regular_file(b, error)
           && std::filesystem::equivalent(a, b, error) && !error;
}

} // namespace unprojector::base
