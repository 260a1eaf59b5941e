#include "core/scene_code/code_template.h"

#include <algorithm>
#include <utility>

namespace unprojector::scene_code {
namespace {

/// The names that a part sees: those of its row, then those outside.
struct Scope {
    const Values &values;
    const Scope *outer;
};

class Filler {
public:
    explicit Filler(std::string_view source) : m_source(source) {}

    std::string filled(const Values &values)
    {
        const Scope scope{values, nullptr};
        if (const std::string_view tag = part(&scope); !tag.empty())
            fail(tag);
        return std::move(m_text);
    }

private:
    /// Writes the part that starts here, or skips it if there is no scope.
    /// @return the tag that ends it; empty at the end of the template
    std::string_view part(const Scope *scope)
    {
        for (;;) {
            const std::size_t start = m_at, open = std::min(m_source.find("<<", start), m_source.size());
            const std::size_t close = std::min(m_source.find(">>", open), m_source.size());
            const std::string_view tag =
                close < m_source.size() ? m_source.substr(open + 2, close - open - 2) : m_source.substr(open);
            m_at = std::min(close + 2, m_source.size());
            const bool isEnd = tag == "else" || tag.starts_with("else if ") || tag == "between" || tag == "end";
            const bool isIf = tag.starts_with("if "), isFor = tag.starts_with("for ");
            std::size_t end = open;
            if (isEnd || isIf || isFor) {
                const std::size_t line = m_source.substr(0, open).find_last_not_of(' ') + 1;
                if ((line == 0 || m_source[line - 1] == '\n') && m_source.substr(m_at).starts_with('\n')) {
                    end = line;
                    ++m_at;
                }
            }
            if (scope)
                m_text += m_source.substr(start, end - start);
            if (isEnd || open == m_source.size())
                return tag;
            if (isIf)
                choose(tag, scope);
            else if (isFor)
                repeat(tag, scope);
            else if (scope)
                m_text += value<std::string>(tag, *scope);
        }
    }

    void choose(std::string_view opening, const Scope *scope)
    {
        bool isChosen = false;
        std::string_view tag = opening;
        do {
            const bool isNow = scope && !isChosen && (tag == "else" || holds(tag, *scope));
            isChosen = isChosen || isNow;
            tag = part(isNow ? scope : nullptr);
        } while (tag.starts_with("else"));
        if (tag != "end")
            fail(opening);
    }

    void repeat(std::string_view opening, const Scope *scope)
    {
        const Rows rows = scope ? value<Rows>(opening.substr(4), *scope) : Rows{};
        const std::size_t start = m_at;
        for (std::size_t k = 0; k == 0 || k < rows.count; ++k) {
            const Values row = k < rows.count ? rows.at(k) : Values{};
            const Scope inner{row, scope};
            m_at = start;
            std::string_view tag = part(k < rows.count ? &inner : nullptr);
            if (tag == "between")
                tag = part(k + 1 < rows.count ? scope : nullptr);
            if (tag != "end")
                fail(opening);
        }
    }

    /// Returns whether the name of an "if not a" or "else if a" holds.
    bool holds(std::string_view tag, const Scope &scope)
    {
        std::string_view name = tag.substr(tag.find("if ") + 3);
        const bool isNot = name.starts_with("not ");
        name.remove_prefix(isNot ? 4 : 0);
        const auto *found = find(name, scope);
        if (!found)
            fail(tag);
        const auto *text = std::get_if<std::string>(found);
        const auto *rows = std::get_if<Rows>(found);
        const auto *flag = std::get_if<bool>(found);
        return isNot != ((text && !text->empty()) || (rows && rows->count > 0) || (flag && *flag));
    }

    template <class T>
    T value(std::string_view name, const Scope &scope)
    {
        if (const auto *found = std::get_if<T>(find(name, scope)))
            return *found;
        fail(name);
    }

    static const Values::mapped_type *find(std::string_view name, const Scope &scope)
    {
        const auto found = scope.values.find(name);
        if (found != scope.values.end())
            return &found->second;
        return scope.outer ? find(name, *scope.outer) : nullptr;
    }

    /// @param tag  within the source
    [[noreturn]] void fail(std::string_view tag) const
    {
        throw TemplateError{1 + std::size_t(std::count(m_source.data(), tag.data(), '\n')), std::string(tag)};
    }

    const std::string_view m_source;
    std::size_t m_at = 0;
    std::string m_text;
};

} // namespace

std::string filled(std::string_view source, const Values &values)
{
    return Filler(source).filled(values);
}

} // namespace unprojector::scene_code
