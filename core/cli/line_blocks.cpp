#include "core/cli/line_blocks.h"

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

/// Reads until there is a whole line.
/// @return how many bytes the whole lines have: at the end, everything; 0 where a line is too long or nothing is left
std::size_t LineBlocks::lineEnds()
{
    std::size_t end = m_pending.rfind('\n');
    while (end == std::string::npos && !m_isAtEnd && m_pending.size() < kMostBytes) {
        read();
        end = m_pending.rfind('\n');
    }
    if (!m_hasStarted && m_pending.starts_with("\xEF\xBB\xBF")) {
        m_pending.erase(0, 3);
        end -= end == std::string::npos ? 0 : 3;
    }
    m_hasStarted = true;
    if (end != std::string::npos)
        return end + 1;
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
    if (lineEnds() > 0)
        take(line, std::min(m_pending.find('\n'), m_pending.size() - 1) + 1);
    else if (!m_pending.empty())
        skipLine(line);
    else
        return false;
    return true;
}

bool LineBlocks::next(LineBlock &block)
{
    if (const std::size_t size = lineEnds(); size > 0)
        take(block, size);
    else if (!m_pending.empty())
        skipLine(block);
    else
        return false;
    return true;
}

} // namespace unprojector::cli
