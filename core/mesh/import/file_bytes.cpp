#include "core/mesh/import/file_bytes.h"

#include "core/base/parallel.h"
#include "core/base/system_error.h"
#include "core/base/translation.h"

#include <fstream>
#include <functional>
#include <system_error>

namespace unprojector::mesh::reader {
using base::tr;

namespace {

/// A few milliseconds of work.
constexpr std::size_t kBytesInTask = 4 << 20;

} // namespace

FileBytes::FileBytes(const std::filesystem::path &file, base::Reporter *progress)
{
    std::error_code error;
    const std::filesystem::file_status status = std::filesystem::status(file, error);
    if (error)
        failUnreadable(base::systemErrorText(error));
    // A pipe or a device has no size and may never end.
    if (!std::filesystem::is_regular_file(status))
        failUnreadable(tr("it is a pipe or a device"));
    const std::uintmax_t size = std::filesystem::file_size(file, error);
    if (error || !std::ifstream(file, std::ios::binary))
        failUnreadable();
    m_size = static_cast<std::size_t>(size);
    m_bytes = std::make_unique_for_overwrite<std::uint8_t[]>(m_size);

    const std::function<void(double)> report = progress ? progress->part() : nullptr;
    base::inParallelRanges(m_size, kBytesInTask, report, [&](std::size_t begin, std::size_t end) {
        std::ifstream stream;
        stream.rdbuf()->pubsetbuf(nullptr, 0); // unbuffered: bytes are read directly to their destination
        stream.open(file, std::ios::binary);
        stream.seekg(static_cast<std::streamoff>(begin));
        if (!stream)
            failUnreadable();
        if (stream.read(reinterpret_cast<char *>(m_bytes.get() + begin), static_cast<std::streamsize>(end - begin)))
            return;
        if (stream.eof())
            failMalformed(tr("another program shortened it while it was read; open it again when that is done"));
        failUnreadable();
    });
}

} // namespace unprojector::mesh::reader
