#include "core/cameras/xml.h"

#include "core/base/text_scanner.h"
#include "core/base/translation.h"
#include "core/cameras/reader_parts.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace unprojector::cameras {
using base::tr;
using Json = nlohmann::ordered_json;

namespace {

constexpr std::size_t kMostBytes = std::size_t{64} << 20;
constexpr std::size_t kMost =
    256; // levels, because readers recurse; names in an element, which are searched one by one
constexpr const char *kBlanks = " \t\r\n";

/// The line of an offset, from 1.
std::size_t lineAt(std::string_view text, std::size_t offset)
{
    return 1 + std::size_t(std::count(text.begin(), text.begin() + std::ptrdiff_t(offset), '\n'));
}

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
        if (element.size() > kMost || m_open.size() > kMost)
            fail(tr("the XML has more than %1 levels, or names in an element", kMost));
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

void addPaths(const Json &element, std::string_view tag, XmlPath &path, std::vector<XmlPath> &found)
{
    for (auto member = element.begin(); member != element.end(); ++member) {
        if (!member->is_array())
            continue;
        for (const Json &inner : *member) {
            path.push_back({member.key(), &inner});
            if (member.key() == tag)
                found.push_back(path);
            addPaths(inner, tag, path, found);
            path.pop_back();
        }
    }
}

std::size_t offsetOf(const Json &element)
{
    const Json *offset = memberOf(element, "@");
    return offset && offset->is_number_unsigned() ? offset->get<std::size_t>() : 0;
}

Json parsedXml(const NamedText &text)
{
    if (text.text.size() > kMostBytes)
        throw base::Error{.text = tr("longer than %1 MiB; give the file of one camera", kMostBytes >> 20),
                          .file = text.name};
    return XmlReader(text).document();
}

} // namespace

Json xmlWith(const NamedText &text, JsonKeys words)
{
    std::string_view begin = text.text;
    if (begin.starts_with("\xEF\xBB\xBF"))
        begin.remove_prefix(3);
    const bool isXml = base::trimmed(begin.substr(0, 1024)).starts_with('<');
    const auto has = [&](const char *word) { return text.text.find(word) != text.text.npos; };
    return isXml && std::all_of(words.begin(), words.end(), has) ? parsedXml(text) : Json();
}

const Json &children(const Json &element, std::string_view tag)
{
    static const Json none;
    const Json *list = memberOf(element, tag);
    return list && list->is_array() ? *list : none;
}

const Json &child(const Json &element, JsonKeys path)
{
    static const Json none;
    const Json *at = &element;
    for (const char *tag : path) {
        const Json &list = children(*at, tag);
        if (list.empty())
            return none;
        at = &list.front();
    }
    return *at;
}

std::vector<XmlPath> pathsTo(const Json &document, std::string_view tag)
{
    XmlPath path;
    std::vector<XmlPath> found;
    addPaths(document, tag, path, found);
    std::sort(found.begin(), found.end(), [](const XmlPath &a, const XmlPath &b) {
        return offsetOf(*a.back().element) < offsetOf(*b.back().element);
    });
    return found;
}

std::string xmlText(const Json &element, std::string_view key)
{
    const Json *member = memberOf(element, key);
    if (member && member->is_array())
        member = memberOf(member->front(), "");
    return member && member->is_string() ? std::string(base::trimmed(member->get_ref<const std::string &>()))
                                         : std::string();
}

std::vector<double> xmlNumbers(const Json &element, std::string_view key)
{
    std::string text = xmlText(element, key);
    std::replace(text.begin(), text.end(), ',', ' ');
    base::TextScanner scanner(text);
    std::vector<double> numbers;
    for (std::string_view word = scanner.nextWord(); !word.empty(); word = scanner.nextWord()) {
        const auto number = base::doubleFromWord(word);
        if (!number || !std::isfinite(*number))
            return {};
        numbers.push_back(*number);
    }
    return numbers;
}

double xmlNumber(const Json &element, std::string_view key, double otherwise)
{
    const std::vector<double> numbers = xmlNumbers(element, key);
    return numbers.size() == 1 ? numbers[0] : otherwise;
}

std::vector<double> neededXml(const Reading &reading, const Json &element, std::string_view key, std::size_t count)
{
    std::vector<double> numbers = xmlNumbers(element, key);
    if (numbers.size() != count)
        reading.fail(tr("%1 needs %2 numbers; it has %3", key, count, numbers.size()),
                     lineAt(reading.text.text, offsetOf(element)));
    return numbers;
}

glm::dvec3 neededXmlVector(const Reading &reading, const Json &element, std::string_view key)
{
    const std::vector<double> v = neededXml(reading, element, key, 3);
    return {v[0], v[1], v[2]};
}

} // namespace unprojector::cameras
