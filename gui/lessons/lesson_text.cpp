#include "gui/lessons/lesson_text.h"

#include "core/lessons/lesson.h"

namespace unprojector::gui {

QString lessonTitle(const std::string &title)
{
    return QString::fromStdString(lessons::shownText(title));
}

QString lessonHtml(const std::vector<std::string> &paragraphs)
{
    QString html;
    for (const std::string &paragraph : paragraphs)
        html += QStringLiteral("<p>%1</p>").arg(lessonTitle(paragraph));
    return html;
}

} // namespace unprojector::gui
