#include "core/cameras/outline.h"

#include "core/base/letters.h"
#include "core/base/source_text.h"
#include "core/cameras/scan.h"

#include <algorithm>
#include <optional>

namespace unprojector::cameras {

namespace {

constexpr std::string_view kLabels = " name label id camera_name serial key ";

bool isOfName(char c)
{
    return base::isLetter(c) || base::isDigit(c) || c == '.' || c == '-' || c == ':';
}

/// A name or value without its quotes.
std::string_view trimmed(std::string_view text)
{
    constexpr std::string_view kAround = " \t\r\"'";
    text.remove_prefix(std::min(text.find_first_not_of(kAround), text.size()));
    return text.substr(0, text.find_last_not_of(" \t\r\"',") + 1);
}

} // namespace

class OutlineReader {
public:
    OutlineReader(std::string_view text, Outline &outline) : m_text(text), m_outline(outline)
    {
        const std::size_t first = text.find_first_not_of(" \t\r\n\xEF\xBB\xBF");
        m_isXml = first != text.npos && text[first] == '<' && text.find("</") != text.npos;
    }

    void read()
    {
        for (m_at = 0; m_at < m_text.size();) {
            if (m_at == 0 || m_text[m_at - 1] == '\n')
                readLineStart();
            if (m_at < m_text.size())
                readOne();
        }
        const std::size_t last = m_text.find_last_not_of(" \t\r\n");
        const bool isCutOff =
            m_parentheses > 0 && last != m_text.npos && (base::isDigit(m_text[last]) || m_text[last] == ',');
        m_outline.m_isUnclosed = isInBrackets() || isCutOff;
    }

private:
    /// An open bracket, element or line.
    struct Open {
        char kind; ///< '{', '[', '<', 'y' of YAML, 's' of a section
        std::size_t node, column;
    };

    std::size_t current() const { return m_open.empty() ? 0 : m_open.back().node; }

    void change() { m_outline.m_changes.push_back({m_at, current()}); }

    void push(char kind, std::string_view name, bool isItem, std::size_t column = 0)
    {
        constexpr std::size_t kDeepest = 64; // deeper nesting stays in its parent
        std::size_t node = current();
        if (m_open.size() < kDeepest) {
            Outline::Node added{node, std::string(name)};
            const std::size_t index = m_outline.m_nodes.size();
            if (isItem) {
                auto &[firstItem, count] = m_outline.m_items.try_emplace({node, added.name}, index, 0).first->second;
                added.item = count++;
                added.isOfSeveral = added.item > 0;
                if (added.isOfSeveral)
                    m_outline.m_nodes[firstItem].isOfSeveral = true;
            }
            m_outline.m_nodes.push_back(std::move(added));
            node = index;
        }
        m_open.push_back({kind, node, column});
        change();
    }

    void pop()
    {
        m_open.pop_back();
        change();
    }

    bool isInBrackets() const
    {
        return std::ranges::any_of(m_open, [](const Open &open) { return open.kind == '{' || open.kind == '['; });
    }

    /// Sections and YAML's indentation, outside of brackets.
    void readLineStart()
    {
        if (m_isXml || isInBrackets())
            return;
        const std::size_t end = std::min(m_text.find('\n', m_at), m_text.size());
        std::string_view line = m_text.substr(m_at, end - m_at);
        line = line.substr(0, std::min(line.find(" #"), line.find("\t#")));
        const std::string_view content = trimmed(line);
        if (content.size() > 2 && content.front() == '[' && content.back() == ']' && base::isLetter(content[1])
            && content.find_first_of(",=") == content.npos) {
            while (!m_open.empty())
                pop();
            push('s', trimmed(content.substr(1, content.size() - 2)), false);
            m_at = end;
            return;
        }
        std::size_t column = line.find_first_not_of(" \t");
        if (column == line.npos || line[column] == '#')
            return;
        const bool isItem = line[column] == '-' && column + 1 < line.size() && line[column + 1] == ' ';
        const std::size_t dash = column;
        if (isItem)
            column = std::min(line.find_first_not_of(" \t", column + 1), line.size());
        const std::size_t colon = line.find(':', column);
        const std::string_view key = trimmed(line.substr(column, colon == line.npos ? 0 : colon - column));
        const bool isKey = !key.empty() && std::ranges::all_of(key, isOfName);
        if (!isKey)
            return; // numbers of the key above
        while (!m_open.empty() && m_open.back().kind == 'y' && m_open.back().column >= (isItem ? dash : column))
            pop();
        if (isItem)
            push('y', m_outline.m_nodes[current()].name, true, dash);
        const std::string_view value = trimmed(line.substr(colon + 1));
        noteLabel(key, value);
        if (value.empty() || value.front() == '!' || value.front() == '&') {
            m_at += colon; // the key stands outside
            push('y', key, false, column);
        }
    }

