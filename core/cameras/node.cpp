#include "core/cameras/node.h"

#include "core/base/text_scanner.h"
#include "core/base/translation.h"
#include "core/cameras/reader_parts.h"
#include "core/cameras/roles.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace unprojector::cameras {
using base::Json;
using base::tr;

namespace {

const Json *memberOf(const Json *object, std::string_view key)
{
    if (!object || !object->is_object())
        return nullptr;
    const auto found = object->find(key);
    return found == object->end() ? nullptr : &*found;
}

/// The elements with a tag of XML; null for other values.
const Json *firstElement(const Json *value)
{
    const bool isIt = value && value->is_array() && !value->empty() && memberOf(&value->front(), "@");
    return isIt ? &value->front() : nullptr;
}

bool addNumbers(const Json *value, Numbers &numbers)
{
    constexpr std::size_t kMost = std::size_t{1} << 20;
    if (const Json *element = memberOf(value, "@") ? value : firstElement(value))
        value = memberOf(element, "");
    if (!value || numbers.size() > kMost)
        return false;
    const auto add = [&](std::optional<double> number) {
        numbers.push_back(number.value_or(NAN));
        return std::isfinite(numbers.back());
    };
    if (base::isJsonNumber(*value))
        return add(base::valueOfJsonNumber(*value));
    if (value->is_array())
        return std::all_of(value->begin(), value->end(), [&](const Json &one) { return addNumbers(&one, numbers); });
    if (!value->is_string())
        return false;
    auto text = value->get<std::string>();
    std::replace(text.begin(), text.end(), ',', ' ');
    base::TextScanner scanner(text);
    for (std::string_view word = scanner.nextWord(); !word.empty(); word = scanner.nextWord()) {
        if (!add(base::doubleFromWord(word)))
            return false;
    }
    return true;
}

/// The line of an offset, from 1.
std::size_t lineAt(std::string_view text, std::size_t offset)
{
    return 1 + std::size_t(std::count(text.begin(), text.begin() + std::ptrdiff_t(offset), '\n'));
}

std::string leafOf(Keys path)
{
    return std::string(path.substr(path.rfind('/') + 1));
}

} // namespace

Words split(std::string_view text, char at)
{
    Words parts;
    for (std::size_t end = text.find(at); end != text.npos; end = text.find(at)) {
        parts.push_back(text.substr(0, end));
        text.remove_prefix(end + 1);
    }
    parts.push_back(text);
    return parts;
}

glm::dvec3 vectorOf(const Numbers &numbers, std::size_t from)
{
    return {numbers[from], numbers[from + 1], numbers[from + 2]};
}

Node::Node(const Reading &reading, const Json &json, base::JsonPath path)
    : m_reading(&reading), m_json(&json), m_path(std::move(path))
{
}

Node::Node(const Reading &reading, std::shared_ptr<const NamedValues> values, std::string_view text)
    : m_reading(&reading), m_values(std::move(values)), m_text(text)
{
}

Node::operator bool() const
{
    return m_values || (m_json && !m_json->is_null());
}

const Json &Node::json() const
{
    static const Json none;
    return m_json ? *m_json : none;
}

std::string Node::key() const
{
    const base::JsonStep &last = m_path.back();
    return last.key.data() ? std::string(last.key) : std::to_string(last.index);
}

const Json *Node::member(Keys path) const
{
    const Json *at = m_json;
    if (path.empty())
        return at;
    for (const std::string_view key : split(path, '/')) {
        const Json *element = firstElement(at);
        at = memberOf(element ? element : at, key);
    }
    return at;
}

Node Node::operator[](Keys path) const
{
    const Json *at = member(path), *element = firstElement(at);
    Node node = *this;
    node.m_json = element ? element : at;
    node.m_path = pathTo(path);
    return node;
}

base::JsonPath Node::pathTo(Keys path) const
{
    base::JsonPath steps = m_path;
    const Json *at = m_json;
    for (const std::string_view key : split(path, '/')) {
        const Json *element = firstElement(at), *object = element ? element : at;
        const Json *value = memberOf(object, key);
        if (value)
            steps.push_back({object->find(key).key()}); // the document's own key, which lives as long as the node
        at = value;
    }
    return steps;
}

std::string Node::tag() const
{
    return m_path.size() < 2 ? std::string() : std::string(m_path[m_path.size() - 2].key);
}

std::vector<Node> Node::list(Keys path) const
{
    std::vector<Node> nodes;
    const Json *all = member(path);
    if (!all || !all->is_structured())
        return nodes;
    base::JsonPath inner = pathTo(path);
    inner.emplace_back();
    for (auto one = all->begin(); one != all->end(); ++one) {
        inner.back() = all->is_object() ? base::JsonStep{one.key()} : base::JsonStep{{}, nodes.size()};
        nodes.emplace_back(*m_reading, *one, inner);
    }
    return nodes;
}

