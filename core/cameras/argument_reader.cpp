#include "core/cameras/argument_reader.h"

#include "core/cameras/call_syntax.h"
#include "core/geometry/numbers.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <system_error>
#include <utility>

namespace unprojector::cameras {
using namespace geometry;
using namespace syntax;

namespace {

std::optional<double> constant(std::string_view name)
{
    constexpr std::array<std::pair<std::string_view, double>, 24> kConstants{{{"pi", kPi},
                                                                              {"d3dxpi", kPi},
                                                                              {"fracpi2", kPi / 2.0},
                                                                              {"fracpi3", kPi / 3.0},
                                                                              {"fracpi4", kPi / 4.0},
                                                                              {"mpi", kPi},
                                                                              {"xmpi", kPi},
                                                                              {"piv", kPi},
                                                                              {"pif", kPi},
                                                                              {"mpi2", kPi / 2.0},
                                                                              {"halfpi", kPi / 2.0},
                                                                              {"xmpidiv2", kPi / 2.0},
                                                                              {"piover2", kPi / 2.0},
                                                                              {"mpi4", kPi / 4.0},
                                                                              {"quarterpi", kPi / 4.0},
                                                                              {"xmpidiv4", kPi / 4.0},
                                                                              {"piover4", kPi / 4.0},
                                                                              {"xm2pi", 2.0 * kPi},
                                                                              {"twopi", 2.0 * kPi},
                                                                              {"tau", 2.0 * kPi},
                                                                              {"degtorad", kRadiansPerDegree},
                                                                              {"deg2rad", kRadiansPerDegree},
                                                                              {"radtodeg", 1.0 / kRadiansPerDegree},
                                                                              {"rad2deg", 1.0 / kRadiansPerDegree}}};
    const std::string looked = plain(name);
    const auto found =
        std::find_if(kConstants.begin(), kConstants.end(), [&looked](const auto &one) { return one.first == looked; });
    return found == kConstants.end() ? std::nullopt : std::optional(found->second);
}

/// The value of a known function of one argument; nothing for other functions.
std::optional<double> called(std::string_view name, double value)
{
    const std::string f = plain(name);
    for (const char *one : {"radians", "degtorad", "xmconverttoradians", "toradians", "degreestoradians", "deg2rad",
                            "qdegreestoradians"}) {
        if (f == one)
            return radiansFromDegrees(value);
    }
    for (const char *one : {"float", "double", "glfloat", "gldouble", "glclampd", "staticcast", "t"}) {
        if (f == one)
            return value;
    }
    if (f == "degrees" || f == "radtodeg" || f == "todegrees" || f == "xmconverttodegrees" || f == "radianstodegrees")
        return degreesFromRadians(value);
    if (f == "tan")
        return std::tan(value);
    if (f == "atan")
        return std::atan(value);
    if (f == "sqrt")
        return std::sqrt(value);
    return std::nullopt;
}

bool isTypeName(std::string_view name)
{
    const std::string type = plain(name);
    return type == "float" || type == "double" || type == "int" || type == "glfloat" || type == "gldouble"
           || type == "glint" || type == "glsizei" || type == "glclampd";
}

/// A parser for one expression.
class Expression {
public:
    Expression(std::string_view text, const std::vector<AssignmentText> &assignments, int depth)
        : m_text(text), m_assignments(assignments), m_depth(depth)
    {
    }

    std::optional<ArgumentNumber> read()
    {
        const std::optional<Term> value = sum();
        skip();
        if (!value || m_at != m_text.size() || !std::isfinite(value->value))
            return std::nullopt;
        return ArgumentNumber{value->value, std::move(m_wholeQuotient)};
    }

private:
    struct Term {
        double value = 0.0;
        bool isWhole = false; ///< made of whole numbers only, without a decimal point
    };

    void skip() { m_at = behindBlanks(m_text, m_at); }
    bool take(char c)
    {
        skip();
        const bool isHere = m_at < m_text.size() && m_text[m_at] == c;
        m_at += isHere ? 1 : 0;
        return isHere;
    }

