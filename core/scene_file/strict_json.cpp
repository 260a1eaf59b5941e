#include "core/scene_file/strict_json.h"

#include "core/base/json_number.h"
#include "core/base/json_syntax.h"
#include "core/base/translation.h"
#include "core/scene_file/scene_file.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <iterator>
#include <unordered_set>
#include <utility>

namespace unprojector::scene_file {
using namespace geometry;

namespace {

using Json = nlohmann::ordered_json;

/// Iterates over characters and exposes the position: the parser's events have none.
class CountingIterator {
public:
    using iterator_category = std::input_iterator_tag;
    using value_type = char;
    using difference_type = std::ptrdiff_t;
    using pointer = const char *;
    using reference = const char &;

    CountingIterator(const char *at, const char **reached) : m_at(at), m_reached(reached) {}
    reference operator*() const { return *m_at; }
    CountingIterator &operator++()
    {
        ++m_at;
        *m_reached = std::max(*m_reached, m_at);
        return *this;
    }
    CountingIterator operator++(int)
    {
        CountingIterator before = *this;
        ++*this;
        return before;
    }
    friend bool operator==(const CountingIterator &a, const CountingIterator &b) { return a.m_at == b.m_at; }

private:
    const char *m_at;
    const char **m_reached;
};

class Builder {
public:
    explicit Builder(std::string_view text) : m_text(text), m_reached(text.data()) {}

    CountingIterator begin() { return {m_text.data(), &m_reached}; }
    CountingIterator end() { return {m_text.data() + m_text.size(), &m_reached}; }
    Json takeDocument() { return std::move(m_document); }
    const std::optional<SceneFileError> &error() const { return m_error; }

    // ---- what nlohmann::json::sax_parse calls, by its names ----
    // NOLINTBEGIN(readability-identifier-naming)
    bool null() { return add(nullptr) != nullptr; }
    bool boolean(bool value) { return add(value) != nullptr; }
    bool number_integer(Json::number_integer_t value) { return add(value) != nullptr; }
    bool number_unsigned(Json::number_unsigned_t value) { return add(value) != nullptr; }
    bool number_float(Json::number_float_t value, const std::string &written)
    {
        return add(base::readJsonNumber(value, written)) != nullptr;
    }
    bool string(std::string &value) { return add(std::move(value)) != nullptr; }
    bool binary(Json::binary_t &) { return false; }
    bool start_object(std::size_t) { return open(Json::object()); }
    bool start_array(std::size_t) { return open(Json::array()); }
    bool end_object() { return close(); }
    bool end_array() { return close(); }
    bool key(std::string &value)
    {
        Level &level = m_levels.back();
        if (!level.keys.insert(value).second)
            return fail(SceneFileErrorCode::DuplicateKey, keyBegin(), value);
        level.key = std::move(value);
        return true;
    }
    bool parse_error(std::size_t position, const std::string &lastToken, const nlohmann::detail::exception &error)
    {
        base::JsonMistake mistake = base::jsonMistake(m_text, position, lastToken, error.what());
        // Numbers that overflow have a separate error.
        if (error.id == 406)
            return fail(SceneFileErrorCode::NumberTooLarge, mistake.at, lastToken);
        return failSyntax(mistake.at, std::move(mistake.text));
    }
    // NOLINTEND(readability-identifier-naming)

    bool failSyntax(std::size_t at, std::string detail)
    {
        fail(SceneFileErrorCode::Syntax, at, {});
        m_error->detail = std::move(detail);
        return false;
    }

private:
    struct Level {
        Json *value;
        std::string key;
        std::unordered_set<std::string> keys;
    };

    /// The position of a value in the document; never null.
    Json *add(Json value)
    {
        if (m_levels.empty()) {
            m_document = std::move(value);
            return &m_document;
        }
        Level &level = m_levels.back();
        if (level.value->is_array()) {
            level.value->push_back(std::move(value));
            return &level.value->back();
        }
        // Uses the vector's own emplace_back: the map's searches for the key first, linearly.
        auto &members = level.value->get_ref<Json::object_t &>();
        static_cast<Json::object_t::Container &>(members).emplace_back(std::move(level.key), std::move(value));
        return &members.back().second;
    }

    bool open(Json value)
    {
        if (m_levels.size() == kMostSceneLevels) {
            fail(SceneFileErrorCode::TooDeep, offset() - 1, {});
            m_error->limit = double(kMostSceneLevels);
            return false;
        }
        m_levels.push_back({add(std::move(value)), {}, {}});
        return true;
    }

    bool close()
    {
        m_levels.pop_back();
        return true;
    }

    std::size_t offset() const { return static_cast<std::size_t>(m_reached - m_text.data()); }

    /// The position of the key just read: its closing quote is the last character read; its opening
    /// one is the previous unescaped quote.
    std::size_t keyBegin() const
    {
        for (std::size_t at = offset() - 1; at-- > 0;) {
            if (m_text[at] != '"')
                continue;
            std::size_t backslashes = 0;
            while (backslashes < at && m_text[at - 1 - backslashes] == '\\')
                ++backslashes;
            if (backslashes % 2 == 0)
                return at;
        }
        return 0;
    }

    bool fail(SceneFileErrorCode code, std::size_t at, const std::string &found)
    {
        const std::string_view before = m_text.substr(0, at);
        const std::size_t lineBegin = before.rfind('\n') + 1; // npos + 1 is 0
        m_error = SceneFileError{};
        m_error->code = code;
        m_error->line = 1 + static_cast<std::size_t>(std::count(before.begin(), before.end(), '\n'));
        m_error->column = 1 + before.size() - lineBegin;
        m_error->found = shortened(found);
        return false;
    }

    std::string_view m_text;
    const char *m_reached;
    Json m_document;
    std::vector<Level> m_levels; ///< open brackets; the pointers stay valid while they are open
    std::optional<SceneFileError> m_error;
};

} // namespace

std::string shortened(std::string_view text, std::size_t most)
{
    if (text.size() <= most)
        return std::string(text);
    std::size_t end = most;
    while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0) == 0x80)
        --end;
    return std::string(text.substr(0, end)) + "\xE2\x80\xA6";
}

Result<Json, SceneFileError> parseStrictJson(std::string_view text)
{
    return parseStrictJson(text, kMostSceneBytes);
}

Result<Json, SceneFileError> parseStrictJson(std::string_view text, std::size_t mostBytes)
{
    SceneFileError error;
    if (text.size() > mostBytes) {
        error.code = SceneFileErrorCode::TooLarge;
        error.limit = double(mostBytes);
        return error;
    }
    constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
    if (text.substr(0, kByteOrderMark.size()) == kByteOrderMark)
        text.remove_prefix(kByteOrderMark.size());
    if (text.find_first_not_of(" \t\r\n") == std::string_view::npos) {
        error.code = SceneFileErrorCode::EmptyFile;
        return error;
    }
    Builder builder(text);
    if (text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF")) {
        builder.failSyntax(0, base::tr("the file is UTF-16; save it as UTF-8"));
        return *builder.error();
    }
    // The library takes a zero byte for the end and would ignore the text after it.
    if (const std::size_t zero = text.find('\0'); zero != std::string_view::npos) {
        builder.failSyntax(zero, base::tr("unexpected zero byte"));
        return *builder.error();
    }
    const bool parsed = Json::sax_parse(builder.begin(), builder.end(), &builder);
    if (builder.error())
        return *builder.error();
    if (!parsed)
        return error;
    return builder.takeDocument();
}

} // namespace unprojector::scene_file
