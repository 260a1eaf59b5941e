#include "core/base/expression.h"

#include "core/base/angle.h"
#include "core/base/letters.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <initializer_list>
#include <string>
#include <system_error>

namespace unprojector::base {

namespace {

using Code = ExpressionErrorCode;
using Value = Expected<double, ExpressionError>;

constexpr int kDeepest = 100;

// UTF-8 for any character set of the compiler.
constexpr std::string_view kMinus = "\xe2\x88\x92";
constexpr std::string_view kTimes = "\xc3\x97";
constexpr std::string_view kMiddleDot = "\xc2\xb7";
constexpr std::string_view kDivided = "\xc3\xb7";
constexpr std::string_view kPiLetter = "\xcf\x80";

/// Recursive descent, one function a level: sum of products of factors.
class Parser {
public:
    /// @param names  in addition to pi and the functions; may be empty
    Parser(std::string_view text, const Names &names) : m_text(text), m_names(names) {}

    Value whole()
    {
        skipBlanks();
        if (isAtEnd())
            return ExpressionError{Code::Empty};
        const Value value = sum();
        if (!value)
            return value;
        if (!isAtEnd())
            return unexpected(Code::MissingOperator);
        if (!std::isfinite(*value))
            return ExpressionError{Code::OutOfRange, 0, m_text.size()};
        return value;
    }

private:
    bool isAtEnd() const { return m_at == m_text.size(); }
    char next() const { return isAtEnd() ? '\0' : m_text[m_at]; }

    void skipBlanks()
    {
        while (next() == ' ' || next() == '\t' || next() == '\n' || next() == '\r') // pasted with a line end
            ++m_at;
    }

    /// Consumes one of these signs and the blanks after it.
    /// @return whether it was next
    bool take(std::initializer_list<std::string_view> signs)
    {
        for (const std::string_view sign : signs) {
            if (m_text.substr(m_at, sign.size()) == sign) {
                m_at += sign.size();
                skipBlanks();
                return true;
            }
        }
        return false;
    }
    bool takeMinus() { return take({"-", kMinus}); }

    /// The length of the next token: a name, a number's digits, or one character of UTF-8.
    std::size_t lengthOfNext() const
    {
        const auto isPart = [&](char c) { return isLetter(next()) ? isLetter(c) || isDigit(c) : isDigit(c); };
        std::size_t end = m_at;
        while (end < m_text.size() && isPart(m_text[end]))
            ++end;
        if (end > m_at)
            return end - m_at;
        end = std::min(m_at + 1, m_text.size());
        while (end < m_text.size() && (static_cast<unsigned char>(m_text[end]) & 0xC0) == 0x80)
            ++end;
        return end - m_at;
    }

    /// The error for an unexpected token.
    /// @param code  the missing item, if the token would be valid elsewhere
    ExpressionError unexpected(Code code) const
    {
        const ExpressionError error{code, m_at, lengthOfNext()};
        const std::string_view part = m_text.substr(m_at, error.length);
        constexpr std::string_view kKnown = "0123456789+-*/(.,";
        if (part.empty() || isLetter(part[0]) || kKnown.find(part[0]) != std::string_view::npos || part == kMinus
            || part == kTimes || part == kMiddleDot || part == kDivided || part == kPiLetter)
            return error;
        if (part == ")")
            return {m_depth == 0 ? Code::UnopenedParenthesis : code, m_at, error.length};
        return {Code::UnknownCharacter, m_at, error.length};
    }

    Value sum()
    {
        Value value = product();
        while (value) {
            const bool isPlus = take({"+"});
            if (!isPlus && !takeMinus())
                break;
            const Value other = product();
            value = other ? Value(isPlus ? *value + *other : *value - *other) : other;
        }
        return value;
    }

    Value product()
    {
        Value value = factor();
        while (value) {
            const std::size_t place = m_at;
            const bool isTimes = take({"*", kTimes, kMiddleDot});
            if (!isTimes && !take({"/", kDivided}))
                break;
            const Value other = factor();
            if (other && !isTimes && *other == 0.0)
                return ExpressionError{Code::DivisionByZero, place, m_text[place] == '/' ? 1u : 2u};
            value = other ? Value(isTimes ? *value * *other : *value / *other) : other;
        }
        return value;
    }