    std::optional<Term> sum()
    {
        std::optional<Term> left = product();
        while (left) {
            const bool isPlus = take('+');
            if (!isPlus && !take('-'))
                break;
            const std::optional<Term> right = product();
            if (!right)
                return std::nullopt;
            left =
                Term{isPlus ? left->value + right->value : left->value - right->value, left->isWhole && right->isWhole};
        }
        return left;
    }

    std::optional<Term> product()
    {
        skip();
        const std::size_t start = m_at;
        std::optional<Term> left = factor();
        while (left) {
            const bool isTimes = take('*');
            if (!isTimes && !take('/'))
                break;
            const std::optional<Term> right = factor();
            if (!right)
                return std::nullopt;
            const bool isWhole = left->isWhole && right->isWhole;
            const double value = isTimes ? left->value * right->value : left->value / right->value;
            if (!isTimes && isWhole && value != std::trunc(value))
                m_wholeQuotient = trimmed(m_text.substr(start, m_at - start));
            left = Term{value, isWhole};
        }
        return left;
    }

    std::optional<Term> factor()
    {
        constexpr int kDeepest = 64;
        if (++m_depth > kDeepest)
            return std::nullopt;
        std::optional<Term> value;
        if (take('-')) {
            value = factor();
            if (value)
                value->value = -value->value;
        } else if (take('+')) {
            value = factor();
        } else if (take('(')) {
            value = inBrackets();
        } else if (m_at < m_text.size() && isLetter(m_text[m_at])) {
            value = named();
        } else {
            value = literal();
        }
        --m_depth;
        return value;
    }

    /// A sum in parentheses, or a cast: the type and its operand.
    std::optional<Term> inBrackets()
    {
        const std::size_t end = behindNames(m_text, behindBlanks(m_text, m_at));
        if (isTypeName(trimmed(m_text.substr(m_at, end - m_at)))) {
            const bool isWhole = plain(trimmed(m_text.substr(m_at, end - m_at))).find("int") != std::string::npos;
            m_at = end;
            std::optional<Term> value = take(')') ? factor() : std::nullopt;
            if (value && isWhole)
                return Term{std::trunc(value->value), true};
            if (value)
                value->isWhole = false;
            return value;
        }
        const std::optional<Term> value = sum();
        return take(')') ? value : std::nullopt;
    }

    std::optional<Term> named()
    {
        const std::size_t end = behindNames(m_text, m_at);
        const std::string_view names = m_text.substr(m_at, end - m_at);
        m_at = behindTemplate(m_text, end);
        const std::string name = lastName(names);
        if (take('(')) {
            if (take(')')) { // glm::pi<float>()
                const auto value = constant(name);
                return value ? std::optional(Term{*value}) : std::nullopt;
            }
            const std::optional<Term> argument = sum();
            const auto value = argument && take(')') ? called(name, argument->value) : std::nullopt;
            return value ? std::optional(Term{*value}) : std::nullopt;
        }
        if (const auto value = constant(name))
            return Term{*value};
        return variable(names);
    }

    /// A variable that is assigned exactly once in the text.
    std::optional<Term> variable(std::string_view name)
    {
        const AssignmentText *found = nullptr;
        for (const AssignmentText &one : m_assignments) {
            if (one.name != name)
                continue;
            if (found && found->value != one.value)
                return std::nullopt;
            found = &one;
        }
        if (!found)
            return std::nullopt;
        constexpr int kOneDeeper = 8; // a variable may refer to itself
        Expression inner(found->value, m_assignments, m_depth + kOneDeeper);
        const std::optional<ArgumentNumber> value = inner.read();
        if (!value)
            return std::nullopt;
        if (!value->wholeQuotient.empty())
            m_wholeQuotient = value->wholeQuotient;
        return Term{value->value, found->value.find_first_not_of("0123456789 ") == std::string::npos};
    }

