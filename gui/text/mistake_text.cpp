#include "gui/text/mistake_text.h"

#include "core/doctor/mistake_texts.h"

namespace unprojector::gui {

QString mistakeName(const std::string &id)
{
    return QString::fromStdString(doctor::mistakeName(id));
}

QString mistakeSentence(const std::string &id)
{
    return QString::fromStdString(doctor::mistakeSentence(id));
}

QString waysText(const std::vector<doctor::Way> &ways)
{
    return QString::fromStdString(doctor::waysText(ways));
}

QString knownPointSentence(const std::vector<doctor::KnownPoint> &known)
{
    return QString::fromStdString(doctor::knownPointSentence(known));
}

QString knownPointName(const std::vector<doctor::KnownPoint> &known)
{
    return QString::fromStdString(doctor::knownPointName(known));
}

QString alikeSentence(const doctor::Candidate &candidate)
{
    return QString::fromStdString(doctor::alikeSentence(candidate));
}

} // namespace unprojector::gui