std::vector<Node> Node::elements() const
{
    return json().is_array() ? list("") : std::vector{*this};
}

std::map<std::string, Node> Node::index(Keys path, Keys key) const
{
    std::map<std::string, Node> nodes;
    for (const Node &node : list(path))
        nodes.emplace(key.empty() ? node.key() : node.word(key), node);
    return nodes;
}

bool Node::has(Keys keys) const
{
    for (const std::string_view key : split(keys, '|')) {
        if (m_values ? m_values->has({plain(key)}) : !key.empty() && member(key))
            return true;
    }
    return false;
}

bool Node::holds(Keys keys) const
{
    for (const std::string_view key : split(keys, '|')) {
        const Json *value = member(key);
        if (value && !value->empty())
            return true;
    }
    return false;
}

std::string Node::word(Keys keys) const
{
    for (const std::string_view key : split(keys, '|')) {
        if (m_values) {
            if (const NamedValue *value = m_values->find({plain(key)}))
                return value->word;
            continue;
        }
        const Json *value = key.empty() ? nullptr : member(key);
        if (const Json *element = firstElement(value))
            value = memberOf(element, "");
        if (value)
            return value->is_string() ? std::string(base::trimmed(value->get_ref<const std::string &>()))
                                      : base::compactJson(*value);
    }
    return {};
}

bool Node::isTrue(Keys keys) const
{
    if (m_values)
        return m_values->isTrue(plain(keys));
    return word(keys) == "true" || number(keys).value_or(0.0) != 0.0;
}

Numbers Node::numbers(Keys keys, std::size_t fewest) const
{
    for (const std::string_view one : split(keys, '|')) {
        const Words sequence = split(one, ' ');
        if (m_reading) {
            for (const std::string_view key : sequence)
                m_reading->used.insert(plain(leafOf(key)));
        }
        const std::size_t each = std::max<std::size_t>(fewest / sequence.size(), 1);
        Numbers found;
        bool isWhole = true;
        for (const std::string_view key : sequence) {
            if (!m_values) {
                isWhole = isWhole && addNumbers(member(key), found);
                continue;
            }
            const std::string name = plain(key);
            Numbers own = each == 3   ? m_values->numbers({name}, 3, {"x", "y", "z"})
                          : each == 4 ? m_values->numbers({name}, 4, {"x", "y", "z", "w"})
                                      : m_values->numbers({name}, each);
            if (each == 1 && sequence.size() > 1 && !own.empty())
                own.resize(1);
            isWhole = isWhole && !own.empty() && (sequence.size() == 1 || own.size() == each);
            found.insert(found.end(), own.begin(), own.end());
        }
        if (isWhole && found.size() >= fewest)
            return found;
    }
    return {};
}

std::optional<double> Node::number(Keys keys) const
{
    const Numbers found = numbers(keys);
    return found.size() == 1 || (m_values && !found.empty()) ? std::optional(found[0]) : std::nullopt;
}

double Node::number(Keys keys, double otherwise) const
{
    const auto value = number(keys);
    if (!value && !m_values && holds(keys))
        fail(tr("it is no number; give one, or leave it out"), keys);
    return value.value_or(otherwise);
}

Numbers Node::needed(Keys keys, std::size_t count) const
{
    const Words sequence = split(keys, ' ');
    Numbers found;
    for (const std::string_view key : sequence) {
        const std::size_t each = count / sequence.size();
        Numbers own = numbers(key, each);
        if (own.empty())
            own = numbers(key);
        if (m_values && each == 1 && !own.empty())
            own.resize(1);
        if (own.size() != each)
            fail(tr("%1 needs %2 numbers; it has %3", key.empty() ? tag() : leafOf(split(key, '|')[0]), each,
                    own.size()),
                 key);
        found.insert(found.end(), own.begin(), own.end());
    }
    return found;
}

std::string Node::unused() const
{
    if (!m_reading)
        return {};
    std::string names;
    const auto add = [&](const std::string &name, std::size_t count) {
        if (count > 1 && roleOf(name, count))
            names += (names.empty() ? "" : ", ") + tr("%1 (%2 numbers)", name, count);
    };
    const auto &used = m_reading->used;
    for (const NamedValue &value : m_values ? m_values->all() : std::vector<NamedValue>()) {
        if (std::none_of(used.begin(), used.end(), [&](const std::string &name) { return value.isNamed(name); }))
            add(value.written, value.numbers.size());
    }
    for (auto item = json().begin(); json().is_object() && item != json().end(); ++item) {
        Numbers numbers;
        if (!used.contains(plain(item.key())) && addNumbers(&*item, numbers))
            add(item.key(), numbers.size());
    }
    return names;
}

