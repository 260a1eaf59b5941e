#include "core/base/json.h"

#include "core/base/number_text.h"
#include "core/base/printable.h"
#include "core/base/text_scanner.h"
#include "core/base/translation.h"
#include "core/base/utf8.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <optional>
#include <unordered_set>
#include <utility>
#include <variant>

namespace unprojector::base {
namespace {

constexpr double kExact = 9007199254740992.0; // 2^53: all smaller whole numbers are doubles
constexpr std::string_view kBetweenWords = " \t\r\n,:{}[]\"", kBlank = kBetweenWords.substr(0, 4);

/// The same digits as in all other texts: the library's differ in the last one if two are equally
/// near.
std::string floatText(double value)
{
    if (!std::isfinite(value)) // JSON has no such number
        return "null";
    std::string digits = shortestText(value);
    if (digits.find_first_of(".e") != std::string::npos)
        return digits;
    if (std::abs(value) < kExact)
        return digits + ".0";
    std::array<char, 32> power; // written in full, most of its digits would be meaningless
    const auto end = std::to_chars(power.data(), power.data() + power.size(), value, std::chars_format::scientific);
    return {power.data(), end.ptr};
}

std::string_view keptDigits(const Json &json)
{
    const Json::binary_t &bytes = json.get_binary();
    return {reinterpret_cast<const char *>(bytes.data()), bytes.size()};
}

/// Throws an Error at the first mistake.
class Parser {
public:
    /// @param isKept  false: values are only checked, and null
    Parser(std::string_view text, bool isKept, std::size_t mostLevels = kMostJsonLevels, IsUnread isUnread = {})
        : m_text(text), m_isKept(isKept), m_mostLevels(mostLevels), m_isUnread(std::move(isUnread))
    {
        constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
        if (m_text.starts_with(kByteOrderMark))
            m_text.remove_prefix(kByteOrderMark.size());
    }

    Json document()
    {
        if (m_text.find_first_not_of(kBlank) == m_text.npos)
            throw Error{tr("the file is empty")};
        if (m_text.starts_with("\xFF\xFE") || m_text.starts_with("\xFE\xFF"))
            fail(0, tr("the file is UTF-16; save it as UTF-8"));
        if (const std::size_t zero = m_text.find('\0'); zero != m_text.npos)
            fail(zero, tr("unexpected zero byte"));
        if (const std::size_t bad = firstNotUtf8(m_text); bad != m_text.npos)
            fail(bad, tr("a byte here is not UTF-8; save the file as UTF-8"));
        Json json = value({});
        if (next() != '\0')
            failHere(marked("%1 follows the end"));
        return json;
    }

    /// Goes to a value, and sets the place of an error there. Throws if there is none.
    void find(const JsonPath &path, Error &error)
    {
        for (const JsonStep &step : path) {
            const bool isMember = step.key.data() != nullptr;
            expect(isMember ? '{' : '[', "");
            for (std::size_t index = 0; isMember ? key() != step.key : index < step.index; ++index) {
                value({});
                expect(',', "");
            }
        }
        next();
        setPosition(error, m_at);
    }

private:
    void setPosition(Error &error, std::size_t at) const
    {
        const std::string_view before = m_text.substr(0, at);
        error.line = 1 + static_cast<int>(std::count(before.begin(), before.end(), '\n'));
        error.column = static_cast<int>(before.size() - before.rfind('\n')); // npos is -1
    }
    [[noreturn]] void fail(std::size_t at, std::string text) const
    {
        Error error{std::move(text)};
        setPosition(error, at);
        throw error;
    }
    /// @param english  with %1 for the word, the text in quotes or the sign here
    [[noreturn]] void failHere(const char *english) const
    {
        if (m_at == m_text.size())
            fail(m_at, tr("the file ends too early; a bracket or a value is missing"));
        const std::string_view rest = m_text.substr(m_at);
        const std::size_t quote = rest.find('"', 1);
        constexpr std::size_t kMost = 24;
        fail(m_at, tr(english, printableBeginning(rest.front() != '"'  ? word()
                                                  : quote == rest.npos ? rest
                                                                       : rest.substr(0, quote + 1),
                                                  kMost)));
    }

