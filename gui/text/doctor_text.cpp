#include "gui/text/doctor_text.h"

#include "core/doctor/ranking.h"
#include "core/text/number_text.h"
#include "gui/text/mistake_text.h"
#include "gui/text/number_text.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>

namespace unprojector::gui {
using namespace doctor;
namespace {

struct DoctorText {
    Q_DECLARE_TR_FUNCTIONS(unprojector::gui::DoctorText)
};

QString unknownText(const Diagnosis &diagnosis)
{
    const Candidate &first = diagnosis.candidates.front();
    if (!first.explains)
        return DoctorText::tr(
                   "Unknown: nothing that is known explains this point, none of %1 mistakes and pairs of them.")
            .arg(diagnosis.tried);
    if (diagnosis.depthKnown == DepthKnown::ByRay && diagnosis.landing == Landing::Depth)
        return DoctorText::tr(
            "Unknown: the pixel is right and the depth is not; by the ray alone the mistakes of the depth "
            "cannot be told from each other. Give the depth.");
    return DoctorText::tr("Unknown: “%1” would explain the point, but that may be chance. Give more digits, or another "
                          "wrong point.")
        .arg(candidateName(first));
}

/// The mistake, and those that cannot be told from it.
QString mistakesText(const Diagnosis &diagnosis)
{
    QString text = mistakeSentence(diagnosis.verdict);
    for (const Candidate &alike : diagnosis.alike())
        text += u'\n'
                + DoctorText::tr("Or: %1 %2", "another mistake that explains the point; why they are not told apart")
                      .arg(mistakeSentence(alike.id), alikeSentence(alike));
    return text;
}

} // namespace

QString verdictText(const Diagnosis &diagnosis)
{
    if (diagnosis.verdict == "unknown")
        return unknownText(diagnosis);
    if (diagnosis.verdict == "known-point")
        return knownPointSentence(diagnosis.known);
    if (diagnosis.namesMistake())
        return mistakesText(diagnosis);
    if (diagnosis.depthKnown == DepthKnown::ByRay)
        return DoctorText::tr(
            "Right, as far as the ray tells: the point lies on the ray of this pixel. Whether its depth is "
            "right is not known. Give the depth.");
    return DoctorText::tr("The point is right, to the digits given.");
}

QString candidateName(const Candidate &candidate)
{
    const QString name = candidate.id == "right" ? DoctorText::tr("right") : mistakeName(candidate.id);
    return candidate.ways.empty() ? name : DoctorText::tr("%1 (%2)").arg(name, waysText(candidate.ways));
}

QString explainedText(const Candidate &candidate, const Diagnosis &diagnosis)
{
    const int counted = diagnosis.digitsGiven, written = diagnosis.digitsWritten;
    const bool explainsAll = candidate.digits == counted;
    QString text;
    if (counted == written)
        text = explainsAll ? DoctorText::tr("all %1 digits").arg(counted)
                           : DoctorText::tr("%1 of %2 digits").arg(candidate.digits).arg(counted);
    else // digits that rounding leaves nothing of are given, and explained by nobody
        text = explainsAll ? DoctorText::tr("all %1 digits that count of the %2 given").arg(counted).arg(written)
                           : DoctorText::tr("%1 of the %2 digits that count of the %3 given")
                                 .arg(candidate.digits)
                                 .arg(counted)
                                 .arg(written);
    return candidate.isCutOff ? DoctorText::tr("%1, the last not rounded but cut off", "digits explained").arg(text)
                              : text;
}

QString landingText(const Diagnosis &diagnosis)
{
    if (!diagnosis.projected)
        return DoctorText::tr("in the plane of the eye");
    constexpr int kDigits = 7;
    constexpr double kShare = 0.1; // what a depth is short of may not show in the point's last digit
    const QString place =
        DoctorText::tr("on pixel %1, %2, depth %3")
            .arg(writtenText(diagnosis.projected->x, kDigits), writtenText(diagnosis.projected->y, kDigits),
                 QString::fromStdString(text::shortestText(diagnosis.projected->z, kShare * diagnosis.depthUnsure)));
    if (!diagnosis.hasTellingLanding())
        return place;
    const bool isByRay = diagnosis.depthKnown == DepthKnown::ByRay;
    QString what;
    switch (diagnosis.landing) {
    case Landing::Right:
        what = isByRay ? DoctorText::tr("as far as the digits given tell, the pixel is right")
                       : DoctorText::tr("as far as the digits given tell, pixel and depth are right");
        break;
    case Landing::Pixel: what = DoctorText::tr("the depth is right, the pixel is not: pixel, viewport or lens"); break;
    case Landing::Depth: what = DoctorText::tr("the pixel is right, the depth is not"); break;
    case Landing::Matrix:
        what = isByRay ? DoctorText::tr("the pixel is not right")
                       : DoctorText::tr("neither pixel nor depth is right: a matrix");
        break;
    }
    return DoctorText::tr("%1: %2", "where a point lands, and what of that is wrong").arg(place, what);
}

QString chanceText(double chance)
{
    constexpr double kLeast = 1e-6;
    return chance < kLeast ? DoctorText::tr("less than 0.0001 %")
                           : DoctorText::tr("%1 %").arg(significantText(100.0 * chance, chance < 0.1 ? 2 : 3));
}

QString coordinateText(double value, double lastDigit)
{
    constexpr int kMostDecimals = 15;
    return fixedText(value, std::clamp(int(std::lround(-std::log10(lastDigit))), 0, kMostDecimals));
}

QString pointText(const glm::dvec3 &point, const glm::dvec3 &lastDigit)
{
    QStringList coordinates;
    for (int axis = 0; axis < 3; ++axis)
        coordinates << coordinateText(point[axis], lastDigit[axis]);
    return coordinates.join(QStringLiteral("  "));
}

qsizetype explainedLength(double coordinate, double lastDigit, int digits)
{
    const QString text = coordinateText(coordinate, lastDigit);
    if (digits >= digitsOf(coordinate, lastDigit))
        return text.size();
    // As the digits are counted: those before the first that is not 0 are none.
    int left = digits;
    bool hasBegun = false;
    for (qsizetype i = 0; i < text.size() && left > 0; ++i) {
        hasBegun = hasBegun || (text[i].isDigit() && text[i] != u'0');
        if (hasBegun && text[i].isDigit() && --left == 0)
            return i + 1;
    }
    return 0;
}

} // namespace unprojector::gui
