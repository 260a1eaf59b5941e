#pragma once

#include <QFont>

// Where the letters of a step stand: boxesOf and leaderOf of highlight_marks.h.

namespace unprojector::gui {

/// Of an axis that is seen end-on, the radius; of an arrow's head, half its width.
constexpr double kRing = 5.0, kHalfHead = 3.5;

QFont letterFont(QFont usual);
/// Of an index.
/// @param letter  the letterFont
QFont letterIndexFont(QFont letter);

} // namespace unprojector::gui