    /// The next character after blanks; 0 at the end.
    char next()
    {
        m_at = std::min(m_text.find_first_not_of(kBlank, m_at), m_text.size());
        return m_at < m_text.size() ? m_text[m_at] : '\0';
    }
    bool skip(char c)
    {
        const bool isIt = next() == c;
        m_at += isIt ? 1U : 0U;
        return isIt;
    }
    void expect(char c, const char *english)
    {
        if (!skip(c))
            failHere(english);
    }
    /// The word, the number or the sign here.
    std::string_view word() const
    {
        return m_text.substr(m_at, std::max<std::size_t>(m_text.find_first_of(kBetweenWords, m_at) - m_at, 1));
    }

    /// @param key  whose value it is, through arrays
    Json value(std::string_view key)
    {
        const char first = next();
        if (first == '{' || first == '[')
            return structure(key);
        if (first == '"')
            return text();
        const std::string_view all = first != '\0' ? word() : std::string_view();
        Json literal;
        if (first == '-' || (first >= '0' && first <= '9'))
            literal = number(all);
        else if (all == "true" || all == "false")
            literal = all == "true";
        else if (all != "null")
            failHere(marked("%1 found where a value is expected"));
        m_at += all.size();
        return literal;
    }

    Json structure(std::string_view key)
    {
        if (m_level == m_mostLevels)
            fail(m_at, tr("brackets are nested deeper than %1 levels", m_mostLevels));
        ++m_level;
        const bool isObject = m_text[m_at++] == '{';
        const char end = isObject ? '}' : ']';
        Json json = isObject ? Json::object() : Json::array();
        std::unordered_set<std::string> keys;
        if (!skip(end)) {
            do {
                if (isObject)
                    readMember(json, keys, key);
                else if (Json element = value(key); m_isKept)
                    json.push_back(std::move(element));
            } while (skip(','));
            expect(end, isObject ? marked("%1 found where \",\" or \"}\" is expected")
                                 : marked("%1 found where \",\" or \"]\" is expected"));
        }
        --m_level;
        return json;
    }

    void readMember(Json &object, std::unordered_set<std::string> &keys, std::string_view keyOfObject)
    {
        next();
        const std::size_t at = m_at;
        std::string name = key();
        auto &members = object.get_ref<Json::object_t &>();
        bool isNew = false;
        if (constexpr std::size_t kFew = 16; m_isKept && members.size() < kFew) {
            const auto isIt = [&name](const auto &member) { return member.first == name; };
            isNew = std::none_of(members.begin(), members.end(), isIt);
        } else { // a search for each would take time quadratic in their number
            for (std::size_t i = keys.size(); i < members.size(); ++i)
                keys.insert(members.begin()[static_cast<std::ptrdiff_t>(i)].first);
            isNew = keys.insert(name).second;
        }
        if (!isNew && !m_mayRepeat)
            fail(at, tr("the key \"%1\" is here for the second time", printableBeginning(name, kMostShown)));
        const bool mayRepeat = m_mayRepeat;
        m_mayRepeat = mayRepeat || (m_isUnread && m_isUnread(keyOfObject, name));
        Json member = value(name);
        m_mayRepeat = mayRepeat;
        // The vector's own emplace_back: the map's searches for the key first, linearly.
        if (m_isKept)
            static_cast<Json::object_t::Container &>(members).emplace_back(std::move(name), std::move(member));
    }

    /// A key and the colon after it.
    std::string key()
    {
        if (next() != '"')
            failHere(marked("%1 found where a key in double quotes is expected"));
        std::string name = text();
        expect(':', marked("%1 found where \":\" is expected"));
        return name;
    }

