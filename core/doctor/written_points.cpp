#include "core/doctor/written_points.h"

#include "core/base/csv.h"
#include "core/base/number_text.h"
#include "core/base/text_scanner.h"
#include "core/base/translation.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <system_error>
#include <utility>

namespace unprojector::doctor {
using namespace geometry;

namespace {

constexpr std::size_t kDepth = 2;

constexpr std::string_view kMinusSign = "\xe2\x88\x92"; // U+2212, the minus sign of typeset numbers

struct Replacement {
    std::string_view from, to;
};
/// Typeset characters and the programs' equivalents: signs, blanks, commas, brackets.
constexpr Replacement kReplacements[] = {{kMinusSign, "-"},     {"\xc2\xa0", " "},     {"\xe2\x80\xaf", " "},
                                         {"\xef\xbc\x8c", ","}, {"\xef\xbc\x88", "("}, {"\xef\xbc\x89", ")"}};

std::string inAscii(std::string_view text)
{
    std::string result(text);
    for (const Replacement &each : kReplacements) {
        for (std::size_t at = result.find(each.from); at != std::string::npos; at = result.find(each.from, at))
            result.replace(at, each.from.size(), each.to);
    }
    return result;
}

bool isLetter(char c)
{
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
}

/// True for a word that is a name, such as vec3 and x, and no failed number.
bool isName(std::string_view word)
{
    const std::string small = base::lowerCase(word);
    return isLetter(word.front()) && small != "nan" && small != "inf" && small != "infinity";
}

/// True for a program's output for NaN or infinity: nan, -inf, 1.#IND.
bool isNotFinite(std::string_view word)
{
    const std::string small = base::lowerCase(word);
    return small.find("nan") != small.npos || small.find("inf") != small.npos || small.find("ind") != small.npos;
}

} // namespace

std::optional<WrittenNumber> writtenNumber(std::string_view text)
{
    const std::string ascii = inAscii(text);
    text = base::trimmed(ascii);
    if (text.starts_with('+'))
        text.remove_prefix(1);
    if (text.size() > 1 && (text.back() == 'f' || text.back() == 'F')
        && text.find_first_not_of("0123456789.eE+-") == text.size() - 1)
        text.remove_suffix(1);
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
        place += std::clamp(power, -400, 400); // up to a double's range
    }
    // Digits beyond a double's precision have no meaning.
    const double least = std::max(std::abs(number.value), 1.0) * 1e-15;
    number.lastDigit = std::max(std::pow(10.0, place), least);
    if (!std::isfinite(number.lastDigit))
        return std::nullopt;
    return number;
}

std::string depthOutsideText(const std::string &depth, const DepthRange &range)
{
    return base::tr(
        "the depth %1 lies outside the depth range, which goes from %2 to %3. A distance is not a depth: leave it out",
        depth, base::shortestText(range.atNear), base::shortestText(range.atFar));
}

Result<std::vector<WrittenNumber>, std::string> writtenNumbers(std::string_view given, std::size_t count,
                                                               const std::string &wanted)
{
    constexpr std::string_view kBetween = " \t\r\n,;()[]{}<>=:\"'|";
    const std::string text = inAscii(given);
    std::vector<WrittenNumber> numbers;
    std::size_t commas = 0; // between two numbers
    bool isBehindComma = false;
    for (std::size_t at = 0; at < text.size();) {
        if (kBetween.find(text[at]) != std::string_view::npos) {
            isBehindComma = isBehindComma || text[at] == ',' || text[at] == ';';
            ++at;
            continue;
        }
        const std::size_t end = std::min(text.find_first_of(kBetween, at), text.size());
        const std::string_view word = std::string_view(text).substr(at, end - at);
        at = end;
        if (isName(word))
            continue;
        const auto number = writtenNumber(word);
        if (!number)
            return isNotFinite(word)
                       ? base::tr("\"%1\" is not a finite number; give a click for which the program has a point", word)
                       : base::tr("\"%1\" is not a number; give %2", word, wanted);
        if (!numbers.empty() && isBehindComma)
            ++commas;
        isBehindComma = false;
        numbers.push_back(*number);
    }
    // 1,500.5 2 3 are not four numbers.
    if (commas != 0 && commas + 1 != numbers.size())
        return base::tr("it has commas between some numbers and not between others; write decimals with a point, %1",
                        wanted);
    if (count == 3 && numbers.size() == 4 && numbers.back().value == 1.0)
        numbers.pop_back();
    if (numbers.size() != count || numbers.empty())
        return base::tr(numbers.size() == 1 ? "it has %1 number; give %2" : "it has %1 numbers; give %2",
                        numbers.size(), wanted);
    return numbers;
}

