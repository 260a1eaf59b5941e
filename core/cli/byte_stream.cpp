#include "core/cli/byte_stream.h"

#include "core/cli/console.h"
#include "core/cli/progress_bar.h"
#include "core/files/path_text.h"

#include <cerrno>
#include <csignal>
#include <system_error>

namespace unprojector::cli {
using namespace files;
namespace {

std::FILE *opened(const std::string &file, bool isWriting)
{
#ifdef _WIN32
    return _wfopen(pathFromUtf8(file).c_str(), isWriting ? L"wb" : L"rb");
#else
    return std::fopen(file.c_str(), isWriting ? "wb" : "rb");
#endif
}

} // namespace

void complain(std::string_view line)
{
    std::string text(line);
    text += '\n';
    withoutProgressBar([&text] { std::fwrite(text.data(), 1, text.size(), stderr); });
}

void ByteSource::Close::operator()(std::FILE *file) const
{
    if (file != stdin)
        std::fclose(file);
}

ByteSource::ByteSource(const std::string &file) : m_name(file == "-" ? "stdin" : file)
{
    if (file == "-") {
        setBinary(stdin);
        m_file.reset(stdin);
        return;
    }
    std::error_code ignored;
    if (std::filesystem::is_directory(pathFromUtf8(file), ignored)) {
        complain(file + ": this is a folder; give a file");
        return;
    }
    errno = 0;
    m_file.reset(opened(file, false));
    if (!m_file)
        complain(file + ": cannot be read: " + std::generic_category().message(errno));
}

std::size_t ByteSource::read(char *buffer, std::size_t size)
{
    const std::size_t count = std::fread(buffer, 1, size, m_file.get());
    m_hasFailed = std::ferror(m_file.get()) != 0;
    return count;
}

std::size_t ByteSource::readSome(char *buffer, std::size_t size)
{
    const std::optional<std::size_t> count = readAvailable(m_file.get(), buffer, size);
    m_hasFailed = !count;
    return count.value_or(0);
}

std::optional<std::uint64_t> ByteSource::size() const
{
    return regularFileSize(m_file.get());
}

void ByteSink::Close::operator()(std::FILE *file) const
{
    if (file != stdout)
        std::fclose(file);
}

ByteSink::ByteSink(const std::string &file) : m_name(file == "-" ? "stdout" : file)
{
    if (file != "-") {
        errno = 0;
        m_file.reset(opened(file, true));
        if (!m_file)
            complain(file + ": cannot be written: " + std::generic_category().message(errno));
        return;
    }
    m_file.reset(stdout);
    setBinary(stdout);
#ifdef SIGPIPE
    std::signal(SIGPIPE, SIG_IGN); // writing to a closed pipe then fails, and is seen here
#endif
}

bool ByteSink::isTerminal() const
{
    return cli::isTerminal(m_file.get());
}

void ByteSink::write(std::string_view bytes)
{
    if (m_state == State::Open && std::fwrite(bytes.data(), 1, bytes.size(), m_file.get()) != bytes.size())
        fail();
}

void ByteSink::flush()
{
    if (m_state == State::Open && std::fflush(m_file.get()) != 0)
        fail();
}

void ByteSink::fail()
{
    const int error = errno;
    bool isReaderGone = error == EPIPE;
#ifdef _WIN32
    // The C library knows some of the system's words for a closed pipe, and calls the others invalid.
    isReaderGone = isReaderGone || (error == EINVAL && !regularFileSize(m_file.get()));
#endif
    m_state = isReaderGone ? State::ReaderGone : State::Failed;
    if (!isReaderGone)
        complain(m_name + ": cannot be written: " + std::generic_category().message(error));
}

} // namespace unprojector::cli
