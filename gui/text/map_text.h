#pragma once

#include "core/maps/pixel_map.h"

#include <QString>

namespace unprojector::gui {

/// The quantity that a map shows, in a few words for a list; and in a sentence.
QString quantityName(maps::Quantity quantity);
QString quantityText(maps::Quantity quantity);
QString unitName(maps::Unit unit);

/// The name of another program, and the reason why its answer to a click differs.
QString programName(unproject::OtherProgram program);
QString programReason(unproject::OtherProgram program);
/// The reason in a few words: what the program does.
QString programReasonInShort(unproject::OtherProgram program);

/// A convention in a few words for a list: a program's name, or the mistake.
QString conventionName(const maps::NamedConvention &convention);

} // namespace unprojector::gui