double depthLastDigit(const WrittenNumber &depth)
{
    constexpr double kRounded = 1e-4;
    return depth.lastDigit <= 1.5 * kRounded ? depth.lastDigit : 0.0;
}

Result<std::vector<PointRow>, base::CsvError> pointRows(std::string_view text)
{
    constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf";
    if (text.starts_with(kByteOrderMark))
        text.remove_prefix(kByteOrderMark.size());
    base::CsvReader reader(text);
    bool hasRow = reader.next();
    const base::CsvRow &read = reader.row();
    std::array<std::size_t, kPointColumns.size()> places{0, 1, 2, 3, 4, 5};
    const bool hasHeader = std::any_of(kPointColumns.begin(), kPointColumns.end(), [&read](std::string_view name) {
        return read.column(name) < read.cells.size();
    });
    for (std::size_t i = 0; hasHeader && i < places.size(); ++i) {
        places[i] = read.column(kPointColumns[i]);
        const bool isMissing = places[i] == read.cells.size();
        if (isMissing && i != kDepth)
            return base::CsvError{
                read.line, i, false,
                base::tr("there is no column \"%1\"; give px,py,depth,x,y,z, where depth may be left out",
                         kPointColumns[i])};
        if (!isMissing && read.column(kPointColumns[i], places[i] + 1) < read.cells.size())
            return base::CsvError{
                read.line, i, false,
                base::tr("the column \"%1\" is there twice; leave one of them out", kPointColumns[i])};
        if (isMissing)
            places[i] = std::string::npos; // a longer row has none either
    }
    std::vector<PointRow> rows;
    for (hasRow = hasHeader ? reader.next() : hasRow; hasRow; hasRow = reader.next()) {
        PointRow &row = rows.emplace_back();
        row.line = read.line;
        row.isTooLong = !hasHeader && read.cells.size() > kPointColumns.size();
        for (std::size_t column = 0; column < places.size(); ++column)
            row.cells[column] = read.text(places[column]);
    }
    if (reader.error())
        return *reader.error();
    return rows;
}

Result<WrongPoint, std::size_t> pointOf(const PointRow &row)
{
    if (row.isTooLong)
        return row.cells.size();
    WrongPoint point;
    for (std::size_t column = 0; column < row.cells.size(); ++column) {
        if (column == kDepth && base::trimmed(row.cells[column]).empty())
            continue;
        const auto number = writtenNumber(row.cells[column]);
        if (!number)
            return column;
        if (column < kDepth) {
            point.pixel[int(column)] = number->value;
        } else if (column == kDepth) {
            point.depth = number->value;
            point.depthLastDigit = depthLastDigit(*number);
        } else {
            point.got[int(column - kDepth) - 1] = number->value;
            point.lastDigit[int(column - kDepth) - 1] = number->lastDigit;
        }
    }
    return point;
}

Result<WrongPoint, std::string> wrongPointOf(const std::string &pixel, const std::string &depth, const std::string &got,
                                             const PointTextNames &names)
{
    WrongPoint point;
    const auto position =
        writtenNumbers(pixel, 2, base::tr("device pixels from the top left corner, as in 400.5,300.5"));
    if (!position)
        return names.pixel + (' ' + pixel) + ": " + position.error();
    point.pixel = DevicePoint((*position)[0].value, (*position)[1].value);
    if (!depth.empty()) {
        const auto number = writtenNumber(depth);
        if (!number)
            return base::tr("%1: give a depth in the scene's depth range, as in 0.838331, or leave it out",
                            names.depth + (' ' + depth));
        point.depth = number->value;
        point.depthLastDigit = depthLastDigit(*number);
    }
    const auto coordinates = writtenNumbers(got, 3,
                                            base::tr("the three coordinates as the program printed them, as in "
                                                     "0.7051,-0.4122,0.0918 or vec3(0.7051, -0.4122, 0.0918)"));
    if (!coordinates)
        return names.got + (' ' + got) + ": " + coordinates.error();
    for (int axis = 0; axis < 3; ++axis) {
        point.got[axis] = (*coordinates)[std::size_t(axis)].value;
        point.lastDigit[axis] = (*coordinates)[std::size_t(axis)].lastDigit;
    }
    return point;
}

} // namespace unprojector::doctor
