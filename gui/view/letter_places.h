#pragma once

#include <QFont>

// The layout of a step's letters: boxesOf and leaderOf of highlight_marks.h.

namespace unprojector::gui {

/// The radius of an end-on axis; half the width of an arrow's head.
constexpr double kRing = 5.0, kHalfHead = 3.5;

QFont letterFont(QFont usual);
/// The font of an index.
/// @param letter  the letterFont
QFont letterIndexFont(QFont letter);

} // namespace unprojector::gui
