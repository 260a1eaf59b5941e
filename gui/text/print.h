#pragma once

#include <QByteArray>
#include <QString>

#include <cerrno>
#include <cstdio>
#include <string>
#include <string_view>
#include <system_error>

namespace unprojector::gui {

/// A text as the standard streams take it: in the locale's letters, on Windows in UTF-8, as `unproject` writes there.
inline QByteArray printed(const QString &text)
{
#ifdef Q_OS_WIN
    return text.toUtf8();
#else
    return text.toLocal8Bit();
#endif
}

/// Writes to standard output at once.
/// @return what went wrong, in the system's words, as where the disk is full; empty when all is written
inline std::string print(std::string_view text)
{
    errno = 0;
    const bool isWritten = std::fwrite(text.data(), 1, text.size(), stdout) == text.size() && std::fflush(stdout) == 0;
    if (isWritten)
        return {};
    return errno == EBADF || errno == EINVAL ? "it is closed" : std::generic_category().message(errno);
}

} // namespace unprojector::gui
