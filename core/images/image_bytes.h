#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

namespace unprojector::images {

/// The bytes of a file or a stream: in order, or by position where a format needs it. The first
/// ones are kept, to recognise the format.
class ImageBytes {
public:
    /// Fills a buffer; returns fewer bytes than asked for only at the end.
    using Read = std::function<std::size_t(char *, std::size_t)>;
    /// Moves to a position from the start.
    using Seek = std::function<bool(std::uint64_t)>;

    /// @param size  of a file with positions; empty for a stream, which is only read in order
    ImageBytes(Read read, Seek seek, std::optional<std::uint64_t> size);

    /// The first bytes, 4096 at most.
    std::string_view first() const { return std::string_view(m_kept).substr(0, kFirst); }
    /// @return whether there were as many
    bool read(char *target, std::size_t count) { return readSome(target, count) == count; }
    /// @return fewer bytes than asked for only at the end
    std::size_t readSome(char *target, std::size_t count);

    /// Allows to read anywhere: a stream is read to its end and kept in memory.
    /// @pre `read` was not called
    void allowPositions();
    /// The number of bytes. @pre allowPositions() was called
    std::uint64_t size() const { return *m_size; }
    /// Continues `read` at a position: among the first bytes, or anywhere after allowPositions().
    void moveTo(std::uint64_t position) { m_at = position; }
    std::uint64_t position() const { return m_at; }

private:
    static constexpr std::size_t kFirst = 4096;

    Read m_read;
    Seek m_seek;
    std::optional<std::uint64_t> m_size;
    std::string m_kept;           ///< from the start: the first bytes, or all of a stream
    std::uint64_t m_at = 0;       ///< position of `read`
    std::uint64_t m_sourceAt = 0; ///< position of the source
};

} // namespace unprojector::images