    /// A number, as written if a double has fewer digits.
    Json number(std::string_view digits) const
    {
        if (!isJsonNumber(digits))
            failHere(marked("%1 is not a number; write one such as 1, -0.5 or 2e3"));
        if (const auto whole = numberIn<std::uint64_t>(digits))
            return *whole;
        if (const auto negative = numberIn<std::int64_t>(digits))
            return *negative;
        std::optional<double> value = numberIn<double>(digits);
        if (!value) { // too large, or so small that it is 0: the library knows which
            const Json zero = Json::parse(digits, nullptr, false);
            if (zero.is_discarded())
                fail(m_at, tr("%1 is too large for a number", printableBeginning(digits, kMostShown)));
            value = zero.get<double>();
        }
        constexpr std::ptrdiff_t kDigitsOfDoubles = 15; // any number with this many survives
        const auto end = std::find_if(digits.begin(), digits.end(), [](char c) { return c == 'e' || c == 'E'; });
        if (std::count_if(digits.begin(), end, [](char c) { return c >= '0'; }) <= kDigitsOfDoubles
            || floatText(*value) == digits)
            return *value;
        return Json::binary(std::vector<std::uint8_t>(digits.begin(), digits.end()));
    }

    std::string text()
    {
        const std::size_t begin = m_at++;
        bool isPlain = true;
        for (; m_at < m_text.size() && m_text[m_at] != '"'; ++m_at) {
            if (static_cast<unsigned char>(m_text[m_at]) < ' ')
                fail(m_at, tr("a text in quotes holds a line break, a tab or another control character; write \\n, "
                              "\\t or \\u and its number"));
            if (m_text[m_at] == '\\') {
                isPlain = false;
                ++m_at;
            }
        }
        if (m_at++ >= m_text.size())
            fail(m_text.size(), tr("a text in quotes does not end; close it with \""));
        const std::string_view whole = m_text.substr(begin, m_at - begin);
        if (isPlain)
            return std::string(whole.substr(1, whole.size() - 2));
        try {
            return Json::parse(whole).get<std::string>();
        } catch (const Json::parse_error &error) {
            const std::string_view reason = error.what();
            const auto has = [reason](const char *part) { return reason.find(part) != reason.npos; };
            fail(begin + error.byte - 1,
                 has("surrogate")
                     ? tr("half of a \\u surrogate pair is missing; write both halves or the character itself")
                 : has("4 hex")
                     ? tr("\\u lacks its 4 hexadecimal digits")
                     : tr("a text in quotes holds a backslash that JSON does not know; write \\\\ for a backslash"));
        }
    }

