#pragma once

#include "core/lessons/lesson.h"

#include <cstddef>
#include <set>
#include <vector>

namespace unprojector::lessons {

/// A panel that shows an answer which the user has not given yet.
struct CoveredPanel {
    Panel panel;
    std::size_t until; ///< index of the last step whose answer it shows: that answer uncovers it

    friend bool operator==(const CoveredPanel &, const CoveredPanel &) = default;
};

/// The panels that stay covered in a step. They show the answer to its question, or to the question
/// of a later step on the same scene. The later one counts as soon as the question's point is
/// followed, or a link in a text so far clicks it.
/// @param index  of the step
/// @param given  indices of the steps whose answers were found or shown
/// @return in the order of Panel
std::vector<CoveredPanel> coveredPanels(const Lesson &lesson, std::size_t index, const std::set<std::size_t> &given);

} // namespace unprojector::lessons
