#include "core/cli/line_blocks.h"

#include <algorithm>

namespace unprojector {

void LineBlocks::fill()
{
    const std::size_t before = m_pending.size();
    if (m_isAtEnd || before >= kMostBytes)
        return;
    m_pending.resize(kMostBytes);
    const std::size_t count = m_source.read(m_pending.data() + before, kMostBytes - before);
    m_pending.resize(before + count);
    m_isAtEnd = before + count < kMostBytes;
    if (!m_hasStarted && m_pending.starts_with("\xEF\xBB\xBF"))
        m_pending.erase(0, 3);
    m_hasStarted = true;
}

void LineBlocks::take(LineBlock &block, std::size_t size)
{
    block.text.assign(m_pending, 0, size);
    block.firstLine = m_line;
    block.isOverlong = false;
    m_pending.erase(0, size);
    m_line += static_cast<std::size_t>(std::count(block.text.begin(), block.text.end(), '\n'));
}

void LineBlocks::skipToLineEnd()
{
    for (;;) {
        const std::size_t end = m_pending.find('\n');
        if (end != std::string::npos) {
            m_pending.erase(0, end + 1);
            break;
        }
        m_pending.clear();
        fill();
        if (m_pending.empty())
            break;
    }
    ++m_line;
}

bool LineBlocks::firstLine(std::string &line)
{
    fill();
    if (m_pending.empty())
        return false;
    LineBlock block;
    const std::size_t end = m_pending.find('\n');
    take(block, end == std::string::npos ? m_pending.size() : end + 1);
    line = block.text;
    while (!line.empty() && (line.back() == '\n' || line.back() == '\r'))
        line.pop_back();
    return true;
}

bool LineBlocks::next(LineBlock &block)
{
    fill();
    if (m_pending.empty())
        return false;
    const std::size_t end = m_pending.rfind('\n');
    if (m_isAtEnd) {
        take(block, m_pending.size());
    } else if (end != std::string::npos) {
        take(block, end + 1);
    } else {
        block = {{}, m_line, true};
        skipToLineEnd();
    }
    return true;
}

} // namespace unprojector
