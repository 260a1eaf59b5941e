#pragma once

#include <QString>

#include <string>
#include <vector>

namespace unprojector::gui {

/// A title of a lesson as it is read, without the sources of its numbers.
QString lessonTitle(const std::string &title);
/// Paragraphs of a lesson as rich text, as well.
QString lessonHtml(const std::vector<std::string> &paragraphs);

} // namespace unprojector::gui
