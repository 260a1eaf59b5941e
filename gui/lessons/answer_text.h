#pragma once

#include "core/lessons/covered_panels.h"
#include "core/lessons/slips.h"
#include "gui/lessons/lesson_player.h"

#include <QString>

#include <cstddef>

namespace unprojector::gui {

// All that a lesson says of answers.

/// An answer to as many decimals as count in it.
QString answerText(const lessons::Asked &asked);
/// What is wrong with a wrong answer.
QString wrongAnswerText(const lessons::Asked &asked, double given);
/// When a covered panel opens.
/// @param index  of the step that is shown
QString coverText(const lessons::CoveredPanel &covered, std::size_t index);
/// The end of a lesson, as rich text: how its questions were answered, and what comes next.
/// @param following  null after the last lesson
QString summaryHtml(const LessonPlayer::Tally &tally, const Lesson *following);

} // namespace unprojector::gui