glm::dvec3 Node::vector(Keys keys) const
{
    return vectorOf(needed(keys, 3));
}

std::size_t Node::lineOf(Keys key) const
{
    if (m_values) {
        const NamedValue *value = m_values->find({plain(key)});
        return value ? lineAt(m_reading->text.text, std::size_t(m_text.data() - m_reading->text.text.data())) - 1
                           + value->line
                     : 0;
    }
    const std::string &text = m_reading->json.empty() ? m_reading->text.text : m_reading->json;
    if (const Json *offset = memberOf(m_json, "@"); offset && offset->is_number_unsigned())
        return lineAt(text, offset->get<std::size_t>());
    base::Error place;
    base::setPlace(place, text, pathTo(key));
    return std::size_t(place.line);
}

void Node::fail(std::string reason, Keys key) const
{
    if (!m_reading)
        throw base::Error{.text = std::move(reason)};
    m_reading->fail(std::move(reason), lineOf(split(key, '|')[0]));
}

namespace {

void addTrails(const Node &element, std::string_view tag, Trail &trail, std::vector<Trail> &found)
{
    for (auto member = element.json().begin(); member != element.json().end(); ++member) {
        for (const Node &inner : member->is_array() ? element.list(member.key()) : Trail()) {
            trail.push_back(inner);
            if (member.key() == tag)
                found.push_back(trail);
            addTrails(inner, tag, trail, found);
            trail.pop_back();
        }
    }
}

constexpr std::size_t kMostLevels = 256; // readers recurse
constexpr std::size_t kMostNames = 256;  // in an element; they are searched one by one
constexpr const char *kBlanks = " \t\r\n";

/// A text with the five entities of XML replaced.
std::string unescaped(std::string_view text)
{
    constexpr std::array<std::pair<std::string_view, char>, 5> kEntities{
        {{"&lt;", '<'}, {"&gt;", '>'}, {"&amp;", '&'}, {"&quot;", '"'}, {"&apos;", '\''}}};
    std::string result;
    for (std::size_t at = text.find('&'); at != text.npos; at = text.find('&')) {
        result += text.substr(0, at);
        text.remove_prefix(at);
        const auto known = std::find_if(kEntities.begin(), kEntities.end(),
                                        [&](const auto &entity) { return text.starts_with(entity.first); });
        result += known == kEntities.end() ? '&' : known->second;
        text.remove_prefix(known == kEntities.end() ? 1 : known->first.size());
    }
    return result.append(text);
}

/// Reads an XML text from its beginning on.
class XmlReader {
public:
    explicit XmlReader(const NamedText &text) : m_name(text.name), m_text(text.text) {}

    Json document()
    {
        Json document = Json::object();
        m_open = {{"", &document}};
        for (std::size_t begin = 0; begin < m_text.size(); begin = m_offset) {
            m_offset = std::min(m_text.find('<', begin), m_text.size());
            addText(unescaped(m_text.substr(begin, m_offset - begin)));
            if (skip("<!--"))
                until("-->");
            else if (skip("<![CDATA["))
                addText(until("]]>"));
            else if (skip("<!")) // a document's type, with or without declarations inside it
                until(until(">").find('[') == m_text.npos ? "" : "]>");
            else if (skip("<?"))
                until("?>");
            else if (skip("</"))
                close(base::trimmed(until(">")));
            else if (skip("<"))
                open();
        }
        if (m_open.size() > 1)
            failWithout("</" + m_open.back().first + '>');
        return document;
    }

private:
    [[noreturn]] void fail(std::string reason) const
    {
        throw base::Error{
            .text = std::move(reason), .file = m_name, .line = static_cast<int>(lineAt(m_text, m_offset))};
    }
    [[noreturn]] void failWithout(std::string_view part) const
    {
        fail(tr("the XML is damaged: %1 is missing", base::quoted(part)));
    }

    bool skip(std::string_view mark)
    {
        const bool isNext = m_text.substr(m_offset).starts_with(mark);
        m_offset += isNext ? mark.size() : 0;
        return isNext;
    }

    /// The text before a mark; moves behind the mark.
    std::string_view until(std::string_view mark)
    {
        const std::size_t begin = m_offset, end = m_text.find(mark, begin);
        if (end == m_text.npos)
            failWithout(mark);
        m_offset = end + mark.size();
        return m_text.substr(begin, end - begin);
    }

