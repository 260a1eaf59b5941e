#pragma once

#include "core/unproject/pick.h"

#include <QString>
#include <QStringList>

namespace unprojector::gui {
using namespace unproject;

/// The formulas of a surface pick with its numbers put in, as the paper prints them, one a line: the distance z from
/// the depth, x by (9) or (11), y by (10) or (12), and the world point from the camera's axes. Numbers are rounded for
/// reading; the results are those of the full doubles.
QString formulaText(const Pick &pick);

/// The ray under a background pick: from its near to its far point, world space.
QString rayText(const Pick &pick);

/// Why the two methods differ by what they differ, with the numbers that decide it.
QString differenceCauseText(const Pick &pick);
/// The longest that it can be.
QStringList longestDifferenceCauseTexts();

/// How far off the picked coordinate can be, and from what.
QString certaintyText(const Pick &pick);
/// The longest that it can be.
QStringList longestCertaintyTexts();

} // namespace unprojector::gui
