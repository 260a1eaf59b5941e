#include "tests/core/lessons/statements.h"

#include "core/base/letters.h"
#include "core/base/number_text.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <utility>

namespace lessontexts {
namespace {

using namespace unprojector;

// Written in UTF-8 bytes, so that they do not depend on the compiler's character set.
constexpr std::string_view kMinus = "\xe2\x88\x92";
constexpr std::string_view kPlusMinus = "\xc2\xb1";
/// The tolerance of numbers stated exactly: the rounding error of the computation.
constexpr double kRounding = 1e-9;

using base::isDigit;
using base::isLetter;

/// True if the text before a number makes it part of a name: "w" in w9, "m[" in m[14].
bool isOfName(std::string_view before)
{
    if (before.size() > 1 && before.substr(before.size() - 2) == "..") // m[0..15]
        return true;
    if (!before.empty() && before.back() == '[')
        before.remove_suffix(1);
    else if (!before.empty() && before.back() == '.')
        return before.size() > 1 && isDigit(before[before.size() - 2]); // the rest of 1.2.3
    return !before.empty() && (isLetter(before.back()) || before.back() == ']');
}

struct Digits {
    double value = 0.0;
    int decimals = 0;
    std::size_t end = 0;
};

Digits digitsAt(std::string_view text, std::size_t at)
{
    Digits digits;
    std::size_t end = at;
    while (end < text.size() && isDigit(text[end]))
        ++end;
    if (end + 1 < text.size() && text[end] == '.' && isDigit(text[end + 1])) {
        const std::size_t point = end++;
        while (end < text.size() && isDigit(text[end]))
            ++end;
        digits.decimals = static_cast<int>(end - point - 1);
    }
    std::from_chars(text.data() + at, text.data() + end, digits.value);
    digits.end = end;
    return digits;
}

std::vector<StatedNumber> numbersIn(std::string_view text)
{
    std::vector<StatedNumber> numbers;
    for (std::size_t at = 0; at < text.size();) {
        if (!isDigit(text[at])) {
            ++at;
            continue;
        }
        const std::string_view before = text.substr(0, at);
        Digits digits = digitsAt(text, at);
        if (!isOfName(before)) {
            StatedNumber number{digits.value, 0.0, before.ends_with(kPlusMinus)};
            if (digits.decimals > 0)
                number.tolerance = 0.5 * std::pow(10.0, -digits.decimals) * (1.0 + kRounding);
            for (const std::string_view over : {std::string_view("/"), std::string_view(" : ")}) {
                const std::size_t below = digits.end + over.size();
                if (text.substr(digits.end, over.size()) == over && below < text.size() && isDigit(text[below])) {
                    digits = digitsAt(text, below);
                    number.value /= digits.value;
                    number.tolerance = 0.0;
                    break;
                }
            }
            if (before.ends_with("-") || before.ends_with(kMinus))
                number.value = -number.value;
            if (number.tolerance == 0.0)
                number.tolerance = kRounding * std::fmax(1.0, std::fabs(number.value));
            numbers.push_back(number);
        }
        at = digits.end;
    }
    return numbers;
}

/// The words without formula numbers: "(9) to (12)" has none.
std::string withoutFormulaNumbers(std::string_view words)
{
    std::string plain;
    for (std::size_t at = 0; at < words.size();) {
        const std::size_t end = std::min(words.find_first_not_of("0123456789", at + 1), words.size());
        const bool isNumber = words[at] == '(' && end > at + 1 && end < words.size() && words[end] == ')';
        plain += isNumber ? ' ' : words[at];
        at = isNumber ? end + 1 : at + 1;
    }
    return plain;
}

/// The text without tags, and without formula numbers in links to formulas.
std::string withoutTags(std::string_view text)
{
    std::string plain;
    for (std::size_t at = 0; at < text.size();) {
        if (text[at] != '<') {
            plain += text[at++];
            continue;
        }
        const bool isFormula = text.substr(at, 20).find("'formulas:") != std::string_view::npos;
        at = std::min(text.find('>', at), text.size() - 1) + 1;
        if (isFormula) {
            const std::size_t close = std::min(text.find("</a>", at), text.size());
            plain += withoutFormulaNumbers(text.substr(at, close - at));
            at = close;
        }
    }
    return plain;
}

/// Splits a list at commas outside of parentheses, without blanks around the parts.
std::vector<std::string> parts(std::string_view list)
{
    std::vector<std::string> parts{{}};
    int depth = 0;
    for (const char c : list) {
        depth += c == '(' ? 1 : c == ')' ? -1 : 0;
        if (c == ',' && depth == 0)
            parts.emplace_back();
        else if (c != ' ' || !parts.back().empty())
            parts.back() += c;
    }
    return parts;
}

std::optional<Statement> statement(std::string_view inside)
{
    constexpr std::string_view kEquals = " = ";
    const std::size_t equals = inside.rfind(kEquals);
    if (equals == std::string_view::npos)
        return std::nullopt;
    Statement made;
    made.shown = inside.substr(0, equals);
    made.numbers = numbersIn(withoutTags(made.shown));
    made.sources = parts(inside.substr(equals + kEquals.size()));
    made.isQuoted = made.sources == std::vector<std::string>{"quoted"};
    return made;
}

/// Compares a text's numbers with the program's.
std::optional<std::string> faultOf(const Statement &statement, const std::vector<double> &values)
{
    if (values.size() != statement.numbers.size())
        return "says " + std::to_string(statement.numbers.size()) + " numbers and names "
               + std::to_string(values.size());
    for (std::size_t i = 0; i < values.size(); ++i) {
        const StatedNumber &stated = statement.numbers[i];
        const double value = stated.isOfSize ? std::fabs(values[i]) : values[i];
        if (!(std::fabs(value - stated.value) <= stated.tolerance))
            return "says " + base::shortestText(stated.value) + ", it is " + base::shortestText(values[i]);
    }
    return std::nullopt;
}

} // namespace

StatedText statedText(std::string_view text)
{
    StatedText result;
    std::string outside; // the rest of the text, with a blank for each statement
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t open = text.find_first_of("{}", at);
        const std::string_view plain = text.substr(at, open - at);
        outside += plain;
        if (open == std::string_view::npos)
            break;
        const std::size_t close = text.find_first_of("{}", open + 1);
        if (text[open] == '}' || close == std::string_view::npos || text[close] == '{') {
            result.faults.push_back("a brace without its other one near \"" + std::string(text.substr(open, 30))
                                    + "\"");
            break;
        }
        const std::string_view inside = text.substr(open + 1, close - open - 1);
        if (std::optional<Statement> made = statement(inside)) {
            result.statements.push_back(std::move(*made));
        } else {
            result.faults.push_back("{" + std::string(inside) + "} has no \" = \" with where its numbers come from");
        }
        outside += ' ';
        at = close + 1;
    }
    const std::string plain = withoutTags(outside);
    if (const auto loose = numbersIn(plain); !loose.empty())
        result.faults.push_back(std::to_string(loose.size()) + " numbers outside of braces in \"" + plain + "\"");
    return result;
}

