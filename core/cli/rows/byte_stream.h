#pragma once

#include "core/base/replace_file.h"
#include "core/cli/terminal/console.h"
#include "core/cli/terminal/exit_code.h"
#include "core/cli/terminal/refusal.h"

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace unprojector::cli {

/// The names of files for messages: "stdin" and "stdout" for "-".
std::string inputName(const std::string &file);
std::string outputName(const std::string &file);

/// The files that a run reads, or that the scene it reads names, in UTF-8; "-" stands for stdin. No
/// output may replace one of them, under any name.
using InputFiles = std::vector<std::string>;

/// Closes a stream that is not a standard one.
struct CloseStream {
    void operator()(std::FILE *file) const;
};
using OpenStream = std::unique_ptr<std::FILE, CloseStream>;

/// Reads bytes unchanged (no line-end translation) from a file, or from stdin for "-".
class ByteSource {
public:
    /// Opens the file; refuses one that cannot be opened.
    explicit ByteSource(const std::string &file);

    /// The name for messages: the file's, or "stdin".
    const std::string &name() const { return m_name; }
    /// The number of bytes where it is known: for a regular file, also as stdin.
    std::optional<std::uint64_t> size() const;
    /// Fills the buffer; returns fewer bytes than asked for only at the end.
    std::size_t read(char *buffer, std::size_t size);
    /// Reads to the end, or until it has more than `most` bytes. Refuses what cannot be read.
    std::string readAll(std::size_t most);
    /// Returns the available bytes and waits only while there are none, so that results follow
    /// their input at once. Returns 0 only at the end. A source is read either with this function
    /// or with `read`, not with both.
    std::size_t readSome(char *buffer, std::size_t size);
    /// Moves to a position from the start, for files whose size is known.
    bool seek(std::uint64_t position);
    /// True if reading stopped at an error, not at the end.
    bool hasFailed() const { return m_hasFailed; }

private:
    OpenStream m_file;
    std::string m_name;
    bool m_hasFailed = false;
};

/// Writes bytes unchanged: to stdout, to a device or pipe at once, or to a file that is replaced
/// when all is written. A reader may close the pipe at any time, as `head` does: that is no error.
class ByteSink {
public:
    enum class State { Open, ReaderGone, Failed };

    /// Opens the output; refuses a file that cannot be opened, or is an input.
    /// @param file    UTF-8, "-" for stdout
    /// @param inputs  inputs of this run
    ByteSink(const std::string &file, const InputFiles &inputs);

    void write(std::string_view bytes);
    /// Writes a text for people, formatted by base::printableLines.
    void print(std::string_view text);
    void flush();
    /// Completes the output after the last byte. Only now does the file replace an existing one;
    /// without this call an existing file stays unchanged.
    /// @return UnusableInput where not all could be written; stderr has the reason
    ExitCode finish();
    State state() const { return m_state; }
    /// True if the output goes to a terminal.
    bool isTerminal() const;

private:
    void failStream();
    void check(const base::Done &written);

    OpenStream m_stream;
    std::optional<base::ReplacingFile> m_file; ///< where there is no stream
    std::string m_name;
    State m_state = State::Open;
};

/// Refuses an output that would destroy one of the inputs, or a file that a model among them names.
/// @param output  UTF-8; "-" stands for stdout; empty: there is none
void checkNotInput(const std::string &output, const InputFiles &inputs);

} // namespace unprojector::cli
