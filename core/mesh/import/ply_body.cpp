#include "core/mesh/import/ply_body.h"

#include "core/base/byte_order.h"
#include "core/base/number_text.h"
#include "core/base/parallel.h"
#include "core/base/translation.h"
#include "core/mesh/import/line_ranges.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

namespace unprojector::mesh::reader {
using namespace base;

namespace {

constexpr std::size_t kElementsBetweenReports = 1 << 14;
/// A few milliseconds of work.
constexpr std::size_t kBytesInTask = 1 << 20;

/// The range of an integer type.
std::pair<double, double> integerRange(PlyType type)
{
    const auto count = static_cast<double>(std::uint64_t{1} << (8 * byteCount(type)));
    const bool isSigned = type == PlyType::Int8 || type == PlyType::Int16 || type == PlyType::Int32;
    return isSigned ? std::pair{-count / 2.0, count / 2.0 - 1.0} : std::pair{0.0, count - 1.0};
}

} // namespace

double plyValue(const std::uint8_t *bytes, PlyType type, PlyFormat format)
{
    const std::endian order = orderOf(format);
    switch (type) {
    case PlyType::Int8: return numberAt<std::int8_t>(bytes);
    case PlyType::Int16: return numberAt<std::int16_t>(bytes, order);
    case PlyType::Int32: return numberAt<std::int32_t>(bytes, order);
    case PlyType::Uint8: return *bytes;
    case PlyType::Uint16: return numberAt<std::uint16_t>(bytes, order);
    case PlyType::Uint32: return numberAt<std::uint32_t>(bytes, order);
    case PlyType::Float32: return static_cast<double>(numberAt<float>(bytes, order));
    case PlyType::Float64: return numberAt<double>(bytes, order);
    }
    return 0.0;
}

PlyBody::PlyBody(const Source &source, const PlyHeader &header)
    : m_source(source), m_format(header.format), m_bytes(source.bytes), m_at(header.bodyOffset),
      m_scanner(source.unpaddedText(), header.bodyOffset, header.bodyLine)
{
}

void PlyBody::failTruncated() const
{
    failMalformed(tr("the file ends within %1 of %2", where(), m_element->count));
}

void PlyBody::beginElement(const PlyElement &element, std::size_t number)
{
    m_element = &element;
    m_number = number;
    if (!m_isPart && number % kElementsBetweenReports == 0)
        m_source.progress.report(static_cast<double>(offset()) / static_cast<double>(m_bytes.size()));
    if (m_format == PlyFormat::Ascii)
        skipComments();
}

/// Skips comments: some programs write them among the data, as in the header.
void PlyBody::skipComments()
{
    m_scanner.skipBlankLines();
    for (TextScanner ahead = m_scanner;; ahead = m_scanner) {
        const std::string_view word = ahead.nextWordInLine();
        if (word != "comment" && word != "obj_info" && !word.starts_with('#'))
            return;
        m_scanner.skipLine();
        m_scanner.skipBlankLines();
    }
}

void PlyBody::endElement()
{
    if (m_format != PlyFormat::Ascii)
        return;
    if (const std::string_view word = m_scanner.nextWordInLine(); !word.empty())
        failAtLine(m_scanner.line(), tr("%1 follows all that the header declares for %2", quoted(word), where()));
}

double PlyBody::value(PlyType type)
{
    if (m_format == PlyFormat::Ascii)
        return asciiValue(type);
    return plyValue(take(byteCount(type)), type, m_format);
}

const std::uint8_t *PlyBody::take(std::size_t size)
{
    if (m_bytes.size() - m_at < size)
        failTruncated();
    const std::uint8_t *begin = m_bytes.data() + m_at;
    m_at += size;
    return begin;
}

double PlyBody::asciiNumber(PlyType type)
{
    const std::string_view word = m_scanner.nextWordInLine();
    if (word.empty()) {
        if (m_scanner.isAtEnd())
            failTruncated();
        failAtLine(m_scanner.line(), tr("the line ends before all that the header declares for %1", where()));
    }
    const std::optional<long long> integer = isFloating(type) ? std::nullopt : integerFromWord(word);
    const std::optional<double> number = integer ? std::optional(static_cast<double>(*integer)) : doubleFromWord(word);
    if (!number)
        failAtLine(m_scanner.line(), tr("%1 is not a number", quoted(word)));
    return *number;
}

double PlyBody::asciiValue(PlyType type)
{
    TextScanner ahead = m_scanner;
    const double number = asciiNumber(type);
    if (!isFloating(type)) {
        const auto [least, most] = integerRange(type);
        if (!(number >= least && number <= most) || number != std::floor(number))
            failAtLine(m_scanner.line(), tr("%1 is not a whole number from %2 to %3, which the header declares for %4",
                                            quoted(ahead.nextWordInLine()), base::shortestText(least),
                                            base::shortestText(most), where()));
    }
    return number;
}

std::int64_t PlyBody::corner(PlyType type)
{
    const double number = value(type);
    if (number != std::floor(number))
        failMalformed(tr("%1 refers to vertex %2, which is not a whole number", where(), base::shortestText(number)));
    return number >= -1.0 && number <= 4294967295.0 ? static_cast<std::int64_t>(number) : -2;
}

std::size_t PlyBody::listLength(const PlyProperty &list)
{
    const double length = value(list.countType);
    const std::size_t bytesEach = m_format == PlyFormat::Ascii ? 2 : byteCount(list.type);
    if (!(length >= 0.0))
        failMalformed(tr("%1 has a list of negative length", where()));
    const std::size_t most = (bytesLeft() + 1) / bytesEach;
    if (length > static_cast<double>(most))
        failTruncated();
    return static_cast<std::size_t>(length);
}

void PlyBody::skip(const PlyProperty &property)
{
    const std::size_t count = property.isList ? listLength(property) : 1;
    for (std::size_t i = 0; i < count; ++i) {
        if (m_format == PlyFormat::Ascii)
            asciiNumber(property.type); // unused values may be out of range
        else
            take(byteCount(property.type));
    }
}

void PlyBody::skipAll(const PlyElement &element)
{
    // An element without properties takes no space in the file.
    for (std::size_t i = 0; i < element.count && !element.properties.empty(); ++i) {
        beginElement(element, i);
        for (const PlyProperty &property : element.properties)
            skip(property);
        endElement();
    }
}

bool PlyBody::readLines(const PlyElement &element,
                        const std::function<void(PlyBody &part, std::size_t first, std::size_t count)> &read)
{
    if (m_format != PlyFormat::Ascii || element.properties.empty() || element.count == 0
        || bytesLeft() < 2 * kBytesInTask)
        return false;
    const std::string_view text = m_source.unpaddedText();
    const std::size_t begin = offset();
    const auto share = [&](std::size_t at) { return static_cast<double>(at) / static_cast<double>(text.size()); };
    std::vector<LineRange> ranges = lineRanges(text, begin, kBytesInTask);
    inParallel(ranges.size(), {}, [&](std::size_t i) { countLines(text, ranges[i]); });
    std::size_t first = 0, line = m_scanner.line(), used = 0;
    for (; used < ranges.size() && first < element.count; ++used) {
        LineRange &range = ranges[used];
        range.line = line;
        range.first = first;
        range.count = std::min(range.filledLines, element.count - first);
        line += range.lines;
        first += range.count;
    }
    if (first < element.count)
        return false;
    std::vector<PlyBody> parts(used, *this);
    try {
        inParallel(used, m_source.progress.part(share(begin), share(ranges[used - 1].end)), [&](std::size_t i) {
            const LineRange &range = ranges[i];
            PlyBody &part = parts[i];
            part.m_isPart = true;
            part.m_bytes = m_bytes.first(range.end);
            part.m_scanner = TextScanner(text.substr(0, range.end), range.begin, range.line);
            read(part, range.first, range.count);
        });
    } catch (const base::Error &) {
        return false;
    }
    m_scanner = TextScanner(text, parts.back().m_scanner.offset(), parts.back().m_scanner.line());
    return true;
}

std::size_t PlyBody::end()
{
    if (m_format == PlyFormat::Ascii) {
        skipComments();
        if (const std::string_view word = m_scanner.nextWordInLine(); !word.empty())
            failAtLine(m_scanner.line(),
                       tr("%1 follows all elements that the header declares; correct their numbers in the header",
                          quoted(word)));
        return 0;
    }
    return bytesThatMean(m_bytes.subspan(m_at));
}

} // namespace unprojector::mesh::reader
