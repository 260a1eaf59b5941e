#include "gui/text/formula_with_numbers.h"

#include <QRegularExpression>

#include <functional>

namespace unprojector::gui {
namespace {

QString withoutTags(QString markup)
{
    static const QRegularExpression tag(QStringLiteral("<[^>]*>"));
    return markup.remove(tag);
}

/// The notation for the parts of a template.
struct Writing {
    std::function<QString(const QString &term, bool isAfterParenthesis)> term;
    QString product;     ///< for `*`
    QString openProduct; ///< for `*` between `)` and `(`
    QString dot;         ///< for ` · `
    bool hasSlashes;     ///< fractions as a / b
};

/// Returns whether a sum is outside all parentheses and braces; with `orProduct` also for a product
/// or a fraction.
bool isComposed(const QString &expression, bool orProduct)
{
    int depth = 0;
    for (qsizetype i = 0; i < expression.size(); ++i) {
        const QChar c = expression[i];
        depth += c == u'(' || c == u'{' || c == u'[' ? 1 : c == u')' || c == u'}' || c == u']' ? -1 : 0;
        if (depth == 0 && (c == u'+' || c == u'−' || (orProduct && (c == u'*' || c == u'·' || c == u'}'))))
            return true;
    }
    return false;
}

qsizetype closing(const QString &text, qsizetype open)
{
    int depth = 0;
    for (qsizetype i = open; i < text.size(); ++i) {
        depth += text[i] == u'{' ? 1 : text[i] == u'}' ? -1 : 0;
        if (depth == 0)
            return i;
    }
    return text.size();
}

QString written(const QString &expression, const Writing &how)
{
    QString text;
    for (qsizetype i = 0; i < expression.size(); ++i) {
        const QChar c = expression[i];
        if (c == u'[') {
            const qsizetype end = expression.indexOf(u']', i);
            text += how.term(expression.mid(i + 1, end - i - 1), i > 0 && expression[i - 1] == u'(');
            i = end;
        } else if (c == u'{') {
            const qsizetype end = closing(expression, i);
            const QString inner = expression.mid(i + 1, end - i - 1);
            const QString above = inner.section(u'|', 0, 0).trimmed(), below = inner.section(u'|', 1).trimmed();
            const auto part = [&how](const QString &one, bool isComposedAlready) {
                const QString set = written(one, how);
                return isComposedAlready ? u'(' + set + u')' : set;
            };
            if (how.hasSlashes)
                text += part(above, isComposed(above, false)) + QStringLiteral(" / ")
                        + part(below, isComposed(below, true));
            else
                text += QStringLiteral("{%1 | %2}").arg(written(above, how), written(below, how));
            i = end;
        } else if (c == u'*') {
            const bool isBetweenParentheses =
                text.endsWith(u')') && i + 1 < expression.size() && expression[i + 1] == u'(';
            text += isBetweenParentheses ? how.openProduct : how.product;
        } else if (c == u'·') {
            text += how.dot;
        } else {
            text += c;
        }
    }
    return text;
}

} // namespace

FormulaWithNumbers::FormulaWithNumbers(const QString &number, const QString &result, const QString &expression,
                                       const FormulaTerms &terms, const QString &condition)
    : m_number(number)
{
    const auto marked = [](const QString &id, const QString &content) {
        return QStringLiteral("<t %1>%2</t>").arg(id, content);
    };
    const auto inParentheses = [](const QString &value, bool isAfterParenthesis) {
        return value.startsWith(u'−') && !isAfterParenthesis ? u'(' + value + u')' : value;
    };
    const auto column = [](const FormulaTerm &term, const char *open, const char *separator, const char *close) {
        return QLatin1String(open) + term.value.join(QLatin1String(separator)) + QLatin1String(close);
    };
    const Writing symbols{[&](const QString &id, bool) { return marked(id, terms.at(id).symbol); }, QStringLiteral(" "),
                          QString(), QStringLiteral("·"), false};
    const Writing numbers{[&](const QString &id, bool isAfter) {
                              const FormulaTerm &term = terms.at(id);
                              if (term.value.isEmpty())
                                  return marked(id, term.symbol);
                              return marked(id, term.value.size() > 1 ? column(term, "{", "; ", "}")
                                                                      : inParentheses(term.value.front(), isAfter));
                          },
                          QStringLiteral(" × "), QStringLiteral(" × "), QStringLiteral("×"), false};
    const Writing plainSymbols{[&](const QString &id, bool) { return withoutTags(terms.at(id).symbol); },
                               QStringLiteral(" "), QStringLiteral(" "), QStringLiteral("·"), true};
    const Writing plainNumbers{[&](const QString &id, bool isAfter) {
                                   const FormulaTerm &term = terms.at(id);
                                   if (term.value.isEmpty())
                                       return withoutTags(term.symbol);
                                   return term.value.size() > 1 ? column(term, "(", ", ", ")")
                                                                : inParentheses(term.value.front(), isAfter);
                               },
                               QStringLiteral(" × "), QStringLiteral(" × "), QStringLiteral("×"), true};

    const FormulaTerm &left = terms.at(result);
    const QString equals = QStringLiteral(" = ");
    const auto resultValue = [&](const Writing &how, bool isMarked) {
        if (left.value.isEmpty())
            return QString();
        if (left.value.size() > 1)
            return equals + how.term(result, true);
        return equals + (isMarked ? marked(result, left.value.front()) : left.value.front());
    };
    m_symbols = symbols.term(result, false) + equals + written(expression, symbols) + condition;
    m_numbers = QStringLiteral("= ") + written(expression, numbers) + resultValue(numbers, true);
    m_text = (number.isEmpty() ? QString() : number + u' ') + plainSymbols.term(result, false) + equals
             + written(expression, plainSymbols) + condition + QStringLiteral("\n  = ")
             + written(expression, plainNumbers) + resultValue(plainNumbers, false);
}

} // namespace unprojector::gui
