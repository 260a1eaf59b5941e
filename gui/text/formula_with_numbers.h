#pragma once

#include <QString>
#include <QStringList>

#include <map>
#include <vector>

namespace unprojector::gui {

/// A term of a formula.
struct FormulaTerm {
    QString symbol;            ///< markup: "v<sub>x</sub>"
    QString name;              ///< "Distance of the near plane, eye units"
    QStringList value;         ///< the inserted value: one number, or the three of a column; empty: the symbol stays
    std::vector<double> exact; ///< the same with all digits; empty if it is not a number
};

/// The terms by their short names in templates.
using FormulaTerms = std::map<QString, FormulaTerm>;

/// A formula in symbols and with its numbers, both from one template:
///
///   {([px] − [vx])*([r] − [l])*[z] | [width] · [n]} + {[l]*[z] | [n]}
///
/// `[n]` is a term, `*` a product (a space between symbols, × between numbers), `{a | b}` a
/// fraction. Negative numbers get parentheses if their sign would follow an operator. In the
/// markup, the same as formula_markup's, a term is written `<t n>…</t>`, and a column `{x; y; z}`.
class FormulaWithNumbers {
public:
    /// @param number  "(9)", or empty
    /// @param result  the term on the left
    /// @param condition  text after the symbols: ", 0 ≤ t ≤ 1"
    /// @pre all named terms are given
    FormulaWithNumbers(const QString &number, const QString &result, const QString &expression,
                       const FormulaTerms &terms, const QString &condition = {});

    const QString &number() const { return m_number; }
    /// "z = …", markup.
    const QString &symbols() const { return m_symbols; }
    /// "= … = 5", markup.
    const QString &numbers() const { return m_numbers; }
    /// Both lines for the clipboard, fractions as a / b and columns as (x, y, z).
    const QString &text() const { return m_text; }

private:
    QString m_number, m_symbols, m_numbers, m_text;
};

} // namespace unprojector::gui
