#pragma once

#include <optional>

// System functions for the programs' output.

namespace unprojector::base {

/// Makes a Windows console interpret the program's output as UTF-8 while it lives. Other systems do
/// so anyway.
class Utf8Console {
public:
    Utf8Console();
    ~Utf8Console();
    Utf8Console(const Utf8Console &) = delete;
    Utf8Console &operator=(const Utf8Console &) = delete;

private:
    [[maybe_unused]] unsigned m_before = 0; ///< on Windows; 0: nothing to restore
};

/// Connects a program with windows to the console that it was started from, in UTF-8, while it
/// lives. Windows gives such a program no console. Streams to a file or a pipe stay unchanged; on
/// other systems all streams do.
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

} // namespace unprojector::base