    std::optional<Term> literal()
    {
        double value = 0.0;
        const char *const start = m_text.data() + m_at, *const end = m_text.data() + m_text.size();
        const auto [behind, error] = std::from_chars(start, end, value);
        if (error != std::errc{} || behind == start)
            return std::nullopt;
        const std::string_view digits = m_text.substr(m_at, std::size_t(behind - start));
        m_at += digits.size();
        bool isWhole = digits.find_first_not_of("0123456789") == digits.npos;
        constexpr std::string_view kSuffixes = "fFlLdDmMuU";
        while (m_at < m_text.size() && kSuffixes.find(m_text[m_at]) != kSuffixes.npos) {
            isWhole = isWhole && std::string_view("lLuU").find(m_text[m_at]) != std::string_view::npos;
            ++m_at;
        }
        return Term{value, isWhole};
    }

    std::string_view m_text;
    const std::vector<AssignmentText> &m_assignments;
    int m_depth;
    std::size_t m_at = 0;
    std::string m_wholeQuotient;
};

} // namespace

ArgumentReader::ArgumentReader(std::string_view text) : m_assignments(assignmentTexts(text)) {}

std::optional<ArgumentNumber> ArgumentReader::number(std::string_view argument) const
{
    // Rust: 45.0_f32.to_radians()
    constexpr std::string_view kToRadians = ".to_radians()";
    std::string_view text = trimmed(argument);
    const bool areDegrees = text.ends_with(kToRadians);
    if (areDegrees)
        text.remove_suffix(kToRadians.size());
    for (const std::string_view type : {"_f32", "_f64", "f32", "f64"}) {
        if (text.ends_with(type) && text.size() > type.size() && isDigit(text[text.size() - type.size() - 1]))
            text.remove_suffix(type.size());
    }
    std::optional<ArgumentNumber> number = Expression(text, m_assignments, 0).read();
    if (number && areDegrees)
        number->value = radiansFromDegrees(number->value);
    return number;
}

std::optional<glm::dvec3> ArgumentReader::vector(std::string_view argument) const
{
    std::string_view text = trimmed(argument);
    if (text.starts_with("new "))
        text = trimmed(text.substr(4));
    if (text.starts_with('&')) // D3DX takes pointers
        text = trimmed(text.substr(1));
    if (text.starts_with('-') && !text.starts_with("--")) {
        const auto opposite = vector(text.substr(1));
        return opposite ? std::optional(-*opposite) : std::nullopt;
    }
    const std::size_t end = behindNames(text, 0);
    const std::string_view names = text.substr(0, end);
    const std::size_t open = behindBlanks(text, behindTemplate(text, end));
    if (open == text.size()) {
        const std::string name = plain(lastName(names));
        if (name == "unitx" || name == "unity" || name == "unitz")
            return glm::dvec3(name == "unitx" ? 1.0 : 0.0, name == "unity" ? 1.0 : 0.0, name == "unitz" ? 1.0 : 0.0);
        if (name == "zero" || name == "one" || name == "up")
            return name == "up" ? glm::dvec3(0.0, 1.0, 0.0) : glm::dvec3(name == "one" ? 1.0 : 0.0);
        const AssignmentText *found = nullptr;
        for (const AssignmentText &one : m_assignments) {
            if (one.name != names)
                continue;
            if (found) // several assignments: only the program knows which value applies
                return std::nullopt;
            found = &one;
        }
        const bool isValue = found && found->value.find_first_of("({[") != std::string::npos;
        return isValue ? vector(found->value) : std::nullopt;
    }
    const bool isBracket = text[open] == '(' || text[open] == '{' || text[open] == '[';
    if (!isBracket || closing(text, open) != text.size() - 1)
        return std::nullopt;
    const std::vector<std::string> parts = separated(text.substr(open + 1, text.size() - open - 2));
    if (parts.empty())
        return glm::dvec3(0.0);
    if (parts.size() > 4 || parts.size() == 2)
        return std::nullopt;
    glm::dvec3 result(0.0);
    for (int i = 0; i < 3; ++i) {
        const auto value = number(parts[parts.size() == 1 ? 0 : std::size_t(i)]); // glm::vec3(1.0f) repeats its number
        if (!value)
            return std::nullopt;
        result[i] = value->value;
    }
    return result;
}

} // namespace unprojector::cameras