    /// The name before one of these characters, and blanks behind it.
    std::string name(const char *ends)
    {
        const std::size_t begin = m_offset;
        m_offset = std::min(m_text.find_first_of(ends, begin), m_text.size());
        const std::string_view name = base::trimmed(m_text.substr(begin, m_offset - begin));
        skipBlanks();
        return std::string(name);
    }
    void skipBlanks() { m_offset = std::min(m_text.find_first_not_of(kBlanks, m_offset), m_text.size()); }

    Json &member(Json &element, const std::string &name)
    {
        if (element.size() > kMostNames || m_open.size() > kMostLevels)
            fail(tr("the XML has more than %1 levels, or names in an element", kMostLevels));
        return element[name.substr(name.find(':') + 1)];
    }

    void addText(std::string_view text)
    {
        if (const std::string_view own = base::trimmed(text); !own.empty()) {
            Json &all = (*m_open.back().second)[""];
            if (!all.is_string())
                all = "";
            all.get_ref<std::string &>() += own;
        }
    }

    void open()
    {
        Json element = Json::object({{"@", m_offset}});
        const std::string tag = name(" \t\r\n/>");
        bool isEmpty = skip("/>");
        while (!isEmpty && !skip(">")) {
            Json &value = member(element, name("=<>"));
            if (!skip("="))
                failWithout("=");
            skipBlanks();
            const std::string_view quote = m_text.substr(m_offset).starts_with('\'') ? "'" : "\"";
            if (!skip(quote))
                failWithout(quote);
            value = unescaped(until(quote));
            skipBlanks();
            isEmpty = skip("/>");
        }
        Json &list = member(*m_open.back().second, tag);
        if (!list.is_array()) // an attribute of the same name
            list = Json::array();
        list.push_back(std::move(element));
        if (!isEmpty)
            m_open.emplace_back(tag, &list.back());
    }

    void close(std::string_view tag)
    {
        if (m_open.size() == 1 || tag != m_open.back().first)
            failWithout((m_open.size() == 1 ? '<' + std::string(tag) : "</" + m_open.back().first) + '>');
        m_open.pop_back();
    }

    const std::string &m_name;
    std::string_view m_text;
    std::size_t m_offset = 0;
    std::vector<std::pair<std::string, Json *>> m_open; ///< while one is open, no element joins its siblings
};

void refuseLong(const NamedText &text)
{
    constexpr std::size_t kMostBytes = std::size_t{64} << 20;
    if (text.text.size() > kMostBytes)
        throw base::Error{.text = tr("longer than %1 MiB; give the file of one camera", kMostBytes >> 20),
                          .file = text.name};
}

/// The first character of a text that is no blank.
char firstOf(std::string_view text)
{
    const std::size_t begin = text.find_first_not_of(" \t\r\n", text.starts_with("\xEF\xBB\xBF") ? 3 : 0);
    return begin == text.npos ? '\0' : text[begin];
}

} // namespace

std::vector<Trail> trailsTo(const Node &document, std::string_view tag)
{
    std::vector<Trail> found;
    Trail trail;
    addTrails(document, tag, trail, found);
    std::sort(found.begin(), found.end(),
              [](const Trail &a, const Trail &b) { return a.back().number("@") < b.back().number("@"); });
    return found;
}

bool isJson(std::string_view text)
{
    return firstOf(text) == '{' || firstOf(text) == '[';
}

bool isXml(std::string_view text)
{
    return firstOf(text) == '<';
}

std::string withoutComments(std::string text)
{
    for (std::size_t at = 0; at < text.size(); ++at) {
        const std::string_view rest = std::string_view(text).substr(at), end = rest.starts_with("//") ? "\n" : "*/";
        if (text[at] == '"') { // a text in quotes
            while (++at < text.size() && text[at] != '"')
                at += text[at] == '\\' ? 1U : 0U;
        } else if (rest.starts_with("//") || rest.starts_with("/*")) {
            const std::size_t count = std::min(rest.find(end, 2), rest.size() - end.size()) + end.size();
            const auto begin = text.begin() + std::ptrdiff_t(at);
            std::replace_if(
                begin, begin + std::ptrdiff_t(count), [](char c) { return c != '\n'; }, ' ');
        }
    }
    return text;
}

Json parsedJson(const NamedText &text)
{
    refuseLong(text);
    auto parsed = base::parseJson(text.text);
    if (!parsed)
        throw base::Error{.text = parsed.error().text, .file = text.name, .line = parsed.error().line};
    return std::move(parsed).value();
}

Json parsedXml(const NamedText &text)
{
    refuseLong(text);
    return XmlReader(text).document();
}

} // namespace unprojector::cameras
