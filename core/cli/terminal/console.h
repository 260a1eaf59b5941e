#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <optional>
#include <string>
#include <vector>

// System functions beyond standard C++ that the command needs. Systems differ here, in the opening
// of streams (byte_stream) and in printed output (files/standard_streams), nowhere else.

namespace unprojector::cli {

/// The program's arguments in UTF-8, its own name first. On Windows main() gets only characters of
/// the code page, so the system's command line is read instead.
std::vector<std::string> utf8Arguments(int argc, char **argv);

/// The languages that the user has chosen for the system's own windows, the preferred first, in the
/// form of LANGUAGE: "zh-CN:en-US". Empty on systems where environment variables give the language.
std::string systemLanguages();

/// True if a stream goes to a terminal.
bool isTerminal(std::FILE *stream);

/// Characters per line of the stream's terminal. 80 where the terminal does not report it, unless
/// COLUMNS does.
std::size_t terminalColumns(std::FILE *stream);

/// The size of the file behind a stream; empty for a pipe, a terminal or a device.
std::optional<std::uint64_t> regularFileSize(std::FILE *stream);

/// Turns off the translation of line ends.
void setBinary(std::FILE *stream);

/// Reads the available bytes and waits only while there are none: fewer bytes than asked for do not
/// mean the end. It bypasses the stream's buffer, so use either this or fread on a stream, not
/// both.
/// @return 0 at the end, empty on an error
std::optional<std::size_t> readAvailable(std::FILE *stream, char *buffer, std::size_t size);

} // namespace unprojector::cli
