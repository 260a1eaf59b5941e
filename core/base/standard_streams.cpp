#include "core/base/standard_streams.h"

#ifdef _WIN32
#include "core/base/windows_api.h"

#include <cstdio>
#include <tuple>
#endif

namespace unprojector::base {

#ifdef _WIN32
namespace {

/// The kind of a standard stream: FILE_TYPE_DISK, _PIPE, _CHAR (a console or a device) or, for
/// none, _UNKNOWN.
DWORD kindOf(DWORD stream)
{
    const HANDLE handle = GetStdHandle(stream);
    return handle == nullptr || handle == INVALID_HANDLE_VALUE ? FILE_TYPE_UNKNOWN : GetFileType(handle);
}

} // namespace
#endif

Utf8Console::Utf8Console()
{
#ifdef _WIN32
    m_before = GetConsoleOutputCP();
    if (m_before != 0)
        SetConsoleOutputCP(CP_UTF8);
#endif
}

Utf8Console::~Utf8Console()
{
#ifdef _WIN32
    if (m_before != 0)
        SetConsoleOutputCP(m_before);
#endif
}

ParentConsole::ParentConsole()
{
#ifdef _WIN32
    const auto isRedirected = [](DWORD kind) { return kind == FILE_TYPE_DISK || kind == FILE_TYPE_PIPE; };
    // Attaching may give the process the console's standard handles, so the original ones are
    // examined first.
    const DWORD output = kindOf(STD_OUTPUT_HANDLE), errors = kindOf(STD_ERROR_HANDLE);
    m_isAttached = !(isRedirected(output) && isRedirected(errors)) && AttachConsole(ATTACH_PARENT_PROCESS) != 0;
    if (m_isAttached && output == FILE_TYPE_UNKNOWN)
        std::ignore = std::freopen("CONOUT$", "w", stdout);
    if (m_isAttached && errors == FILE_TYPE_UNKNOWN)
        std::ignore = std::freopen("CONOUT$", "w", stderr);
    m_utf8.emplace();
#endif
}

ParentConsole::~ParentConsole()
{
#ifdef _WIN32
    if (!m_isAttached)
        return;
    std::fflush(stdout);
    std::fflush(stderr);
    m_utf8.reset();
    FreeConsole();
#endif
}

} // namespace unprojector::base
