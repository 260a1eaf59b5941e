#pragma once

#include "core/base/csv.h"
#include "core/base/number_text.h"
#include "core/cli/rows/csv_line.h"

#include <cmath>
#include <string>
#include <string_view>
#include <vector>

namespace unprojector::cli {

enum class RowFormat {
    Csv,
    SafeCsv, ///< with texts as in base::CellTexts::SpreadsheetSafe
    Jsonl
};

/// A cell as passedCell returns it, behind an apostrophe where its text is a formula.
inline std::string safeCell(std::string cell)
{
    if (base::isFormula(unquoted(cell)))
        cell.insert(cell.find_first_not_of(" \t\""), 1, '\'');
    return cell;
}

/// Writes rows of numbers, cell by cell: comma-separated values, or one JSON object per line. Names
/// are in the format's form: in JSON they are already escaped.
class RowWriter {
public:
    RowWriter(RowFormat format, const std::vector<std::string> &names, std::string &output)
        : m_format(format), m_names(names), m_output(output)
    {
    }

    void header()
    {
        if (m_format == RowFormat::Jsonl)
            return;
        for (const std::string &name : m_names) {
            startCell();
            m_output += name;
        }
        endRow();
    }

    void number(double value)
    {
        startCell();
        base::appendNumber(m_output, value);
    }

    /// Writes a number; an empty cell for NaN and infinity.
    void numberOrNothing(double value)
    {
        if (std::isfinite(value))
            number(value);
        else
            nothing();
    }

    void nothing()
    {
        startCell();
        if (m_format == RowFormat::Jsonl)
            m_output += "null";
    }

    /// Writes a text of any characters.
    void text(std::string_view text)
    {
        startCell();
        if (m_format == RowFormat::Jsonl) {
            m_output += jsonOfText(text);
            return;
        }
        const std::string_view apostrophe = m_format == RowFormat::SafeCsv && base::isFormula(text) ? "'" : "";
        if (text.find_first_of(",\"\r\n") == std::string_view::npos && trimmed(text).size() == text.size()) {
            m_output.append(apostrophe).append(text);
            return;
        }
        m_output.append("\"").append(apostrophe);
        for (const char c : text)
            m_output.append(c == '"' ? 2 : 1, c == '\n' || c == '\r' ? ' ' : c);
        m_output += '"';
    }

    /// Copies a cell of the input unchanged.
    void passed(std::string_view cell)
    {
        startCell();
        m_output += m_format == RowFormat::Jsonl     ? jsonOfCell(cell)
                    : m_format == RowFormat::SafeCsv ? safeCell(passedCell(cell))
                                                     : passedCell(cell);
    }

    /// Copies a cell of the input where a number is expected: in JSON null where it is none.
    void passedNumber(std::string_view cell)
    {
        if (m_format != RowFormat::Jsonl)
            return passed(cell);
        const std::string json = jsonOfCell(trimmed(unquoted(cell)));
        startCell();
        m_output += json.starts_with('"') ? "null" : json;
    }

    void endRow()
    {
        if (m_format == RowFormat::Jsonl)
            m_output += '}';
        m_output += '\n';
        m_column = 0;
    }

private:
    void startCell()
    {
        if (m_format != RowFormat::Jsonl) {
            if (m_column > 0)
                m_output += ',';
        } else {
            m_output += m_column > 0 ? ",\"" : "{\"";
            m_output += m_names[m_column];
            m_output += "\":";
        }
        ++m_column;
    }

    RowFormat m_format;
    const std::vector<std::string> &m_names;
    std::string &m_output;
    std::size_t m_column = 0;
};

} // namespace unprojector::cli