std::vector<std::string> faultsOf(const lessons::LessonNumbers &numbers, const lessons::Step &step)
{
    std::vector<std::string> found;
    const auto look = [&](const std::string &key, const std::string &written) {
        const std::string where = step.id + "." + key + ": ";
        const StatedText text = statedText(written);
        for (const std::string &fault : text.faults)
            found.push_back(where + fault);
        for (const Statement &statement : text.statements) {
            if (statement.isQuoted)
                continue;
            std::vector<double> all;
            std::optional<std::string> fault;
            for (const std::string &source : statement.sources) {
                const std::vector<double> some = numbers.values(step.id, source);
                all.insert(all.end(), some.begin(), some.end());
                if (some.empty())
                    fault = "names \"" + source + "\", which the program does not compute";
            }
            if (!fault)
                fault = faultOf(statement, all);
            if (fault)
                found.push_back(where + "\"" + statement.shown + "\" " + *fault);
        }
    };
    look("title", step.title);
    for (const std::string &paragraph : step.text)
        look("text", paragraph);
    if (step.question) {
        look("question.text", step.question->text);
        for (const std::string &paragraph : step.question->reveal)
            look("question.reveal", paragraph);
        if (numbers.values(step.id, step.question->answer).size() != 1)
            found.push_back(step.id + ".question.answer: \"" + step.question->answer + "\" is not one number");
    }
    return found;
}

} // namespace lessontexts
