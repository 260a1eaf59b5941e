#include "gui/text/number_text.h"

#include <QLocale>

#include <algorithm>
#include <cmath>
#include <optional>

namespace unprojector::gui {
using namespace geometry;

namespace {

/// The least value that is written out with any digits.
constexpr double kLeastWrittenOut = 1e-4;
constexpr int kMostExponent = 9;
constexpr double kTooLarge = 1e10; // 10 to the power of one more

QString theMoreReadable(double value, const QString &withPower, const QString &writtenOut)
{
    const double size = std::abs(value);
    if (size == 0.0 || (size >= kLeastWrittenOut && size < kTooLarge))
        return writtenOut;
    constexpr int kLongerByMost = 3;
    return size < kLeastWrittenOut && writtenOut.size() <= withPower.size() + kLongerByMost ? writtenOut : withPower;
}

QString withoutTrailingZeros(QString text)
{
    if (text.contains(u'.')) {
        while (text.endsWith(u'0'))
            text.chop(1);
        if (text.endsWith(u'.'))
            text.chop(1);
    }
    return text;
}

/// The certain place; none without an uncertainty.
std::optional<int> placeOf(double uncertainty)
{
    if (!(uncertainty > 0.0) || !std::isfinite(uncertainty))
        return std::nullopt;
    return static_cast<int>(std::ceil(std::log10(uncertainty)));
}

/// The most decimals that are written out.
constexpr int kMostZeros = 9;

/// The exponent of the first digit.
int exponentOf(double value)
{
    return QString::number(value, 'e', 16).section(u'e', 1).toInt();
}

/// The value rounded at a place before the decimal point.
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
    return theMoreReadable(value, QString::number(value, 'g', QLocale::FloatingPointShortest),
                           QString::number(value, 'f', QLocale::FloatingPointShortest));
}

QString depthText(double depth)
{
    constexpr int kDigits = 12;
    return writtenText(depth, kDigits);
}

QString pixelText(double pixels)
{
    constexpr double kHundredths = 100.0;
    constexpr int kDigits = 9;
    return writtenText(std::round(pixels * kHundredths) / kHundredths, kDigits);
}

QString significantText(double value, int digits)
{
    return QString::number(value == 0.0 ? 0.0 : value, 'g', digits);
}

QString writtenText(double value)
{
    return shortestText(value == 0.0 ? 0.0 : value);
}

QString writtenText(double value, int digits)
{
    QString withPower = significantText(value, digits);
    if (!std::isfinite(value) || value == 0.0)
        return withPower;
    const int exponent = static_cast<int>(std::floor(std::log10(std::abs(value))));
    constexpr int kMostDecimals = 20;
    const int decimals = std::max(digits - 1 - exponent, 0);
    if (decimals > kMostDecimals) // written out it would be nothing but zeros
        return withPower;
    return theMoreReadable(value, withPower, withoutTrailingZeros(QString::number(value, 'f', decimals)));
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

QString boundText(double bound)
{
    if (!(bound > 0.0) || !std::isfinite(bound))
        return readableText(bound);
    const double power = std::pow(10.0, std::floor(std::log10(bound)));
    // The digits are as in readableText: one more if the first is 1.
    const double unit = bound < 2.0 * power ? power / 10.0 : power;
    constexpr double kRounding = 1e-9; // of the quotient: a whole number stays whole
    return readableText(std::ceil(bound / unit - kRounding) * unit);
}

int decimalsFor(const Components<3> &point, int digits)
{
    const double largest = std::max({std::abs(point.x), std::abs(point.y), std::abs(point.z)});
    if (!(largest > 0.0) || !std::isfinite(largest))
        return digits - 1;
    // The 0 before the point of a number between 0.1 and 1 counts as a digit: its column is no
    // wider than others.
    const int exponent = std::max(static_cast<int>(std::floor(std::log10(largest))), largest < 0.1 ? -20 : 0);
    return std::clamp(digits - 1 - exponent, 0, 20);
}

int certainPlace(double uncertainty)
{
    constexpr int kNothingUncertain = -20;
    return placeOf(uncertainty).value_or(kNothingUncertain);
}

QString certainText(double value, double uncertainty)
{
    const std::optional<int> certain = placeOf(uncertainty);
    if (!certain || !std::isfinite(value))
        return shortestText(value);
    const int place = *certain;
    const double rounded = place > 0 ? roundedTo(value, place) : value;
    if (std::abs(rounded) >= kTooLarge)
        return scientificText(rounded, std::max(0, exponentOf(rounded) - place));
    if (place > 0)
        return fixedText(rounded, 0);
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
    if (!std::isfinite(value))
        return whole.size();
    const qsizetype power = isScientific ? whole.indexOf(u'e') : whole.size();
    const std::optional<int> place = placeOf(uncertainty);
    if (!place)
        return power;
    const qsizetype point = whole.indexOf(u'.') < 0 ? power : whole.indexOf(u'.');
    const int unit = isScientific ? whole.mid(power + 1).toInt() : 0; // the place of the digit before the point
    const int last = std::max(*place, unit - decimals);
    const qsizetype length = last >= unit ? point - (last - unit) : point + 1 + (unit - last);
    const qsizetype sign = whole.startsWith(u'-') ? 1 : 0;
    if (length > sign)
        return std::min(length, power);
    // All digits are below the certain place; a value that rounds up to it is represented by its
    // first digit.
    return std::abs(value) >= 0.5 * std::pow(10.0, last) ? sign + 1 : 0;
}

int Notation::lastPlace(double value) const
{
    return (isScientific && value != 0.0 && std::isfinite(value) ? exponentOf(value) : 0) - decimals;
}

Notation notationOf(const Components<3> &point, double coordinate, int digits, int characters)
{
    constexpr int kSignAndPoint = 2, kPower = 4;
    const double largest = std::max({std::abs(point.x), std::abs(point.y), std::abs(point.z)});
    if (!(largest > 0.0) || !std::isfinite(largest))
        return {std::max(0, std::min(digits - 1, characters - 3)), false};
    const int exponent = exponentOf(largest);
    // -1 if a number without a point still fits
    const auto roomBehind = [characters](int ofFirstDigit) {
        return characters - kSignAndPoint - (std::max(ofFirstDigit, 0) + 1);
    };
    const int room = roomBehind(exponent);
    constexpr int kLeastExponent = -4;
    if (exponent < kLeastExponent || exponent > kMostExponent || room < -1)
        return {std::clamp(characters - kSignAndPoint - 1 - kPower, 0, digits - 1), true};
    constexpr int kThousandths = 3;
    const int ownRoom = roomBehind(coordinate != 0.0 ? exponentOf(coordinate) : 0);
    const int decimals = std::max(room, std::min(ownRoom, kThousandths));
    return {std::clamp(decimals, 0, std::max(0, digits - 1 - exponent)), false};
}

Notation notationWithin(const Components<3> &point, double coordinate, double uncertainty)
{
    constexpr int kDigitsOfExact = 10, kMoreDigits = 2, kDoubleDigits = 16, kLeastExponent = -4;
    const double largest = std::max({std::abs(point.x), std::abs(point.y), std::abs(point.z)});
    const int exponent = largest > 0.0 && std::isfinite(largest) ? exponentOf(largest) : 0;
    const std::optional<int> place = placeOf(uncertainty);
    const int last =
        place ? std::max(*place - kMoreDigits, exponent + 1 - kDoubleDigits) : exponent + 1 - kDigitsOfExact;
    if (exponent > kMostExponent || (exponent < kLeastExponent && -last > kMostZeros)) {
        const int own = coordinate != 0.0 && std::isfinite(coordinate) ? exponentOf(coordinate) : last;
        return {std::clamp(own - last, 0, kDoubleDigits - 1), true};
    }
    return {std::max(0, -last), false};
}

QString pointText(const Components<3> &point, const Components<3> &uncertainty)
{
    return QStringLiteral("(%1, %2, %3)")
        .arg(certainText(point.x, uncertainty.x), certainText(point.y, uncertainty.y),
             certainText(point.z, uncertainty.z));
}

} // namespace unprojector::gui