    Value factor()
    {
        if (++m_levels > kDeepest)
            return ExpressionError{Code::TooDeep, m_at, lengthOfNext()};
        Value value = signedOperand();
        --m_levels;
        return value;
    }

    Value signedOperand()
    {
        if (takeMinus()) {
            const Value value = factor();
            return value ? Value(-*value) : value;
        }
        if (take({"+"}))
            return factor();
        if (take({kPiLetter}))
            return kPi;
        if (next() == '(')
            return parenthesis();
        if (isLetter(next()))
            return named();
        if (isDigit(next()) || next() == '.' || next() == ',')
            return number();
        return unexpected(Code::MissingNumber);
    }

    Value parenthesis()
    {
        const std::size_t opened = m_at;
        take({"("});
        ++m_depth;
        Value value = sum();
        if (!value)
            return value;
        if (!take({")"}))
            return isAtEnd() ? ExpressionError{Code::UnclosedParenthesis, opened, 1}
                             : unexpected(Code::MissingOperator);
        --m_depth;
        return value;
    }

    Value named()
    {
        const ExpressionError here{Code::UnknownName, m_at, lengthOfNext()};
        const std::string_view name = m_text.substr(m_at, here.length);
        const bool isPi = name == "pi";
        if (!isPi && name != "sqrt" && name != "deg" && name != "rad")
            return m_names ? given() : here;
        m_at += here.length;
        skipBlanks();
        if (isPi)
            return kPi;
        if (next() != '(')
            return ExpressionError{Code::NotCalled, here.place, here.length};
        const Value argument = parenthesis();
        if (!argument)
            return argument;
        if (name == "deg")
            return degreesFromRadians(*argument);
        if (name == "rad")
            return radiansFromDegrees(*argument);
        if (*argument < 0.0)
            return ExpressionError{Code::RootOfNegative, here.place, here.length};
        return std::sqrt(*argument);
    }

    Value given()
    {
        const std::size_t start = m_at;
        const auto isPart = [](char c) {
            return isLetter(c) || isDigit(c) || c == '.' || c == '[' || c == ']' || c == ':';
        };
        while (isPart(next()))
            ++m_at;
        const std::optional<double> value = m_names(m_text.substr(start, m_at - start));
        if (!value)
            return ExpressionError{Code::UnknownName, start, m_at - start};
        skipBlanks();
        return *value;
    }

    Value number()
    {
        const std::size_t start = m_at;
        std::string digits;
        const auto takeDigits = [&] {
            const std::size_t before = m_at;
            for (; isDigit(next()); ++m_at)
                digits += next();
            return m_at > before;
        };
        bool hasDigits = takeDigits();
        if (next() == '.' || next() == ',') {
            const std::size_t point = m_at;
            const bool isComma = next() == ',';
            const bool isOfThousands = hasDigits && digits.size() <= 3 && digits.front() != '0';
            ++m_at;
            digits += '.';
            const std::size_t before = digits.size();
            hasDigits = takeDigits() || hasDigits;
            if (isComma && isOfThousands && digits.size() == before + 3 && next() != '.' && next() != ',')
                return ExpressionError{Code::AmbiguousComma, point, m_at - point};
        }
        if (!hasDigits)
            return ExpressionError{Code::MissingNumber, start, 1};
        if (next() == '.' || next() == ',')
            return ExpressionError{Code::SecondPoint, m_at, 1};
        if (next() == 'e' || next() == 'E') {
            ++m_at;
            digits += 'e';
            if (takeMinus())
                digits += '-';
            else
                take({"+"});
            if (!takeDigits())
                return unexpected(Code::MissingNumber);
        }
        double value = 0.0;
        const auto read = std::from_chars(digits.data(), digits.data() + digits.size(), value);
        if (read.ec != std::errc() || !std::isfinite(value))
            return ExpressionError{Code::OutOfRange, start, m_at - start};
        skipBlanks();
        return value;
    }

    std::string_view m_text;
    const Names &m_names;
    std::size_t m_at = 0;
    int m_depth = 0;  ///< open parentheses
    int m_levels = 0; ///< nesting of parentheses and signs
};

} // namespace

Expected<double, ExpressionError> evaluate(std::string_view text)
{
    return evaluate(text, Names());
}

Expected<double, ExpressionError> evaluate(std::string_view text, const Names &names)
{
    return Parser(text, names).whole();
}

} // namespace unprojector::base
