#include "gui/text/typed_numbers.h"

#include "core/text/expression.h"

#include <QRegularExpression>
#include <QStringList>

namespace unprojector::gui {

std::optional<std::vector<double>> typedNumbers(const QString &text, std::size_t count)
{
    static const QRegularExpression bracketed(
        QStringLiteral("^\\s*(?:[A-Za-z_][\\w:.<>]*\\s*)?[(\\[{][(\\[{\\s]*(.*?)[)\\]}\\s]*[)\\]}]\\s*;?\\s*$"),
        QRegularExpression::DotMatchesEverythingOption);
    static const QRegularExpression separators(QStringLiteral("[\\s;]+|,\\s+"));
    static const QRegularExpression lastComma(QStringLiteral(",$")), floatSuffix(QStringLiteral("(?<=[\\d.])[fF]$"));
    const QRegularExpressionMatch inside = bracketed.match(text);
    const QString numbers = inside.hasMatch() ? inside.captured(1) : text;
    QStringList parts = numbers.split(separators, Qt::SkipEmptyParts);
    if (parts.size() == 1)
        parts = numbers.split(u',');
    const auto size = static_cast<std::size_t>(parts.size());
    if (size != count && size != count + 1)
        return std::nullopt;
    std::vector<double> values;
    for (QString &part : parts) {
        const auto value = text::evaluate(part.remove(lastComma).remove(floatSuffix).toStdString());
        if (!value)
            return std::nullopt;
        values.push_back(*value);
    }
    if (size == count)
        return values;
    if (values.back() != 1.0)
        return std::nullopt;
    values.pop_back();
    return values;
}

} // namespace unprojector::gui
