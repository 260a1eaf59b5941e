#include "gui/lessons/answer_text.h"

#include "gui/lessons/lesson_text.h"
#include "gui/text/number_text.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>
#include <optional>

namespace unprojector::gui {
using namespace lessons;

namespace {

struct Answers {
    Q_DECLARE_TR_FUNCTIONS(Answers)
};

/// The digits of numbers in a sentence.
constexpr int kDigits = 6;

QString withMinus(QString number)
{
    return number.replace(u'-', u'−');
}

QString numberText(double number)
{
    return withMinus(writtenText(number, kDigits));
}

/// The difference of whole numbers, "313 = 500 − 187"; else the number alone.
QString differenceText(const Asked &asked, double given)
{
    const double subtrahend = asked.height - given;
    const bool isWhole = subtrahend == std::round(subtrahend);
    const bool isFromBelow = asked.kind == AskedKind::WindowY || asked.kind == AskedKind::Row;
    return isFromBelow && isWhole
               ? QStringLiteral("%1 = %2 − %3").arg(numberText(given), numberText(asked.height), numberText(subtrahend))
               : numberText(given);
}

QString slipText(SlipKind kind, const Asked &asked, double given)
{
    const QString number = numberText(given), difference = differenceText(asked, given);
    const auto planes = [&](const QString &text) {
        return text.arg(number, numberText(asked.nearDistance.value_or(0.0)),
                        numberText(asked.farDistance.value_or(0.0)));
    };
    switch (kind) {
    case SlipKind::LeftEdge:
        return Answers::tr("%1: the pixel’s left edge. Its centre is half a pixel to the right.").arg(number);
    case SlipKind::RightEdge:
        return Answers::tr("%1: the pixel’s right edge. Its centre is half a pixel to the left.").arg(number);
    case SlipKind::UpperEdge:
        return Answers::tr("%1: the pixel’s upper edge. Its centre is half a pixel lower.").arg(difference);
    case SlipKind::LowerEdge:
        return Answers::tr("%1: the pixel’s lower edge. Its centre is half a pixel higher.").arg(difference);
    case SlipKind::RowAbove:
        return Answers::tr("%1: the row above. Rows count from 0, so the last one is %2.")
            .arg(difference, numberText(asked.height - 1.0));
    case SlipKind::RowCentre: return Answers::tr("%1: the centre of the pixel. Its row is a whole number.").arg(number);
    case SlipKind::NotFlipped:
        return Answers::tr("%1 counts from the top. OpenGL counts from the bottom of the view, which is %2 high.")
            .arg(number, numberText(asked.height));
    case SlipKind::Flipped:
        return Answers::tr("%1 counts from the bottom. The mouse counts from the top of the view, which is %2 high.")
            .arg(number, numberText(asked.height));
    case SlipKind::TimesRatio:
        return Answers::tr(
                   "%1 is %2 times too large. That is the pixel ratio: the pixels here are device pixels already.")
            .arg(number, numberText(asked.ratio));
    case SlipKind::OverRatio:
        return Answers::tr("%1 is %2 times too small. That is the pixel ratio: the pixels here are device pixels.")
            .arg(number, numberText(asked.ratio));
    case SlipKind::DistanceForZ:
        return Answers::tr("%1 has the wrong sign. The eye looks along −z: what lies in front of it has a negative z.")
            .arg(number);
    case SlipKind::Sign: return Answers::tr("%1 has the wrong sign. Try again, or have it shown.").arg(number);
    case SlipKind::NearFarSwapped:
        return planes(Answers::tr("%1 comes out with near and far swapped. Near is %2, far is %3."));
    case SlipKind::NdcForDepth:
        return asked.kind == AskedKind::WindowDepth
                   ? Answers::tr("%1 is z in NDC, from −1 to 1. The depth goes from %2 to %3.")
                         .arg(number, numberText(asked.depthAtNear), numberText(asked.depthAtFar))
                   : Answers::tr("%1 comes out when z in NDC, from −1 to 1, is used as the depth.").arg(number);
    case SlipKind::DepthForNdc:
        return asked.kind == AskedKind::NdcZ
                   ? Answers::tr("%1 is the depth, from %2 to %3. In NDC z goes from −1 to 1.")
                         .arg(number, numberText(asked.depthAtNear), numberText(asked.depthAtFar))
                   : Answers::tr("%1 comes out when the depth is used as z in NDC, from −1 to 1.").arg(number);
    case SlipKind::EvenDepth:
        return Answers::tr("%1 comes out on an even scale. A perspective gives most depths to what is close.")
            .arg(number);
    case SlipKind::DegreesForRadians:
        return Answers::tr("%1 comes out when degrees are taken for radians.").arg(number);
    case SlipKind::RadiansForDegrees:
        return Answers::tr("%1 comes out when radians are taken for degrees.").arg(number);
    }
    return {};
}

} // namespace

QString answerText(const Asked &asked)
{
    const int decimals =
        asked.tolerance > 0.0 ? std::clamp(static_cast<int>(std::ceil(-std::log10(asked.tolerance))), 0, 12) : 12;
    const double scale = std::pow(10.0, decimals);
    return withMinus(writtenText(std::round(asked.answer * scale) / scale, 15));
}

QString wrongAnswerText(const Asked &asked, double given)
{
    const std::optional<SlipKind> slip = slipOf(asked, given);
    return slip ? slipText(*slip, asked, given)
                : Answers::tr("%1 is not it. Try again, or have it shown.").arg(numberText(given));
}

QString coverText(const CoveredPanel &covered, std::size_t index)
{
    return covered.until == index ? Answers::tr("Answer first; then the panel opens.")
                                  : Answers::tr("The panel opens with the answer to step %1.").arg(covered.until + 1);
}

QString summaryHtml(const LessonPlayer::Tally &tally, const Lesson *following)
{
    QString html = QStringLiteral("<p><b>%1</b></p>").arg(Answers::tr("The end of the lesson"));
    if (tally.questions > 0) {
        const int open = tally.questions - tally.atOnce - tally.later - tally.shown;
        QString rows;
        const auto add = [&rows](const QString &name, int count) {
            rows += QStringLiteral("<tr><td>%1</td><td align='right'>&nbsp;%2</td></tr>").arg(name).arg(count);
        };
        add(Answers::tr("Questions"), tally.questions);
        add(Answers::tr("Right with the first answer"), tally.atOnce);
        add(Answers::tr("Right with a later answer"), tally.later);
        add(Answers::tr("Shown"), tally.shown);
        add(Answers::tr("Not answered"), open);
        html += QStringLiteral("<table>%1</table>").arg(rows);
    }
    if (following)
        html +=
            QStringLiteral("<p>%1</p>").arg(Answers::tr("Next lesson: <b>%1</b>").arg(lessonTitle(following->title)));
    return html;
}

} // namespace unprojector::gui
