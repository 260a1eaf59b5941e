#pragma once

#include "core/base/printable.h"

#include <QByteArray>
#include <QString>

#include <cerrno>
#include <cstdio>
#include <string>
#include <string_view>
#include <system_error>

namespace unprojector::gui {

/// Readable text for the standard streams: in the locale's encoding, on Windows in UTF-8, as
/// `unproject` writes there; control characters are escaped.
inline QByteArray printed(const QString &text)
{
    const std::string shown = base::printableLines(text.toStdString());
#ifdef Q_OS_WIN
    return QByteArray::fromStdString(shown);
#else
    return QString::fromStdString(shown).toLocal8Bit();
#endif
}

/// Writes a message of the program to standard error.
inline void printMessage(const QString &text)
{
    std::fprintf(stderr, "unprojector: %s\n", printed(text).constData());
}

/// Writes to standard output at once.
/// @return the system's error text, as for a full disk; empty when all is written
inline std::string print(std::string_view text)
{
    errno = 0;
    const bool isWritten = std::fwrite(text.data(), 1, text.size(), stdout) == text.size() && std::fflush(stdout) == 0;
    if (isWritten)
        return {};
    return errno == EBADF || errno == EINVAL ? "it is closed" : std::generic_category().message(errno);
}

} // namespace unprojector::gui
