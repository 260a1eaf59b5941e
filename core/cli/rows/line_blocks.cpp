#include "core/cli/rows/line_blocks.h"

#include "core/base/csv.h"

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
    for (base::CsvReader rows(m_pending, ',', '\n'); rows.nextSource() && rows.isWhole();)
        whole = rows.offset();
    return whole;
}

/// Reads until there is a whole row.
/// @return number of bytes in whole rows: at the end, those of the next row; 0 where a line is too long
///         or nothing is left
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
    // An unclosed quote spoils its own line only.
    base::CsvReader row(m_pending, ',', '\n');
    const bool isLine = row.nextSource() && (m_isAtEnd || m_pending[row.offset() - 1] == '\n');
    return isLine ? row.offset() : 0;
}

bool LineBlocks::next(LineBlock &block, bool isOne)
{
    std::size_t size = rowsEnd();
    if (m_pending.empty())
        return false;
    block.firstLine = m_line;
    block.isOverlong = size == 0;
    if (isOne && size > 0)
        size = std::min(m_pending.find('\n'), m_pending.size() - 1) + 1;
    block.text.assign(m_pending, 0, size);
    m_line += static_cast<std::size_t>(std::count(block.text.begin(), block.text.end(), '\n'));
    if (block.isOverlong) {
        ++m_line;
        for (size = 0; size == 0 && !m_isAtEnd; size = m_pending.find('\n') + 1) {
            m_pending.clear();
            read();
        }
        size = size == 0 ? m_pending.size() : size;
    }
    m_pending.erase(0, size);
    return true;
}

} // namespace unprojector::cli
