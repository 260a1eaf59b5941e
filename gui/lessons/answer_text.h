#pragma once

#include "core/lessons/covered_panels.h"
#include "core/lessons/slips.h"
#include "gui/lessons/lesson_player.h"

#include <QString>

#include <cstddef>

namespace unprojector::gui {

// The texts of a lesson about answers.

/// An answer with as many decimals as are checked.
QString answerText(const lessons::Asked &asked);
/// The explanation of a wrong answer.
QString wrongAnswerText(const lessons::Asked &asked, double given);
/// The text of a covered panel: when it opens.
/// @param index  of the present step
QString coverText(const lessons::CoveredPanel &covered, std::size_t index);
/// The summary of a lesson, as rich text: the results of its questions, and the next lesson.
/// @param following  null after the last lesson
QString summaryHtml(const LessonPlayer::Tally &tally, const Lesson *following);

} // namespace unprojector::gui
