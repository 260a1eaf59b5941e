#pragma once

#include "core/cli/rows/byte_stream.h"

#include <cstddef>
#include <cstdint>
#include <string>

namespace unprojector::cli {

/// Whole lines of a text, some thousand at a time. A row that has line breaks in quotes is in one
/// block.
struct LineBlock {
    std::string text;          ///< ends with a row, including its line end unless the last row has none
    std::size_t firstLine = 1; ///< number of the first one, counted from 1
    bool isOverlong = false;   ///< one line that is too long for a block; `text` is empty
};

/// A message about a line.
struct LineMessage {
    std::size_t line = 0; ///< in its block, counted from 1
    std::string text;
};

/// Cuts a stream of bytes into blocks of whole lines, in memory that does not grow with the stream.
/// Lines are returned as soon as they arrive: a slow stream comes in small blocks. A byte order
/// mark at the start is skipped.
class LineBlocks {
public:
    /// The size limit of a block, in bytes. A longer line is skipped. If a row with a quote does
    /// not end within the limit, the block is only its first line.
    static constexpr std::size_t kMostBytes = std::size_t(128) * 1024;

    explicit LineBlocks(ByteSource &source) : m_source(source) {}

    /// Reads the next lines; returns false at the end.
    /// @param isOne  reads one line alone
    bool next(LineBlock &block, bool isOne = false);
    /// The number of bytes read from the stream.
    std::uint64_t bytesRead() const { return m_bytesRead; }

private:
    void read();
    std::size_t wholeRows() const;
    std::size_t rowsEnd();

    ByteSource &m_source;
    std::string m_pending; ///< read, not yet returned
    std::size_t m_line = 1;
    std::uint64_t m_bytesRead = 0;
    bool m_isAtEnd = false;
    bool m_hasStarted = false;
};

} // namespace unprojector::cli
