#include "core/cli/terminal/console.h"

#include "core/base/text_scanner.h"

#include <cerrno>
#include <cstdlib>

#include <sys/stat.h>

#ifdef _WIN32
#include "core/base/windows_api.h"

#include <fcntl.h>
#include <io.h>
#include <shellapi.h>
#else
#include <sys/ioctl.h>
#include <unistd.h>
#endif

namespace unprojector::cli {
namespace {

#ifdef _WIN32
std::string utf8(const wchar_t *text)
{
    const int length = static_cast<int>(std::wcslen(text));
    const int size = WideCharToMultiByte(CP_UTF8, 0, text, length, nullptr, 0, nullptr, nullptr);
    std::string result(static_cast<std::size_t>(size), '\0');
    WideCharToMultiByte(CP_UTF8, 0, text, length, result.data(), size, nullptr, nullptr);
    return result;
}

HANDLE handleOf(std::FILE *stream)
{
    return reinterpret_cast<HANDLE>(_get_osfhandle(_fileno(stream)));
}
#endif

/// The column count of the terminal itself; 0 if it does not report one.
std::size_t columnsOf([[maybe_unused]] std::FILE *stream)
{
#ifdef _WIN32
    CONSOLE_SCREEN_BUFFER_INFO info;
    if (GetConsoleScreenBufferInfo(handleOf(stream), &info) != 0 && info.srWindow.Right >= info.srWindow.Left)
        return static_cast<std::size_t>(info.srWindow.Right - info.srWindow.Left + 1);
#elif defined(TIOCGWINSZ)
    winsize size{};
    if (ioctl(fileno(stream), TIOCGWINSZ, &size) == 0)
        return size.ws_col;
#endif
    return 0;
}

} // namespace

std::vector<std::string> utf8Arguments(int argc, char **argv)
{
#ifdef _WIN32
    int count = 0;
    wchar_t **words = CommandLineToArgvW(GetCommandLineW(), &count);
    if (words != nullptr) {
        std::vector<std::string> arguments;
        for (int i = 0; i < count; ++i)
            arguments.push_back(utf8(words[i]));
        LocalFree(words);
        return arguments;
    }
#endif
    return std::vector<std::string>(argv, argv + argc);
}

std::string systemLanguages()
{
    std::string languages;
#ifdef _WIN32
    // Each string ends with a 0, the list with another one.
    ULONG count = 0, size = 0;
    if (GetUserPreferredUILanguages(MUI_LANGUAGE_NAME, &count, nullptr, &size) == 0)
        return {};
    std::vector<wchar_t> names(size);
    if (GetUserPreferredUILanguages(MUI_LANGUAGE_NAME, &count, names.data(), &size) == 0)
        return {};
    for (const wchar_t *name = names.data(); *name != L'\0'; name += std::wcslen(name) + 1)
        languages += (languages.empty() ? "" : ":") + utf8(name);
#endif
    return languages;
}

bool isTerminal(std::FILE *stream)
{
#ifdef _WIN32
    DWORD mode = 0; // _isatty also takes the device NUL for a terminal
    return GetConsoleMode(handleOf(stream), &mode) != 0;
#else
    return isatty(fileno(stream)) == 1;
#endif
}

std::size_t terminalColumns(std::FILE *stream)
{
    if (const std::size_t columns = columnsOf(stream); columns > 0)
        return columns;
    constexpr std::size_t kUsual = 80;
    const char *text = std::getenv("COLUMNS");
    const std::size_t columns = base::numberIn<std::size_t>(text != nullptr ? text : "").value_or(0);
    return columns > 0 ? columns : kUsual;
}

std::optional<std::uint64_t> regularFileSize(std::FILE *stream)
{
#ifdef _WIN32
    struct _stat64 status {};
    const bool isKnown = _fstat64(_fileno(stream), &status) == 0 && (status.st_mode & _S_IFMT) == _S_IFREG;
#else
    struct stat status {};
    const bool isKnown = fstat(fileno(stream), &status) == 0 && S_ISREG(status.st_mode);
#endif
    return isKnown ? std::optional(static_cast<std::uint64_t>(status.st_size)) : std::nullopt;
}

void setBinary([[maybe_unused]] std::FILE *stream)
{
#ifdef _WIN32
    _setmode(_fileno(stream), _O_BINARY);
#endif
}

std::optional<std::size_t> readAvailable(std::FILE *stream, char *buffer, std::size_t size)
{
#ifdef _WIN32
    constexpr std::size_t kMost = 1 << 30;
    const int count = _read(_fileno(stream), buffer, static_cast<unsigned>(size < kMost ? size : kMost));
#else
    ssize_t count = -1;
    do
        count = read(fileno(stream), buffer, size);
    while (count < 0 && errno == EINTR);
#endif
    return count < 0 ? std::nullopt : std::optional(static_cast<std::size_t>(count));
}

} // namespace unprojector::cli
