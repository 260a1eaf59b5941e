#include "core/cli/rows/line_blocks.h"

#include "core/cli/rows/csv_line.h"

#include <algorithm>

namespace unprojector::cli {

void LineBlocks::read()
{
    const std::size_t before = m_pending.size();
    m_pending.resize(kMostBytes);
    const std::size_t count = m_source.readSome(m_pending.data() + before, kMostBytes - before);
    m_pending.resize(before + count);
    m_bytesRead += count;
    m_isAtEnd = count == 0;
}

/// The number of bytes read that are complete rows.
std::size_t LineBlocks::wholeRows() const
{
    if (m_pending.find('"') == std::string::npos)
        return m_pending.rfind('\n') + 1; // 0 where there is none
    std::size_t whole = 0;
    for (;;) {
        const RowEnd row = rowEnd(m_pending, whole);
        if (!row.isKnown || row.end == m_pending.size())
            return whole;
        whole = row.end + 1;
    }
}

/// Reads until there is a whole row.
/// @return number of bytes in whole rows: at the end, all bytes; 0 where a line is too long or
///         nothing is left
std::size_t LineBlocks::rowsEnd()
{
    std::size_t end = wholeRows();
    while (end == 0 && !m_isAtEnd && m_pending.size() < kMostBytes) {
        read();
        end = wholeRows();
    }
    if (!m_hasStarted && m_pending.starts_with("\xEF\xBB\xBF")) {
        m_pending.erase(0, 3);
        end -= std::min<std::size_t>(end, 3);
    }
    m_hasStarted = true;
    if (end > 0)
        return end;
    if (const RowEnd row = rowEnd(m_pending, 0); m_isAtEnd && row.isClosed)
        return std::min(row.end + 1, m_pending.size());
    // An unclosed quote spoils its own line only.
    const std::size_t lineEnd = m_pending.find('\n');
    if (lineEnd != std::string::npos)
        return lineEnd + 1;
    return m_isAtEnd ? m_pending.size() : 0;
}

void LineBlocks::take(LineBlock &block, std::size_t size)
{
    block.text.assign(m_pending, 0, size);
    block.firstLine = m_line;
    block.isOverlong = false;
    m_pending.erase(0, size);
    m_line += static_cast<std::size_t>(std::count(block.text.begin(), block.text.end(), '\n'));
}

void LineBlocks::skipLine(LineBlock &block)
{
    block = {{}, m_line++, true};
    std::size_t end = std::string::npos;
    while (end == std::string::npos && !m_isAtEnd) {
        m_pending.clear();
        read();
        end = m_pending.find('\n');
    }
    m_pending.erase(0, end == std::string::npos ? end : end + 1);
}

bool LineBlocks::firstLine(LineBlock &line)
{
    if (rowsEnd() > 0)
        take(line, std::min(m_pending.find('\n'), m_pending.size() - 1) + 1);
    else if (!m_pending.empty())
        skipLine(line);
    else
        return false;
    return true;
}

bool LineBlocks::next(LineBlock &block)
{
    if (const std::size_t size = rowsEnd(); size > 0)
        take(block, size);
    else if (!m_pending.empty())
        skipLine(block);
    else
        return false;
    return true;
}

} // namespace unprojector::cli
