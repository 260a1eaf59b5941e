#pragma once

#include <optional>

// What the programs ask of the system for what they print.

namespace unprojector::files {

/// While it lives, what the program writes to a Windows console is taken for UTF-8. Elsewhere it is anyway.
class Utf8Console {
public:
    Utf8Console();
    ~Utf8Console();
    Utf8Console(const Utf8Console &) = delete;
    Utf8Console &operator=(const Utf8Console &) = delete;

private:
    [[maybe_unused]] unsigned m_before = 0; ///< on Windows: 0, nothing to put back
};

/// While it lives, a program with windows writes into the console that it was started from, in UTF-8. Windows gives such a
/// program no console; streams that go to a file or a pipe stay as they are. Elsewhere they all do.
class ParentConsole {
public:
    ParentConsole();
    ~ParentConsole();
    ParentConsole(const ParentConsole &) = delete;
    ParentConsole &operator=(const ParentConsole &) = delete;

private:
    [[maybe_unused]] bool m_isAttached = false; ///< on Windows
    std::optional<Utf8Console> m_utf8;
};

} // namespace unprojector::files