    static constexpr std::size_t kMostShown = 60;
    std::string_view m_text;
    std::size_t m_at = 0;
    const bool m_isKept;
    std::size_t m_level = 0;
    const std::size_t m_mostLevels;
    const IsUnread m_isUnread;
    bool m_mayRepeat = false; ///< inside a value that is not read
};

std::string leafText(const Json &leaf)
{
    return leaf.is_binary()         ? std::string(keptDigits(leaf))
           : leaf.is_number_float() ? floatText(leaf.get<double>())
                                    : leaf.dump(-1, ' ', false, Json::error_handler_t::replace);
}

/// Appends everything on one line; stops early beyond `limit` characters.
/// @param blank  after commas and colons
/// @return whether it fits
bool appendLine(std::string &text, const Json &json, std::string_view blank, std::size_t limit = std::string::npos)
{
    if (!json.is_structured()) {
        text += leafText(json);
        return text.size() <= limit;
    }
    text += json.is_object() ? '{' : '[';
    for (auto it = json.begin(); it != json.end(); ++it) {
        if (it != json.begin())
            text.append(",").append(blank);
        if (json.is_object())
            text.append(leafText(it.key())).append(":").append(blank);
        if (!appendLine(text, *it, blank, limit))
            return false;
    }
    text += json.is_object() ? '}' : ']';
    return text.size() <= limit;
}

/// @param reserved  used characters of the line: the indent, the key before, the comma after
void append(std::string &text, const Json &json, std::size_t indent, std::size_t reserved)
{
    constexpr std::size_t kLineLength = 120;
    const std::size_t before = text.size();
    const bool isShort = !json.is_structured() || json.empty();
    const bool mayFit = indent > 0 && reserved < kLineLength;
    if (isShort || mayFit) {
        if (appendLine(text, json, " ", isShort ? text.npos : before + kLineLength - reserved))
            return;
        text.resize(before);
    }
    text += json.is_object() ? "{\n" : "[\n";
    for (auto it = json.begin(); it != json.end(); ++it) {
        if (it != json.begin())
            text += ",\n";
        text.append(indent + 2, ' ');
        const std::string key = json.is_object() ? leafText(it.key()) + ": " : std::string();
        text += key;
        append(text, *it, indent + 2, indent + 3 + key.size());
    }
    text.append("\n").append(indent, ' ');
    text += json.is_object() ? '}' : ']';
}

/// Finds the first text that is not UTF-8.
bool hasBadText(const Json &json, JsonPath &path)
{
    if (json.is_string())
        return firstNotUtf8(json.get_ref<const std::string &>()) != std::string::npos;
    std::size_t index = 0;
    for (auto it = json.begin(); json.is_structured() && it != json.end(); ++it) {
        path.push_back({json.is_object() ? std::string_view(it.key()) : std::string_view(), index++});
        if (firstNotUtf8(path.back().key) != std::string::npos || hasBadText(*it, path))
            return true;
        path.pop_back();
    }
    return false;
}

std::string pathText(const JsonPath &path)
{
    std::string text;
    for (const JsonStep &step : path) {
        if (step.key.data() == nullptr)
            text += '[' + std::to_string(step.index) + ']';
        else
            text.append(text.empty() ? "" : ".").append(step.key);
    }
    return text;
}

} // namespace

JsonValue::JsonValue(Json json) : m_json(json.is_null() ? nullptr : std::make_shared<Json>(std::move(json))) {}

const Json &JsonValue::json() const
{
    static const Json null;
    return m_json ? *m_json : null;
}

Json &JsonValue::edit()
{
    if (!m_json || m_json.use_count() > 1)
        m_json = std::make_shared<Json>(json());
    return *m_json;
}

bool operator==(const JsonValue &a, const JsonValue &b)
{
    return a.m_json == b.m_json || a.json() == b.json();
}

Expected<Json, Error> parseJson(std::string_view text, const std::string &file)
{
    try {
        return Parser(text, true).document();
    } catch (Error &error) {
        error.file = file;
        return error;
    }
}

Done checkJson(std::string_view text, std::size_t mostLevels, const IsUnread &isUnread)
{
    try {
        Parser(text, false, mostLevels, isUnread).document();
        return std::monostate{};
    } catch (const Error &error) {
        return error;
    }
}

bool setPlace(Error &error, std::string_view text, const JsonPath &path)
{
    error.subject = pathText(path);
    try {
        Parser(text, false).find(path, error);
        return true;
    } catch (const Error &) {
        return false;
    }
}

bool isJsonNumber(std::string_view text)
{
    std::size_t at = 0;
    const auto digits = [&] {
        const std::size_t from = at;
        while (at < text.size() && text[at] >= '0' && text[at] <= '9')
            ++at;
        return at - from;
    };
    const auto has = [&](std::string_view any) {
        const bool is = at < text.size() && any.find(text[at]) != std::string_view::npos;
        at += is ? 1 : 0;
        return is;
    };
    has("-");
    const std::size_t first = at;
    if (const std::size_t count = digits(); count == 0 || (count > 1 && text[first] == '0'))
        return false;
    if (has(".") && digits() == 0)
        return false;
    if (has("eE")) {
        has("+-");
        if (digits() == 0)
            return false;
    }
    return at == text.size();
}

bool isJsonNumber(const Json &json)
{
    return json.is_number() || json.is_binary();
}

double valueOfJsonNumber(const Json &json)
{
    // Of a number kept as written, only one that is too small for a double has no value: the parser
    // rejects numbers that are too large.
    return json.is_binary() ? numberIn<double>(keptDigits(json)).value_or(0.0) : json.get<double>();
}

Json jsonNumber(double value)
{
    if (value == std::floor(value) && std::abs(value) < kExact && !(value == 0.0 && std::signbit(value)))
        return static_cast<std::int64_t>(value);
    return value;
}

Expected<std::string, Error> readableJson(const Json &json)
{
    if (JsonPath path; hasBadText(json, path))
        return Error{tr("the name is not UTF-8 and cannot be written; rename it"), pathText(path)};
    std::string text;
    append(text, json, 0, 0);
    return text + '\n';
}

std::string jsonLine(const Json &json)
{
    std::string text;
    appendLine(text, json, " ");
    return text;
}

std::string compactJson(const Json &json)
{
    std::string text;
    appendLine(text, json, {});
    return text;
}

} // namespace unprojector::base
