#include "core/cli/wrong_points.h"

#include "core/cli/byte_stream.h"
#include "core/cli/csv_line.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <utility>

namespace unprojector::cli {
using namespace doctor;
namespace {

/// The numbers of "X,Y,Z", with or without blanks and brackets around them.
std::vector<std::string_view> listed(std::string_view text)
{
    text = trimmed(text);
    if (text.size() > 1 && ((text.front() == '(' && text.back() == ')') || (text.front() == '[' && text.back() == ']')))
        text = text.substr(1, text.size() - 2);
    std::vector<std::string_view> parts;
    for (std::size_t start = 0; start <= text.size();) {
        const std::size_t end = std::min(text.find(',', start), text.size());
        parts.push_back(trimmed(text.substr(start, end - start)));
        start = end + 1;
    }
    return parts;
}

double depthDigit(const WrittenNumber &depth)
{
    return depth.lastDigit <= 1.5 * std::pow(10.0, -kRoundedDepthDecimals) ? depth.lastDigit : 0.0;
}

void setGot(WrongPoint &point, int axis, const WrittenNumber &number)
{
    point.got[axis] = number.value;
    point.lastDigit[axis] = number.lastDigit;
}

constexpr std::array<std::string_view, 6> kColumns{"px", "py", "depth", "x", "y", "z"};
constexpr std::size_t kDepth = 2;

std::vector<std::string_view> cellsOf(std::string_view row)
{
    std::vector<std::string_view> cells;
    for (std::size_t start = 0; start <= row.size();) {
        const std::size_t end = cellEnd(row, start);
        cells.push_back(unquoted(row.substr(start, end - start)));
        start = end + 1;
    }
    return cells;
}

/// Where each column stands; without a header at its own place. What is wrong with a header is said on stderr.
std::optional<std::array<std::size_t, 6>> placesOf(const std::vector<std::string_view> &first, const std::string &name)
{
    std::array<std::size_t, 6> places{0, 1, 2, 3, 4, 5};
    if (writtenNumber(first.front()))
        return places;
    for (std::size_t column = 0; column < kColumns.size(); ++column) {
        const auto found = std::find(first.begin(), first.end(), kColumns[column]);
        places[column] = std::size_t(found - first.begin());
        if (found == first.end() && column != kDepth) {
            complain(name + ":1: there is no column \"" + std::string(kColumns[column])
                     + "\"; give px,py,depth,x,y,z, where depth may be left out");
            return std::nullopt;
        }
    }
    return places;
}

/// Nothing where the row has a cell that is no number, which stderr has been told.
std::optional<WrongPoint> pointOf(const std::vector<std::string_view> &cells, const std::array<std::size_t, 6> &places,
                                  const std::string &where)
{
    WrongPoint point;
    for (std::size_t column = 0; column < kColumns.size(); ++column) {
        const std::string_view cell = places[column] < cells.size() ? cells[places[column]] : std::string_view();
        if (column == kDepth && cell.empty())
            continue;
        const std::optional<WrittenNumber> number = writtenNumber(cell);
        if (!number) {
            complain(where + ": " + std::string(kColumns[column]) + ": \"" + std::string(cell) + "\" is no number");
            return std::nullopt;
        }
        if (column < kDepth) {
            point.pixel[int(column)] = number->value;
        } else if (column == kDepth) {
            point.depth = number->value;
            point.depthLastDigit = depthDigit(*number);
        } else {
            setGot(point, int(column - kDepth) - 1, *number);
        }
    }
    return point;
}

std::optional<std::string> allOf(ByteSource &source)
{
    std::string text;
    std::array<char, 16384> buffer;
    while (const std::size_t size = source.read(buffer.data(), buffer.size()))
        text.append(buffer.data(), size);
    if (source.hasFailed()) {
        complain(source.name() + ": cannot be read");
        return std::nullopt;
    }
    return text;
}

} // namespace

std::optional<WrittenNumber> writtenNumber(std::string_view text)
{
    text = trimmed(text);
    if (text.starts_with('+'))
        text.remove_prefix(1);
    WrittenNumber number;
    const char *end = text.data() + text.size();
    const auto read = std::from_chars(text.data(), end, number.value);
    if (read.ec != std::errc{} || read.ptr != end || !std::isfinite(number.value))
        return std::nullopt;
    const std::size_t mantissaEnd = std::min(text.find_first_of("eE"), text.size());
    const std::size_t point = text.substr(0, mantissaEnd).find('.');
    int place = point == std::string_view::npos ? 0 : -int(mantissaEnd - point - 1);
    if (mantissaEnd < text.size()) {
        std::string_view exponent = text.substr(mantissaEnd + 1);
        if (exponent.starts_with('+'))
            exponent.remove_prefix(1);
        int power = 0;
        std::from_chars(exponent.data(), exponent.data() + exponent.size(), power);
        place += std::clamp(power, -400, 400); // as far as doubles go
    }
    // More digits than a double has say nothing more.
    const double least = std::max(std::abs(number.value), 1.0) * 1e-15;
    number.lastDigit = std::max(std::pow(10.0, place), least);
    if (!std::isfinite(number.lastDigit))
        return std::nullopt;
    return number;
}

std::optional<WrongPoint> wrongPoint(const std::string &pixel, const std::string &depth, const std::string &got)
{
    WrongPoint point;
    const std::vector<std::string_view> position = listed(pixel), coordinates = listed(got);
    for (int axis = 0; axis < 2; ++axis) {
        const auto number = position.size() == 2 ? writtenNumber(position[std::size_t(axis)]) : std::nullopt;
        if (!number) {
            complain("--pixel " + pixel + ": give device pixels from the top left corner, as in 400.5,300.5");
            return std::nullopt;
        }
        point.pixel[axis] = number->value;
    }
    if (!depth.empty()) {
        const std::optional<WrittenNumber> number = writtenNumber(depth);
        if (!number) {
            complain("--depth " + depth + ": give a depth in the scene's depth range, as in 0.838331, or leave it out");
            return std::nullopt;
        }
        point.depth = number->value;
        point.depthLastDigit = depthDigit(*number);
    }
    for (int axis = 0; axis < 3; ++axis) {
        const auto number = coordinates.size() == 3 ? writtenNumber(coordinates[std::size_t(axis)]) : std::nullopt;
        if (!number) {
            complain("--got " + got
                     + ": give the three coordinates as the program has printed them, as in "
                       "0.7051,-0.4122,0.0918");
            return std::nullopt;
        }
        setGot(point, axis, *number);
    }
    return point;
}

std::optional<WrongPoints> wrongPoints(const std::string &file)
{
    ByteSource source(file);
    if (!source.isOpen())
        return std::nullopt;
    std::optional<std::string> text = allOf(source);
    if (!text)
        return std::nullopt;
    constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf";
    if (text->starts_with(kByteOrderMark))
        text->erase(0, kByteOrderMark.size());
    WrongPoints result;
    std::optional<std::array<std::size_t, 6>> places;
    std::size_t surplus = 0, line = 0;
    for (std::size_t start = 0; start < text->size();) {
        const std::size_t end = std::min(text->find('\n', start), text->size());
        const std::string_view row = trimmed(std::string_view(*text).substr(start, end - start));
        start = end + 1;
        ++line;
        if (row.empty())
            continue;
        const std::vector<std::string_view> cells = cellsOf(row);
        if (!places) {
            places = placesOf(cells, source.name());
            if (!places)
                return std::nullopt;
            if (!writtenNumber(cells.front()))
                continue;
        }
        if (result.points.size() == kMostWrongPoints) {
            ++surplus;
            continue;
        }
        if (const auto point = pointOf(cells, *places, source.name() + ':' + std::to_string(line)))
            result.points.push_back(*point);
        else
            result.isComplete = false;
    }
    if (surplus > 0)
        complain(source.name() + ": the first " + std::to_string(kMostWrongPoints) + " points are looked at; "
                 + std::to_string(surplus) + (surplus == 1 ? " more is not" : " more are not"));
    if (result.points.empty()) {
        complain(source.name() + ": there is no point in it; give rows of px,py,depth,x,y,z");
        return std::nullopt;
    }
    return result;
}

} // namespace unprojector::cli
