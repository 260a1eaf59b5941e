#include "gui/text/typed_numbers.h"

#include "core/base/expression.h"
#include "core/base/printable.h"
#include "core/doctor/written_points.h"

#include <QCoreApplication>
#include <QRegularExpression>
#include <QStringList>

#include <cmath>

namespace unprojector::gui {
namespace {

struct TypedNumbers {
    Q_DECLARE_TR_FUNCTIONS(unprojector::gui::TypedNumbers)
};

} // namespace

std::optional<std::vector<double>> typedNumbers(const QString &text, std::size_t count)
{
    static const QRegularExpression bracketed(
        QStringLiteral("^\\s*(?:[A-Za-z_][\\w:.<>]*\\s*)?[(\\[{][(\\[{\\s]*(.*?)[)\\]}\\s]*[)\\]}]\\s*;?\\s*$"),
        QRegularExpression::DotMatchesEverythingOption);
    static const QRegularExpression separators(QStringLiteral("[\\s;]+|,\\s+"));
    static const QRegularExpression lastComma(QStringLiteral(",$")), floatSuffix(QStringLiteral("(?<=[\\d.])[fF]$"));
    constexpr qsizetype kMostCharacters = 10'000; // more than so few numbers ever take: the window waits here
    if (text.size() > kMostCharacters)
        return std::nullopt;
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
        const auto value = base::evaluate(part.remove(lastComma).remove(floatSuffix).toStdString());
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

std::optional<geometry::Surface> typedSize(QString text)
{
    for (const char16_t sign : {u'x', u'X', u'×', u'*'})
        text.replace(QChar(sign), QChar(u' '));
    const auto numbers = doctor::writtenNumbers(text.toStdString(), 2);
    constexpr double kMost = 1e6;
    if (!numbers)
        return std::nullopt;
    for (const doctor::WrittenNumber &number : *numbers) {
        if (!(number.value >= 1.0 && number.value <= kMost) || std::floor(number.value) != number.value)
            return std::nullopt;
    }
    return geometry::Surface{static_cast<int>((*numbers)[0].value), static_cast<int>((*numbers)[1].value), 1.0};
}

QString typedBeginning(const QString &text)
{
    constexpr std::size_t kMost = 40;
    return QString::fromStdString(base::printableBeginning(text.toStdString(), kMost));
}

QString sizeFaultText(const QString &text)
{
    return TypedNumbers::tr("“%1” is not a size: type width and height in whole pixels, such as 1000 x 700.")
        .arg(typedBeginning(text));
}

} // namespace unprojector::gui
