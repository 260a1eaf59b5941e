#include "core/base/expression.h"

#include "core/base/angle.h"
#include "core/base/letters.h"
#include "core/base/source_text.h"
#include "core/base/text_scanner.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <initializer_list>
#include <iterator>
#include <string>
#include <system_error>

namespace unprojector::base {

namespace {

using Code = ExpressionErrorCode;

/// The value of a part of an expression.
struct Term {
    double value = 0.0;
    bool isWhole = false; ///< computed from whole numbers only; these have no decimal point
};
using Value = Expected<Term, ExpressionError>;

constexpr int kDeepest = 100;
constexpr int kMostOperands = 1000; ///< of a number and the variables in it

// UTF-8 for any character set of the compiler.
constexpr std::string_view kMinus = "\xe2\x88\x92";
constexpr std::string_view kTimes = "\xc3\x97";
constexpr std::string_view kMiddleDot = "\xc2\xb7";
constexpr std::string_view kDivided = "\xc3\xb7";
constexpr std::string_view kPiLetter = "\xcf\x80";

/// Names between blanks: those of a program's source as base::plainName, those that a user may type after =.
struct Constant {
    std::string_view names;
    double value;
};
constexpr Constant kConstants[] = {{" =pi pi d3dxpi mpi xmpi piv pif ", kPi},
                                   {" mpi2 halfpi xmpidiv2 piover2 fracpi2 ", kPi / 2.0},
                                   {" fracpi3 ", kPi / 3.0},
                                   {" mpi4 quarterpi xmpidiv4 piover4 fracpi4 ", kPi / 4.0},
                                   {" xm2pi twopi tau ", 2.0 * kPi},
                                   {" degtorad deg2rad ", kRadiansPerDegree},
                                   {" radtodeg rad2deg ", 1.0 / kRadiansPerDegree}};
struct Function {
    std::string_view names;
    double (*value)(double);
};
constexpr Function kFunctions[] = {
    {" =rad radians degtorad deg2rad toradians xmconverttoradians degreestoradians qdegreestoradians ",
     radiansFromDegrees},
    {" =deg degrees radtodeg todegrees xmconverttodegrees radianstodegrees ", degreesFromRadians},
    {" =sqrt sqrt ", [](double x) { return std::sqrt(x); }},
    {" tan ", [](double x) { return std::tan(x); }},
    {" atan ", [](double x) { return std::atan(x); }},
    {" float double glfloat gldouble glclampd staticcast t ", [](double x) { return x; }}};
constexpr std::string_view kTypes = " float double int glfloat gldouble glint glsizei glclampd ";

template <class Table>
auto found(const Table &table, const std::string &name)
{
    const auto entry = std::ranges::find_if(table, [&](const auto &one) { return isListed(one.names, name); });
    return entry == std::end(table) ? nullptr : &*entry;
}

/// Recursive descent, one function a level: sum of products of factors.
class Parser {
public:
    /// @param names  in addition to pi and the functions; may be empty
    /// @param variables  of a program, whose source text this is; null for what a user types
    Parser(std::string_view text, const Names &names, const Variables *variables = nullptr, int levels = 0,
           int operands = 0)
        : m_text(text), m_names(names), m_variables(variables), m_levels(levels), m_operands(operands)
    {
    }

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
        if (!std::isfinite(value->value))
            return ExpressionError{Code::OutOfRange, 0, m_text.size()};
        return value;
    }

