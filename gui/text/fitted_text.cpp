#include "gui/text/fitted_text.h"

#include "gui/text/number_text.h"

#include <QRegularExpression>

#include <algorithm>

namespace unprojector::gui {

QStringList shorterTexts(double value)
{
    constexpr int kDigits = 16;
    QStringList texts{writtenText(value)};
    const auto add = [&texts](const QString &text) {
        if (text.size() < texts.back().size())
            texts << text;
    };
    for (int digits = kDigits; digits > 0; --digits)
        add(writtenText(value, digits));
    for (int digits = kDigits; digits > 0; --digits) // a large number has many digits before the point
        add(significantText(value, digits));
    return texts;
}

QString fittedText(const QStringList &texts, int width, const TextWidth &widthOf)
{
    const auto fits = [&](const QString &text) { return widthOf(text) <= width; };
    const auto fitting = std::find_if(texts.begin(), texts.end(), fits);
    if (fitting != texts.end())
        return *fitting;
    QString sign = QStringLiteral("####");
    while (sign.size() > 1 && !fits(sign))
        sign.chop(1);
    return sign;
}

QString elidedSentence(const QString &sentence, int width, const TextWidth &widthOf)
{
    if (widthOf(sentence) <= width)
        return sentence;
    const auto hasDigit = [&sentence](qsizetype from, qsizetype to) {
        return std::any_of(sentence.begin() + from, sentence.begin() + to, [](QChar c) { return c.isDigit(); });
    };
    const auto isOfNumber = [](QChar c) { return c.isNumber() || QStringLiteral(".e+-−×⁻").contains(c); };
    // Whether a cut here would leave a number without its unit, or with a part of it.
    const auto isInUnit = [&sentence](qsizetype end) {
        static const QRegularExpression withUnit(
            QStringLiteral("[0-9][0-9.e+\\-−×⁻]*[ \\x{00a0}]?(?:[a-zA-Zµ°%]+|[毫厘微]?米|度|像素)"));
        for (auto found = withUnit.globalMatch(sentence); found.hasNext();) {
            const QRegularExpressionMatch match = found.next();
            if (match.capturedStart() < end && end < match.capturedEnd())
                return true;
        }
        return false;
    };
    QString shown, inLongWord; // Chinese has no blanks
    for (qsizetype end = 1; end < sentence.size(); ++end) {
        const QString cut = sentence.left(end).trimmed() + u'…';
        if (widthOf(cut) > width)
            break;
        // The word that would end or be cut here, and the one before it: 5 mm.
        const qsizetype begin = sentence.lastIndexOf(u' ', end - 1) + 1;
        const qsizetype before = begin > 1 ? sentence.lastIndexOf(u' ', begin - 2) + 1 : 0;
        qsizetype wordEnd = sentence.indexOf(u' ', end);
        if (wordEnd < 0)
            wordEnd = sentence.size();
        if (!hasDigit(before, wordEnd))
            shown = cut;
        // Chinese: nothing of a number or of its unit is cut off.
        if (!isOfNumber(sentence.at(end - 1)) && !isOfNumber(sentence.at(end)) && !isInUnit(end))
            inLongWord = cut;
    }
    return !shown.isEmpty() ? shown : !inLongWord.isEmpty() ? inLongWord : QStringLiteral("…");
}

} // namespace unprojector::gui
