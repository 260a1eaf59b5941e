#include "gui/text/number_text.h"

#include <QLocale>

#include <algorithm>
#include <cmath>

namespace unprojector::gui {
namespace {

QString theMoreReadable(const QString &withPower, const QString &writtenOut)
{
    constexpr int kLongerByMost = 3;
    return withPower.contains(u'e') && writtenOut.size() <= withPower.size() + kLongerByMost ? writtenOut : withPower;
}

} // namespace

QString shortestText(double value)
{
    return QString::number(value, 'g', QLocale::FloatingPointShortest);
}

QString significantText(double value, int digits)
{
    return QString::number(value == 0.0 ? 0.0 : value, 'g', digits);
}

QString writtenText(double value)
{
    const double number = value == 0.0 ? 0.0 : value;
    return theMoreReadable(shortestText(number), QString::number(number, 'f', QLocale::FloatingPointShortest));
}

QString writtenText(double value, int digits)
{
    const QString withPower = significantText(value, digits);
    if (!std::isfinite(value) || value == 0.0)
        return withPower;
    const int exponent = static_cast<int>(std::floor(std::log10(std::abs(value))));
    QString writtenOut = QString::number(value, 'f', std::clamp(digits - 1 - exponent, 0, 20));
    if (writtenOut.contains(u'.')) {
        while (writtenOut.endsWith(u'0'))
            writtenOut.chop(1);
        if (writtenOut.endsWith(u'.'))
            writtenOut.chop(1);
    }
    return theMoreReadable(withPower, writtenOut);
}

QString fixedText(double value, int decimals)
{
    QString text = QString::number(value, 'f', std::clamp(decimals, 0, 20));
    const bool isZero =
        std::all_of(text.cbegin(), text.cend(), [](QChar c) { return c == u'0' || c == u'.' || c == u'-'; });
    if (isZero && text.startsWith(u'-'))
        text.remove(0, 1);
    return text;
}

QString readableText(double value)
{
    if (value == 0.0 || !std::isfinite(value))
        return significantText(value, 1);
    QString text = QString::number(value, 'e', 1);
    const bool beginsWithOne = text.at(text.startsWith(u'-') ? 1 : 0) == u'1';
    if (!beginsWithOne)
        text = QString::number(value, 'e', 0);
    const int exponent = text.section(u'e', 1).toInt();
    if (exponent >= -7 && exponent <= 6)
        return fixedText(text.toDouble(), std::max(0, (beginsWithOne ? 1 : 0) - exponent));
    static const QString superscripts = QStringLiteral("⁰¹²³⁴⁵⁶⁷⁸⁹");
    QString power = exponent < 0 ? QStringLiteral("⁻") : QString();
    for (const QChar digit : QString::number(std::abs(exponent)))
        power += superscripts.at(digit.digitValue());
    return QStringLiteral("%1%2×%2%3").arg(text.section(u'e', 0, 0), QString(QChar::Nbsp), QStringLiteral("10") + power);
}

int decimalsFor(const Components<3> &point, int digits)
{
    const double largest = std::max({std::abs(point.x), std::abs(point.y), std::abs(point.z)});
    if (!(largest > 0.0) || !std::isfinite(largest))
        return digits - 1;
    // The 0 before the point of a number between 0.1 and 1 counts as a digit: its column is no wider than others.
    const int exponent = std::max(static_cast<int>(std::floor(std::log10(largest))), largest < 0.1 ? -20 : 0);
    return std::clamp(digits - 1 - exponent, 0, 20);
}

int certainDecimals(double radius)
{
    if (!(radius > 0.0) || !std::isfinite(radius))
        return 15;
    return std::clamp(static_cast<int>(std::floor(-std::log10(radius))), 0, 15);
}

QString pointText(const Components<3> &point, int decimals)
{
    return QStringLiteral("(%1, %2, %3)")
        .arg(fixedText(point.x, decimals), fixedText(point.y, decimals), fixedText(point.z, decimals));
}

} // namespace unprojector::gui
