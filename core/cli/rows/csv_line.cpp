#include "core/cli/rows/csv_line.h"

#include "core/base/json.h"

#include <nlohmann/json.hpp>

#include <algorithm>

namespace unprojector::cli {
namespace {

bool isBlank(char c)
{
    return c == ' ' || c == '\t' || c == '\r';
}

/// Quotes of a cell: none at its start, ending with the cell, or never closed.
enum class Quotes { None, Closed, Open };

Quotes quotesOf(std::string_view cell)
{
    cell = trimmed(cell);
    if (cell.empty() || cell.front() != '"')
        return Quotes::None;
    std::size_t quote = cell.find('"', 1);
    while (quote != std::string_view::npos && quote + 1 < cell.size() && cell[quote + 1] == '"')
        quote = cell.find('"', quote + 2);
    return quote == cell.size() - 1 && cell.size() > 1 ? Quotes::Closed : Quotes::Open;
}

std::string replaced(std::string_view text, std::string_view from, std::string_view to)
{
    std::string result;
    for (std::size_t at = text.find(from); at != std::string_view::npos; at = text.find(from)) {
        result.append(text.substr(0, at)).append(to);
        text.remove_prefix(at + from.size());
    }
    return result.append(text);
}

} // namespace

std::string_view trimmed(std::string_view text)
{
    while (!text.empty() && isBlank(text.front()))
        text.remove_prefix(1);
    while (!text.empty() && isBlank(text.back()))
        text.remove_suffix(1);
    return text;
}

std::string_view unquoted(std::string_view text)
{
    text = trimmed(text);
    if (text.size() >= 2 && text.front() == '"' && text.back() == '"')
        text = trimmed(text.substr(1, text.size() - 2));
    return text;
}

std::size_t cellEnd(std::string_view line, std::size_t start)
{
    const std::size_t text = line.find_first_not_of(" \t", start);
    if (text != std::string_view::npos && line[text] == '"') {
        std::size_t quote = line.find('"', text + 1);
        while (quote != std::string_view::npos && quote + 1 < line.size() && line[quote + 1] == '"')
            quote = line.find('"', quote + 2); // a doubled quote is part of the text
        if (quote != std::string_view::npos)
            start = quote;
    }
    return std::min(line.find(',', start), line.size());
}

RowEnd rowEnd(std::string_view text, std::size_t start)
{
    const std::size_t lineEnd = std::min(text.find('\n', start), text.size());
    // Fast path: nearly all rows have no quotes and end with their line.
    if (text.substr(start, lineEnd - start).find('"') == std::string_view::npos)
        return {lineEnd};
    const auto behindBlanks = [text](std::size_t at) {
        while (at < text.size() && isBlank(text[at]))
            ++at;
        return at;
    };
    for (std::size_t cell = 0;; ++cell) {
        std::size_t at = behindBlanks(start);
        if (at < text.size() && text[at] == '"') {
            std::size_t quote = text.find('"', at + 1);
            while (quote != std::string_view::npos && quote + 1 < text.size() && text[quote + 1] == '"')
                quote = text.find('"', quote + 2);
            if (quote == std::string_view::npos)
                return {lineEnd, false, false, cell};
            at = behindBlanks(quote + 1);
            if (at < text.size() && text[at] != ',' && text[at] != '\n')
                return {lineEnd, false, true, cell};
        }
        at = std::min(text.find_first_of(",\n", at), text.size());
        if (at == text.size() || text[at] == '\n')
            return {at};
        start = at + 1;
    }
}

std::string_view rowAt(std::string_view text, std::size_t start)
{
    std::string_view row = text.substr(start, rowEnd(text, start).end - start);
    if (!row.empty() && row.back() == '\r')
        row.remove_suffix(1);
    return row;
}

std::string passedCell(std::string_view cell)
{
    return quotesOf(cell) == Quotes::Open ? '"' + replaced(cell, "\"", "\"\"") + '"' : std::string(cell);
}

std::string jsonOfText(std::string_view text)
{
    return base::compactJson(text);
}

std::string jsonOfCell(std::string_view cell)
{
    if (quotesOf(cell) == Quotes::Closed) {
        cell = trimmed(cell);
        return jsonOfText(replaced(cell.substr(1, cell.size() - 2), "\"\"", "\""));
    }
    if (trimmed(cell).empty())
        return "null";
    return base::isJsonNumber(trimmed(cell)) ? std::string(trimmed(cell)) : jsonOfText(cell);
}

} // namespace unprojector::cli
