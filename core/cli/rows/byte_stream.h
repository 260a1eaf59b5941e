#pragma once

#include "core/cli/terminal/console.h"
#include "core/cli/terminal/exit_code.h"
#include "core/files/replace_file.h"

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace unprojector::cli {

/// A line on stderr, as text::printableLine has it. A progress bar makes way for it.
void complain(std::string_view line);

/// The files that a run reads, or that the scene it reads names, in UTF-8; "-" stands for stdin. No output replaces one of
/// them, under whatever name.
using InputFiles = std::vector<std::string>;

/// Bytes as they are (no line ends translated) from a file, or from stdin for "-".
class ByteSource {
public:
    /// Errors are printed on stderr, and `isOpen` is false.
    explicit ByteSource(const std::string &file);

    bool isOpen() const { return m_file != nullptr; }
    /// The name for messages: the file's, or "stdin".
    const std::string &name() const { return m_name; }
    /// How many bytes there are, where that is known: of a regular file, also as stdin.
    std::optional<std::uint64_t> size() const;
    /// Fills the buffer as far as there is something; fewer bytes than asked for only at the end.
    std::size_t read(char *buffer, std::size_t size);
    /// Gives what there is and waits only while there is nothing, so that results come as soon as their input; 0 only at
    /// the end. A source is read in one of these two ways.
    std::size_t readSome(char *buffer, std::size_t size);
    /// Whether reading stopped at an error, not at the end.
    bool hasFailed() const { return m_hasFailed; }

private:
    struct Close {
        void operator()(std::FILE *file) const;
    };
    std::unique_ptr<std::FILE, Close> m_file;
    std::string m_name;
    bool m_hasFailed = false;
};

/// Bytes as they are to stdout, to a device or a pipe as they come, or to a file, which is replaced when all is written.
/// Whoever reads may go away at any time, as `head` does: that is no error.
class ByteSink {
public:
    enum class State { Open, ReaderGone, Failed };

    /// @param file    UTF-8, "-" for stdout
    /// @param inputs  of this run
    /// Where the file cannot be opened, or is an input, it prints the reason on stderr, and `isOpen` is false.
    ByteSink(const std::string &file, const InputFiles &inputs);

    bool isOpen() const { return m_stream != nullptr || m_file; }
    void write(std::string_view bytes);
    /// Writes a text for people, as text::printableLines has it.
    void print(std::string_view text);
    void flush();
    /// After the last byte: only now does a file take its place. Without it nothing has happened to one that was there.
    /// @return UnusableInput where not all could be written, which stderr has been told
    ExitCode finish();
    State state() const { return m_state; }
    /// Whether somebody reads along.
    bool isTerminal() const;

private:
    struct Close {
        void operator()(std::FILE *file) const;
    };
    void failStream();
    void check(const files::Written &written);

    std::unique_ptr<std::FILE, Close> m_stream;
    std::optional<RemovedWhenInterrupted> m_guard; ///< of the new file, as long as there is one
    std::optional<files::ReplacingFile> m_file;    ///< where there is no stream
    std::string m_name;
    State m_state = State::Open;
};

/// Whether writing an output would destroy one of the inputs, or a file that a model among them names; if so, stderr has been told.
/// @param output  UTF-8; "-" stands for stdout
bool isOverInput(const std::string &output, const InputFiles &inputs);

} // namespace unprojector::cli
