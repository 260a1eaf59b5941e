#include "core/mesh/import/obj_cursor.h"

#include "core/base/text_scanner.h"

#include <charconv>
#include <limits>
#include <optional>
#include <system_error>

namespace unprojector::mesh::reader {
using base::doubleFromWord;

namespace {

constexpr std::int64_t kBeyond32Bits = std::int64_t{1} << 40;

bool isLineEnd(char c)
{
    return c == '\n' || c == '\r';
}

bool isBlank(char c)
{
    return c == ' ' || c == '\t' || c == '\v' || c == '\f';
}

} // namespace

const char *ObjCursor::afterLineEnd(const char *lineEnd) const
{
    const bool isPair = *lineEnd == '\r' && lineEnd + 1 != m_end && lineEnd[1] == '\n';
    return lineEnd + (isPair ? 2 : 1);
}

/// The start of the line that a backslash joins, or null if it joins none.
const char *ObjCursor::afterJoint(const char *backslash) const
{
    const char *at = backslash + 1;
    while (at != m_end && isBlank(*at))
        ++at;
    if (at == m_end)
        return at;
    return isLineEnd(*at) ? afterLineEnd(at) : nullptr;
}

bool ObjCursor::isAtWordEnd(const char *at) const
{
    return at == m_end || isBlank(*at) || isLineEnd(*at) || *at == '#' || (*at == '\\' && afterJoint(at));
}

bool ObjCursor::isAtStatementEnd()
{
    while (m_at != m_end) {
        if (isBlank(*m_at)) {
            ++m_at;
            continue;
        }
        if (*m_at != '\\')
            return isLineEnd(*m_at) || *m_at == '#';
        const char *next = afterJoint(m_at);
        if (!next)
            return false;
        m_lines += next != m_end ? 1 : 0;
        m_at = next;
    }
    return true;
}

void ObjCursor::skipStatement()
{
    while (!isAtStatementEnd()) {
        while (!isAtWordEnd(m_at))
            ++m_at;
    }
    while (m_at != m_end && !isLineEnd(*m_at))
        ++m_at;
    if (m_at != m_end) {
        m_at = afterLineEnd(m_at);
        ++m_lines;
    }
}

std::string_view ObjCursor::word()
{
    if (isAtStatementEnd())
        return {};
    const char *begin = m_at;
    while (!isAtWordEnd(m_at))
        ++m_at;
    return {begin, static_cast<std::size_t>(m_at - begin)};
}

std::string_view ObjCursor::restOfLine()
{
    while (m_at != m_end && isBlank(*m_at))
        ++m_at;
    const char *begin = m_at;
    while (m_at != m_end && !isLineEnd(*m_at))
        ++m_at;
    const char *end = m_at;
    while (end != begin && isBlank(end[-1]))
        --end;
    return {begin, static_cast<std::size_t>(end - begin)};
}

bool ObjCursor::readNumber(double &value)
{
    if (isAtStatementEnd())
        return false;
    const char *begin = m_at;
    if (*begin == '+' && begin + 1 != m_end && begin[1] != '-')
        ++begin;
    const std::from_chars_result result = std::from_chars(begin, m_end, value);
    if (result.ec == std::errc::invalid_argument)
        return false;
    if (result.ec == std::errc() && isAtWordEnd(result.ptr)
        && (result.ptr[-1] != '.' || result.ptr == m_end || *result.ptr != '#')) {
        m_at = result.ptr;
        return true;
    }
    // Out of range; or "1.#IND", whose # begins no comment.
    const char *end = result.ptr;
    while (end != m_end && !isBlank(*end) && !isLineEnd(*end) && !(*end == '#' && end[-1] != '.'))
        ++end;
    const std::optional<double> rare = doubleFromWord({begin, static_cast<std::size_t>(end - begin)});
    if (!rare)
        return false;
    value = *rare;
    m_at = end;
    return true;
}

bool ObjCursor::readInteger(std::int64_t &value)
{
    const char *at = m_at;
    const bool isNegative = at != m_end && *at == '-';
    if (isNegative || (at != m_end && *at == '+'))
        ++at;
    const char *digits = at;
    std::int64_t sum = 0;
    for (; at != m_end && *at >= '0' && *at <= '9'; ++at)
        sum = sum < kBeyond32Bits ? sum * 10 + (*at - '0') : sum;
    if (at == digits)
        return false;
    value = isNegative ? -sum : sum;
    m_at = at;
    return true;
}

bool ObjCursor::readIf(char c)
{
    if (m_at == m_end || *m_at != c)
        return false;
    ++m_at;
    return true;
}

} // namespace unprojector::mesh::reader
