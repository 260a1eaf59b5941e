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

} // namespace unprojector::gui