    void noteLabel(std::string_view key, std::string_view value)
    {
        Outline::Node &node = m_outline.m_nodes[current()];
        if (current() > 0 && node.label.empty() && !value.empty() && value.front() != '{' && value.front() != '['
            && base::isListed(kLabels, key))
            node.label = trimmed(value.substr(0, value.find_first_of(",}\n")));
    }

    void readOne()
    {
        const char c = m_text[m_at];
        if (m_isXml && c == '<')
            return readTag();
        if (!m_isXml && (c == '#' || m_text.substr(m_at).starts_with("//"))) { // a comment
            m_at = std::min(m_text.find('\n', m_at), m_text.size());
            return;
        }
        if (!m_isXml && m_text.substr(m_at).starts_with("/*")) {
            m_at = std::min(m_text.find("*/", m_at), m_text.size() - 1) + 1;
            return;
        }
        if (c == '"' || (c == '\'' && (m_at == 0 || !base::isLetter(m_text[m_at - 1])))) {
            const std::size_t end = m_text.find_first_of(c == '"' ? "\"\n" : "'\n", m_at + 1);
            if (end != m_text.npos && m_text[end] == c) {
                m_name = m_text.substr(m_at + 1, end - m_at - 1);
                m_at = end + 1;
                return;
            }
        }
        if (base::isLetter(c)) {
            const std::size_t begin = m_at;
            while (m_at < m_text.size() && (base::isLetter(m_text[m_at]) || base::isDigit(m_text[m_at])))
                ++m_at;
            m_name = m_text.substr(begin, m_at - begin);
            return;
        }
        ++m_at;
        if (c == '{' || c == '[') {
            const bool isItem = c == '{' && !m_open.empty() && m_open.back().kind == '[';
            --m_at;
            push(c, isItem || m_name.empty() ? std::string(m_outline.m_nodes[current()].name) : std::string(m_name),
                 isItem);
            ++m_at;
            m_name = {};
        } else if ((c == '}' || c == ']') && !m_open.empty()) {
            const char opening = c == '}' ? '{' : '[';
            if (m_open.back().kind == opening)
                pop();
            else
                m_outline.m_isOverclosed = true;
            m_name = {};
        } else if (c == '}' || c == ']') {
            m_outline.m_isOverclosed = true;
        } else if (c == '(' || c == ')') {
            m_parentheses = std::max(m_parentheses + (c == '(' ? 1 : -1), 0);
        } else if (c == ':' || c == '=') {
            constexpr std::size_t kLongest = 80; // of a label
            if (isInBrackets())
                noteLabel(m_name, trimmed(m_text.substr(m_at, kLongest)));
        } else if (c == ',' || c == ';' || c == '\n' || base::isDigit(c)) {
            m_name = c == '\n' ? m_name : std::string_view();
        }
    }

    void readTag()
    {
        const std::size_t end = std::min(m_text.find('>', m_at), m_text.size() - 1);
        std::string_view tag = m_text.substr(m_at + 1, end - m_at - 1);
        const bool isClosing = tag.starts_with('/'), isNone = tag.starts_with('?') || tag.starts_with('!');
        if (isClosing && !m_open.empty()) {
            m_at = end;
            pop();
        } else if (!isClosing && !isNone) {
            const bool isAlone = tag.ends_with('/');
            const std::string_view name = tag.substr(0, tag.find_first_of(" \t\r\n/"));
            push('<', name, true);
            for (const std::string_view label : {"label", "name", "id"}) {
                const std::size_t at = tag.find(' ' + std::string(label) + "=\"");
                const std::size_t begin = at == tag.npos ? at : at + label.size() + 3;
                if (begin != tag.npos && m_outline.m_nodes[current()].label.empty())
                    m_outline.m_nodes[current()].label = tag.substr(begin, tag.find('"', begin) - begin);
            }
            m_at = end;
            if (isAlone)
                pop();
        }
        m_at = end + 1;
    }

    std::string_view m_text;
    Outline &m_outline;
    bool m_isXml = false;
    std::size_t m_at = 0;
    std::string_view m_name; ///< the last one, where it may be a heading
    int m_parentheses = 0;   ///< that are open
    std::vector<Open> m_open;
};

Outline::Outline(std::string_view text)
{
    const std::string read = withoutRemarks(text);
    OutlineReader(read, *this).read();
}

std::size_t Outline::nodeAt(std::size_t at) const
{
    const auto next = std::upper_bound(m_changes.begin(), m_changes.end(), at,
                                       [](std::size_t place, const Change &change) { return place < change.at; });
    return next == m_changes.begin() ? 0 : (next - 1)->node;
}

std::vector<std::size_t> Outline::pathTo(std::size_t index) const
{
    std::vector<std::size_t> path{index};
    while (path.back() != 0)
        path.push_back(m_nodes[path.back()].parent);
    std::reverse(path.begin(), path.end());
    return path;
}

std::string Outline::nameOf(std::size_t index) const
{
    const Node &node = m_nodes[index];
    if (!node.label.empty())
        return node.label;
    return node.isOfSeveral ? std::to_string(node.item) : node.name;
}

} // namespace unprojector::cameras
