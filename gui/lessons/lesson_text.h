#pragma once

#include <QString>

#include <string>
#include <vector>

namespace unprojector::gui {

/// The readable title of a lesson, without the sources of its numbers.
QString lessonTitle(const std::string &title);
/// Paragraphs of a lesson as rich text, without those sources either.
QString lessonHtml(const std::vector<std::string> &paragraphs);

} // namespace unprojector::gui
