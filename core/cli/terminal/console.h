#pragma once

#include <cstddef>
#include <cstdint>
#ifndef _WIN32
#include <csignal>
#endif
#include <cstdio>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

// What the command asks of the system beyond standard C++; the only place where systems differ, besides the opening of
// streams (byte_stream) and what is printed (files/standard_streams).

namespace unprojector::cli {

/// The program's arguments in UTF-8, its own name first. Windows hands main() those that its code page has letters for;
/// there the command line is asked for instead.
std::vector<std::string> utf8Arguments(int argc, char **argv);

/// The languages that the user has chosen for the system's own windows, the preferred first, as LANGUAGE has them:
/// "zh-CN:en-US". Empty on systems where environment variables say it.
std::string systemLanguages();

/// While it lives, a file goes away when somebody ends the program: with Ctrl+C, with kill, by closing its terminal. One at
/// a time.
class RemovedWhenInterrupted {
public:
    explicit RemovedWhenInterrupted(const std::filesystem::path &file);
    ~RemovedWhenInterrupted();
    RemovedWhenInterrupted(const RemovedWhenInterrupted &) = delete;
    RemovedWhenInterrupted &operator=(const RemovedWhenInterrupted &) = delete;
};

/// While it lives, this thread hears of no such end; it comes afterwards. So that a file which must be removed can be made
/// and named in one step. Windows tells of it on a thread of its own, and cannot wait.
class InterruptionsWait {
public:
    InterruptionsWait();
    ~InterruptionsWait();
    InterruptionsWait(const InterruptionsWait &) = delete;
    InterruptionsWait &operator=(const InterruptionsWait &) = delete;

#ifndef _WIN32
private:
    sigset_t m_before;
#endif
};

/// Whether somebody sees at once what is written to a stream.
bool isTerminal(std::FILE *stream);

/// Characters to a line of the terminal that a stream goes to; 80 where it does not tell, unless COLUMNS does.
std::size_t terminalColumns(std::FILE *stream);

/// The size of the file behind a stream; nothing for a pipe, a terminal or a device.
std::optional<std::uint64_t> regularFileSize(std::FILE *stream);

/// Bytes as they are, no line ends translated.
void setBinary(std::FILE *stream);

/// Reads what there is, waiting only while there is nothing: fewer bytes than asked for mean no end. Goes past the stream's
/// own buffer, so that a stream is read this way or with fread, not both.
/// @return 0 at the end, nothing at an error
std::optional<std::size_t> readAvailable(std::FILE *stream, char *buffer, std::size_t size);

} // namespace unprojector::cli
