#include "core/report/report.h"

#include "core/base/columns.h"
#include "core/base/printable.h"
#include "core/base/translation.h"

#include <algorithm>
#include <string_view>

namespace unprojector::report {
using namespace base;
namespace {

constexpr std::string_view kIndent = "  ";

std::string plain(const Text &text)
{
    std::string all;
    for (const Piece &piece : text.pieces())
        all += printableLine(piece.text);
    return all;
}

struct AsText {
    std::string operator()(const Paragraph &paragraph) const { return line(plain(paragraph.text)); }
    std::string operator()(const Note &note) const { return tr("note: %1", plain(note.text)) + '\n'; }
    std::string operator()(const Rows &rows) const
    {
        std::string text;
        for (const auto &[name, value] : rows.rows)
            text += line(padded(plain(name), rows.nameColumns) + plain(value));
        return text;
    }
    std::string operator()(const Table &table) const
    {
        std::vector<std::vector<Text>> lines{table.head};
        lines.insert(lines.end(), table.rows.begin(), table.rows.end());
        std::vector<std::size_t> widths(table.head.size());
        for (const std::vector<Text> &cells : lines) {
            for (std::size_t k = 0; k < widths.size(); ++k)
                widths[k] = std::max(widths[k], columnsOf(plain(cells[k])));
        }
        std::string text;
        for (const std::vector<Text> &cells : lines) {
            std::string all;
            for (std::size_t k = 0; k < widths.size(); ++k)
                all += k == 0 ? padded(plain(cells[k]), widths[k])
                              : std::string(kIndent) + paddedLeft(plain(cells[k]), widths[k]);
            text += line(all);
        }
        return text;
    }
    std::string operator()(const Code &code) const
    {
        std::string text;
        for (const std::string &each : code.lines)
            text += line(printableLine(each));
        return text;
    }

    static std::string line(const std::string &text) { return std::string(kIndent) + text + '\n'; }
};

std::string escaped(std::string_view text)
{
    std::string result;
    for (const char c : text) {
        switch (c) {
        case '&': result += "&amp;"; break;
        case '<': result += "&lt;"; break;
        case '>': result += "&gt;"; break;
        case '"': result += "&quot;"; break;
        default: result += c;
        }
    }
    return result;
}

std::string html(const Text &text)
{
    std::string all;
    for (const Piece &piece : text.pieces()) {
        std::string letters = escaped(printableLine(piece.text));
        switch (piece.look) {
        case Piece::Look::Plain: break;
        case Piece::Look::Strong: letters = "<b>" + letters + "</b>"; break;
        case Piece::Look::Code: letters = "<code>" + letters + "</code>"; break;
        }
        all += piece.target.empty() ? letters : "<a href=\"" + escaped(piece.target) + "\">" + letters + "</a>";
    }
    return all;
}

struct AsHtml {
    std::string operator()(const Paragraph &paragraph) const { return "<p>" + html(paragraph.text) + "</p>\n"; }
    std::string operator()(const Note &note) const { return "<p><i>" + tr("note: %1", html(note.text)) + "</i></p>\n"; }
    std::string operator()(const Rows &rows) const
    {
        std::string text;
        for (const auto &[name, value] : rows.rows)
            text += "<tr><td>" + html(name) + "</td><td>" + html(value) + "</td></tr>\n";
        return "<table>\n" + text + "</table>\n";
    }
    std::string operator()(const Table &table) const
    {
        std::string text = row("th", table.head);
        for (const std::vector<Text> &cells : table.rows)
            text += row("td", cells);
        return "<table>\n" + text + "</table>\n";
    }
    std::string operator()(const Code &code) const
    {
        std::string text;
        for (const std::string &line : code.lines)
            text += escaped(printableLine(line)) + '\n';
        return "<pre>" + text + "</pre>\n";
    }

    static std::string row(const std::string &cell, const std::vector<Text> &cells)
    {
        std::string text = "<tr>";
        for (std::size_t k = 0; k < cells.size(); ++k)
            text +=
                '<' + cell + (k == 0 ? " align=\"left\">" : " align=\"right\">") + html(cells[k]) + "</" + cell + '>';
        return text + "</tr>\n";
    }
};

} // namespace

std::string asText(const Report &report)
{
    std::string text;
    for (const Section &section : report) {
        text += section.isApart ? "\n" : "";
        if (const std::string title = plain(section.title); !title.empty())
            text += title + '\n';
        for (const Block &block : section.blocks)
            text += std::visit(AsText{}, block);
    }
    return text;
}

std::string asHtml(const Report &report)
{
    std::string text;
    for (const Section &section : report) {
        if (!section.id.empty())
            text += "<a name=\"" + escaped(section.id) + "\"></a>";
        if (const std::string title = html(section.title); !title.empty())
            text += "<h3>" + title + "</h3>\n";
        for (const Block &block : section.blocks)
            text += std::visit(AsHtml{}, block);
    }
    return text;
}

} // namespace unprojector::report
