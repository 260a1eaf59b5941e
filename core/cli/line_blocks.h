#pragma once

#include "core/cli/byte_stream.h"

#include <cstddef>
#include <string>

namespace unprojector {

/// Whole lines of a text, some thousand at a time.
struct LineBlock {
    std::string text;          ///< ends with a line, its line end included but for a last line that has none
    std::size_t firstLine = 1; ///< number of the first one, counted from 1
    bool isOverlong = false;   ///< stands for one line that no block holds; `text` is empty
};

/// Something to say about a line.
struct LineMessage {
    std::size_t line = 0; ///< in its block, counted from 0
    std::string text;
};

/// Cuts a stream of bytes into blocks of whole lines with a memory that does not grow with the stream. A byte order mark
/// at the start is skipped.
class LineBlocks {
public:
    /// A longer line is passed over as a whole.
    static constexpr std::size_t kMostBytes = 128 * 1024;

    explicit LineBlocks(ByteSource &source) : m_source(source) {}

    /// The first line alone, without its line end; false when there is nothing at all.
    bool firstLine(std::string &line);
    /// The next lines; false at the end.
    bool next(LineBlock &block);

private:
    void fill();
    void take(LineBlock &block, std::size_t size);
    void skipToLineEnd();

    ByteSource &m_source;
    std::string m_pending; ///< read, not yet handed out
    std::size_t m_line = 1;
    bool m_isAtEnd = false;
    bool m_hasStarted = false;
};

} // namespace unprojector
