#include "gui/text/doctor_text.h"

#include "core/doctor/ranking.h"
#include "core/doctor/report_text.h"
#include "gui/text/number_text.h"
#include "gui/text/sentences.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>

namespace unprojector::gui {
using namespace doctor;
namespace {

struct DoctorText {
    Q_DECLARE_TR_FUNCTIONS(unprojector::gui::DoctorText)
};

/// The mistake, and others that cannot be distinguished from it.
QString mistakesText(const Diagnosis &diagnosis)
{
    QString text = QString::fromStdString(candidateSentence(diagnosis.candidates.front()));
    for (const Candidate &alike : diagnosis.alike())
        text +=
            u'\n'
            + DoctorText::tr("Or: %1 %2", "another mistake that explains the point; why they are not told apart")
                  .arg(QString::fromStdString(candidateSentence(alike)), QString::fromStdString(alikeSentence(alike)));
    return text;
}

} // namespace

QString verdictText(const Diagnosis &diagnosis)
{
    const QString except = diagnosis.except ? QString::fromStdString(exceptSentence(diagnosis)) : QString();
    if (diagnosis.namesMistake())
        return except.isEmpty() ? mistakesText(diagnosis) : mistakesText(diagnosis) + u'\n' + except;
    QString said = QString::fromStdString(doctor::verdictSentence(diagnosis));
    if (!except.isEmpty())
        said = joinSentences({said, except});
    const bool isOpen =
        diagnosis.verdict == "unknown" || (diagnosis.verdict == "right" && diagnosis.depthKnown == DepthKnown::ByRay);
    return isOpen ? joinSentences({sentence(doctor::verdictName(diagnosis)), said}) : said;
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
    // Leading zeros don't count as digits.
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
