#pragma once

#include <cstddef>
#include <initializer_list>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace unprojector::report {

/// Letters of one look in a line.
struct Piece {
    enum class Look { Plain, Strong, Code };

    std::string text; ///< UTF-8
    Look look = Look::Plain;
    std::string target = {}; ///< of a link: an id such as "help:picking", whose meaning the page knows
};

/// A line of text. A string is one.
class Text {
public:
    Text(std::string plain) : m_pieces{{std::move(plain)}} {}
    Text(const char *plain) : Text(std::string(plain)) {}
    Text(std::initializer_list<Piece> pieces) : m_pieces(pieces) {}

    const std::vector<Piece> &pieces() const { return m_pieces; }

private:
    std::vector<Piece> m_pieces;
};

/// A sentence about the section's subject.
struct Paragraph {
    Text text;
};

/// Something that the user should know, apart from the answer.
struct Note {
    Text text;
};

/// A line for each value, its name in front.
struct Rows {
    struct Row {
        Text name, value;
    };

    std::size_t nameColumns = 0; ///< of a terminal, that all names of the section's kind fit in
    std::vector<Row> rows = {};

    void add(Text name, Text value) { rows.push_back({std::move(name), std::move(value)}); }
};

/// Cells in columns, numbers to the right.
struct Table {
    std::vector<Text> head;
    std::vector<std::vector<Text>> rows; ///< each as long as the head
};

/// Lines of a program.
struct Code {
    std::vector<std::string> lines;
};

using Block = std::variant<Paragraph, Note, Rows, Table, Code>;

struct Section {
    Text title; ///< may be empty
    std::vector<Block> blocks = {};
    bool isApart = false; ///< a blank line stands before it in a terminal
    std::string id = {};  ///< the target of links to this section; may be empty
};

/// An answer in words and numbers: made once, for a terminal and for a page.
using Report = std::vector<Section>;

/// The report for a terminal: titles and notes at the margin, the rest indented by two. A text that holds a
/// control character is made printable. Ends with a line end unless it is empty.
std::string asText(const Report &report);

/// The report as a fragment of HTML that Qt's rich text and browsers show. A link's address is its
/// target.
std::string asHtml(const Report &report);

} // namespace unprojector::report
