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

constexpr int kNothingUncertain = -20;
/// Decimals that are written out.
constexpr int kMostZeros = 9;

/// Of the first digit.
int exponentOf(double value)
{
    return QString::number(value, 'e', 16).section(u'e', 1).toInt();
}

/// To so many places before the decimal point.
double roundedTo(double value, int place)
{
    const double unit = std::pow(10.0, place);
    return std::round(value / unit) * unit;
}

QString scientificText(double value, int decimals)
{
    return QString::number(value, 'e', decimals);
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
    QString withPower = significantText(value, digits);
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
    return QStringLiteral("%1%2×%2%3")
        .arg(text.section(u'e', 0, 0), QString(QChar::Nbsp), QStringLiteral("10") + power);
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

int certainPlace(double uncertainty)
{
    if (!(uncertainty > 0.0) || !std::isfinite(uncertainty))
        return kNothingUncertain;
    return std::max(static_cast<int>(std::ceil(std::log10(uncertainty))), kNothingUncertain);
}

QString certainText(double value, double uncertainty)
{
    const int place = certainPlace(uncertainty);
    if (place == kNothingUncertain || !std::isfinite(value))
        return shortestText(value);
    if (place > 0)
        return fixedText(roundedTo(value, place), 0);
    if (place >= -kMostZeros || std::abs(value) < std::pow(10.0, place))
        return fixedText(value, std::min(-place, kMostZeros));
    return scientificText(value, std::max(0, exponentOf(value) - place));
}

QString Notation::text(double value) const
{
    return isScientific ? scientificText(value, decimals) : fixedText(value, decimals);
}

qsizetype Notation::certainLength(double value, double uncertainty) const
{
    const QString whole = text(value);
    const int place = certainPlace(uncertainty);
    if (place == kNothingUncertain || !std::isfinite(value))
        return whole.size();
    const qsizetype power = isScientific ? whole.indexOf(u'e') : whole.size();
    const qsizetype point = whole.indexOf(u'.') < 0 ? power : whole.indexOf(u'.');
    const int unit = isScientific ? whole.mid(power + 1).toInt() : 0; // the place of the digit before the point
    const int last = std::max(place, unit - decimals);
    const qsizetype length = last >= unit ? point - (last - unit) : point + 1 + (unit - last);
    const qsizetype sign = whole.startsWith(u'-') ? 1 : 0;
    if (length > sign)
        return std::min(length, power);
    // No digit stands at the certain place or before it: one that rounds up to it is seen by its first.
    return std::abs(value) >= 0.5 * std::pow(10.0, last) ? sign + 1 : 0;
}

int Notation::lastPlace(double value) const
{
    return (isScientific && value != 0.0 && std::isfinite(value) ? exponentOf(value) : 0) - decimals;
}

Notation notationOf(const Components<3> &point, int digits, int characters)
{
    const double largest = std::max({std::abs(point.x), std::abs(point.y), std::abs(point.z)});
    if (!(largest > 0.0) || !std::isfinite(largest))
        return {std::max(0, std::min(digits - 1, characters - 3)), false};
    const int exponent = exponentOf(largest);
    constexpr int kSignAndPoint = 2, kPower = 4;
    const int before = std::max(exponent, 0) + 1; // digits before the point
    const int room = characters - kSignAndPoint - before;
    constexpr int kLeastExponent = -4;
    if (exponent < kLeastExponent || room < 0)
        return {std::clamp(characters - kSignAndPoint - 1 - kPower, 0, digits - 1), true};
    return {std::clamp(room, 0, digits - 1 - exponent), false};
}

QString pointText(const Components<3> &point, const Components<3> &uncertainty)
{
    return QStringLiteral("(%1, %2, %3)")
        .arg(certainText(point.x, uncertainty.x), certainText(point.y, uncertainty.y),
             certainText(point.z, uncertainty.z));
}

} // namespace unprojector::gui
