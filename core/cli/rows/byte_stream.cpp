#include "core/cli/rows/byte_stream.h"

#include "core/base/path_text.h"
#include "core/base/printable.h"
#include "core/base/system_error.h"
#include "core/base/translation.h"
#include "core/mesh/import/named_files.h"

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <filesystem>
#include <limits>
#include <set>
#include <system_error>
#include <utility>

namespace unprojector::cli {
using namespace base;
namespace {

/// Opens a file. Output is appended to what others have written there.
std::FILE *opened(const std::string &file, bool isWriting)
{
#ifdef _WIN32
    return _wfopen(pathFromUtf8(file).c_str(), isWriting ? L"ab" : L"rb");
#else
    return std::fopen(file.c_str(), isWriting ? "ab" : "rb");
#endif
}

/// The path of a file; for "-", the name under which the system has the standard stream.
std::filesystem::path namedPath(const std::string &file, const char *standardStream)
{
    return file == "-" ? std::filesystem::path(standardStream) : pathFromUtf8(file);
}

} // namespace

std::string inputName(const std::string &file)
{
    return file == "-" ? "stdin" : file;
}

std::string outputName(const std::string &file)
{
    return file == "-" ? "stdout" : file;
}

void CloseStream::operator()(std::FILE *file) const
{
    if (file != stdin && file != stdout)
        std::fclose(file);
}

ByteSource::ByteSource(const std::string &file) : m_name(inputName(file))
{
    if (file == "-") {
        setBinary(stdin);
        m_file.reset(stdin);
        return;
    }
    std::error_code ignored;
    if (std::filesystem::is_directory(pathFromUtf8(file), ignored))
        refuse(tr("%1: this is a folder; give a file", file));
    errno = 0;
    m_file.reset(opened(file, false));
    if (!m_file)
        refuse(tr("%1: cannot be read: %2", file, base::systemErrorText(errno)));
}

std::size_t ByteSource::read(char *buffer, std::size_t size)
{
    const std::size_t count = std::fread(buffer, 1, size, m_file.get());
    m_hasFailed = std::ferror(m_file.get()) != 0;
    return count;
}

std::string ByteSource::readAll(std::size_t most)
{
    constexpr std::size_t kPiece = std::size_t{1} << 16;
    std::string text;
    for (std::size_t got = 1; got > 0 && text.size() <= most;) {
        const std::size_t before = text.size();
        text.resize(before + kPiece);
        got = read(text.data() + before, kPiece);
        text.resize(before + got);
    }
    if (m_hasFailed)
        refuse(tr("%1: cannot be read", m_name));
    return text;
}

std::size_t ByteSource::readSome(char *buffer, std::size_t size)
{
    const std::optional<std::size_t> count = readAvailable(m_file.get(), buffer, size);
    m_hasFailed = !count;
    return count.value_or(0);
}

bool ByteSource::seek(std::uint64_t position)
{
#ifdef _WIN32
    return _fseeki64(m_file.get(), static_cast<long long>(position), SEEK_SET) == 0;
#else
    return position <= std::uint64_t{std::numeric_limits<long>::max()}
           && std::fseek(m_file.get(), static_cast<long>(position), SEEK_SET) == 0;
#endif
}

std::optional<std::uint64_t> ByteSource::size() const
{
    return regularFileSize(m_file.get());
}

ByteSink::ByteSink(const std::string &file, const InputFiles &inputs) : m_name(outputName(file))
{
    checkNotInput(file, inputs);
    // Writing to a closed pipe or beyond a limit then fails, and is handled here.
#ifdef SIGPIPE
    std::signal(SIGPIPE, SIG_IGN);
#endif
#ifdef SIGXFSZ
    std::signal(SIGXFSZ, SIG_IGN);
#endif
    if (file == "-") {
        m_stream.reset(stdout);
        setBinary(stdout);
        return;
    }
    const std::filesystem::path path = pathFromUtf8(file);
    if (isStream(path)) {
        errno = 0;
        m_stream.reset(opened(file, true));
        if (!m_stream)
            refuse(tr("%1: cannot be written: %2", file, base::systemErrorText(errno)));
        return;
    }
    Expected<ReplacingFile, base::Error> replacing = ReplacingFile::open(path);
    if (!replacing)
        refuse(file + ": " + replacing.error().text);
    m_file = std::move(replacing).value();
}

bool ByteSink::isTerminal() const
{
    return m_stream != nullptr && cli::isTerminal(m_stream.get());
}

void ByteSink::write(std::string_view bytes)
{
    if (m_state != State::Open)
        return;
    if (m_file)
        check(m_file->write(bytes));
    else if (std::fwrite(bytes.data(), 1, bytes.size(), m_stream.get()) != bytes.size())
        failStream();
}

void ByteSink::print(std::string_view text)
{
    write(base::printableLines(text));
}

void ByteSink::flush()
{
    if (m_state == State::Open && m_stream != nullptr && std::fflush(m_stream.get()) != 0)
        failStream();
}

ExitCode ByteSink::finish()
{
    flush();
    if (m_state == State::Open && m_file)
        check(m_file->commit());
    return m_state == State::Failed ? ExitCode::UnusableInput : ExitCode::Done;
}

void ByteSink::failStream()
{
    const int error = errno;
    bool isReaderGone = error == EPIPE;
#ifdef _WIN32
    // The C library knows some of the system's errors for a closed pipe, and reports the others as
    // invalid.
    isReaderGone = isReaderGone || (error == EINVAL && !regularFileSize(m_stream.get()));
#endif
    m_state = isReaderGone ? State::ReaderGone : State::Failed;
    if (!isReaderGone)
        complain(tr("%1: cannot be written: %2", m_name, base::systemErrorText(error)));
}

void ByteSink::check(const Done &written)
{
    if (written)
        return;
    m_state = State::Failed;
    complain(m_name + ": " + written.error().text);
}

void checkNotInput(const std::string &output, const InputFiles &inputs)
{
    if (output.empty())
        return;
    const std::filesystem::path target = namedPath(output, "/dev/stdout");
    std::error_code error;
    // An empty file contains nothing to destroy. The models are read for the files that they name
    // only if one could be lost.
    const auto size = std::filesystem::file_size(target, error);
    std::set<std::string> known; // several objects of a scene may share a model
    const auto check = [&](const std::string &file) {
        if (known.insert(file).second && isSameFile(target, namedPath(file, "/dev/stdin")))
            refuse(tr("%1: this is the input %2 too and would be destroyed; give another name", outputName(output),
                      inputName(file)));
    };
    std::for_each(inputs.begin(), inputs.end(), check);
    if (error || size == 0)
        return;
    for (const std::string &input : std::set<std::string>(known)) {
        for (const std::filesystem::path &named : mesh::namedFiles(namedPath(input, "/dev/stdin")))
            check(utf8FromPath(named));
    }
}

} // namespace unprojector::cli