    std::string_view wholeQuotient() const { return m_wholeQuotient; }

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
            if (!other)
                return other;
            value = Term{isPlus ? value->value + other->value : value->value - other->value,
                         value->isWhole && other->isWhole};
        }
        return value;
    }

    Value product()
    {
        const std::size_t start = m_at;
        Value value = factor();
        while (value) {
            const std::size_t place = m_at;
            const bool isTimes = take({"*", kTimes, kMiddleDot});
            if (!isTimes && !take({"/", kDivided}))
                break;
            const Value other = factor();
            if (!other)
                return other;
            if (!isTimes && other->value == 0.0)
                return ExpressionError{Code::DivisionByZero, place, m_text[place] == '/' ? 1u : 2u};
            value = Term{isTimes ? value->value * other->value : value->value / other->value,
                         value->isWhole && other->isWhole};
            if (!isTimes && value->isWhole && value->value != std::trunc(value->value))
                m_wholeQuotient = trimmed(m_text.substr(start, m_at - start));
        }
        return value;
    }

    Value factor()
    {
        if (++m_levels > kDeepest || (m_variables && ++m_operands > kMostOperands))
            return ExpressionError{Code::TooDeep, m_at, lengthOfNext()};
        Value value = signedOperand();
        --m_levels;
        return value;
    }

    Value signedOperand()
    {
        if (takeMinus()) {
            const Value value = factor();
            return value ? Value(Term{-value->value, value->isWhole}) : value;
        }
        if (take({"+"}))
            return factor();
        if (take({kPiLetter}))
            return Term{kPi};
        if (next() == '(')
            return parenthesis();
        if (isLetter(next()))
            return named();
        if (isDigit(next()) || isAtPoint())
            return number();
        return unexpected(Code::MissingNumber);
    }

    Value parenthesis()
    {
        const std::size_t opened = m_at;
        take({"("});
        const std::string_view type = namesAt(m_text, m_at);
        if (m_variables && isListed(kTypes, plainName(type))) {
            m_at += type.size();
            skipBlanks();
            return take({")"}) ? cast(factor(), type) : unexpected(Code::MissingOperator);
        }
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

    static Value cast(const Value &value, std::string_view type)
    {
        if (!value)
            return value;
        const bool isWhole = plainName(type).find("int") != std::string::npos;
        return Term{isWhole ? std::trunc(value->value) : value->value, isWhole};
    }

    Value named()
    {
        const ExpressionError here{Code::UnknownName, m_at, lengthOfNext()};
        const std::string_view written = m_variables ? namesAt(m_text, m_at) : m_text.substr(m_at, here.length);
        const std::string name = m_variables ? plainName(written) : '=' + std::string(written);
        const Constant *const constant = found(kConstants, name);
        const Function *const function = found(kFunctions, name);
        if (!m_variables && !constant && !function)
            return m_names ? given() : here;
        m_at = m_variables ? behindTemplate(m_text, m_at + written.size()) : m_at + written.size();
        skipBlanks();
        const std::size_t opened = m_at;
        const bool isEmptyCall = m_variables && take({"("}) && take({")"}); // glm::pi<float>()
        if (!isEmptyCall)
            m_at = opened;
        if (constant && (!m_variables || isEmptyCall || next() != '('))
            return Term{constant->value};
        if (m_variables && !isEmptyCall && next() != '(')
            return variable(written, here);
        if (!function)
            return here;
        if (next() != '(')
            return ExpressionError{Code::NotCalled, here.place, here.length};
        const Value argument = parenthesis();
        if (!argument)
            return argument;
        if (name == "=sqrt" && argument->value < 0.0)
            return ExpressionError{Code::RootOfNegative, here.place, here.length};
        return Term{function->value(argument->value)};
    }

    Value variable(std::string_view name, const ExpressionError &here)
    {
        constexpr int kOneDeeper = 12; // a variable may refer to itself
        const std::optional<std::string_view> text = (*m_variables)(name);
        if (!text)
            return here;
        Parser inner(*text, m_names, m_variables, m_levels + kOneDeeper, m_operands);
        const Value value = inner.whole();
        m_operands = inner.m_operands;
        if (!value)
            return here;
        if (!inner.m_wholeQuotient.empty())
            m_wholeQuotient = inner.m_wholeQuotient;
        return Term{value->value, text->find_first_not_of("0123456789 ") == text->npos};
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
        return Term{*value};
    }

    bool isAtPoint() const { return next() == '.' || (next() == ',' && !m_variables); }

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
        if (isAtPoint()) {
            const std::size_t point = m_at;
            const bool isComma = next() == ',';
            const bool isOfThousands = hasDigits && digits.size() <= 3 && digits.front() != '0';
            ++m_at;
            digits += '.';
            const std::size_t before = digits.size();
            hasDigits = takeDigits() || hasDigits;
            if (isComma && isOfThousands && digits.size() == before + 3 && !isAtPoint())
                return ExpressionError{Code::AmbiguousComma, point, m_at - point};
        }
        if (!hasDigits)
            return ExpressionError{Code::MissingNumber, start, 1};
        if (isAtPoint())
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
        bool isWhole = digits.find_first_not_of("0123456789") == digits.npos;
        if (m_variables)
            isWhole = takeSuffix() && isWhole;
        skipBlanks();
        return Term{value, isWhole};
    }

    /// @return whether a number with this suffix may be whole
    bool takeSuffix()
    {
        for (const std::string_view type : {"_f32", "_f64", "f32", "f64"}) {
            if (m_text.substr(m_at).starts_with(type)) {
                m_at += type.size();
                return false;
            }
        }
        const std::size_t start = m_at;
        m_at = std::min(m_text.find_first_not_of("fFlLdDmMuU", m_at), m_text.size());
        return m_text.substr(start, m_at - start).find_first_not_of("lLuU") == m_text.npos;
    }

    std::string_view m_text;
    const Names &m_names;
    const Variables *m_variables;
    int m_levels;    ///< nesting of parentheses, signs and variables
    int m_operands;  ///< so far
    int m_depth = 0; ///< open parentheses
    std::size_t m_at = 0;
    std::string_view m_wholeQuotient;
};

} // namespace

Expected<double, ExpressionError> evaluate(std::string_view text, const Names &names)
{
    const Value value = Parser(text, names).whole();
    if (!value)
        return value.error();
    return value->value;
}

std::optional<SourceNumber> sourceNumber(std::string_view text, const Variables &variables)
{
    constexpr std::string_view kToRadians = ".to_radians()"; // Rust
    text = trimmed(text);
    const bool areDegrees = text.ends_with(kToRadians);
    if (areDegrees)
        text.remove_suffix(kToRadians.size());
    const Names none;
    Parser parser(text, none, &variables);
    const Value value = parser.whole();
    if (!value)
        return std::nullopt;
    return SourceNumber{areDegrees ? radiansFromDegrees(value->value) : value->value, parser.wholeQuotient()};
}

} // namespace unprojector::base
