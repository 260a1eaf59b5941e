#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

namespace unprojector::cli {

/// A line on stderr. A progress bar makes way for it.
void complain(std::string_view line);

/// Bytes as they are (no line ends translated) from a file, or from stdin for "-".
class ByteSource {
public:
    /// What could not be opened is said on stderr, and `isOpen` is false.
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

/// Bytes as they are to stdout, or to a file. Whoever reads may go away at any time, as `head` does: that is no error.
class ByteSink {
public:
    enum class State { Open, ReaderGone, Failed };

    /// @param file  "-" for stdout; what cannot be opened is said on stderr, and `isOpen` is false
    explicit ByteSink(const std::string &file = "-");

    bool isOpen() const { return m_file != nullptr; }
    void write(std::string_view bytes);
    void flush();
    State state() const { return m_state; }
    /// Whether somebody reads along.
    bool isTerminal() const;

private:
    struct Close {
        void operator()(std::FILE *file) const;
    };
    void fail();

    std::unique_ptr<std::FILE, Close> m_file;
    std::string m_name;
    State m_state = State::Open;
};

} // namespace unprojector::cli
