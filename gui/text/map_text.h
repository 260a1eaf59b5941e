#pragma once

#include "core/maps/pixel_map.h"

#include <QString>

namespace unprojector::gui {

/// What a map shows, in a few words for a list; and in a sentence.
QString quantityName(maps::Quantity quantity);
QString quantityText(maps::Quantity quantity);
QString unitName(maps::Unit unit);

/// What another program is called, and why its answer to a click is another one.
QString programName(unproject::OtherProgram program);
QString programReason(unproject::OtherProgram program);
/// The same in a few words: what the program does.
QString programReasonInShort(unproject::OtherProgram program);

/// A convention in a few words for a list: a program's name, or the mistake.
QString conventionName(const maps::NamedConvention &convention);

} // namespace unprojector::gui
