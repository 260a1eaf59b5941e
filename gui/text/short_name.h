#pragma once

#include <QFontMetrics>
#include <QString>

#include <optional>

namespace unprojector::gui {

/// A name of several words in less room: words lose their ends, the longest first, and keep three letters at least; those of four stay. Names that
/// differ in the middle or at the end stay apart: "palp. sup. right", "palp. inf. right".
/// @param width  logical pixels
/// @return the name itself where it has room; nothing where it is one word, or where that is not enough
std::optional<QString> shortName(const QString &name, const QFontMetrics &metrics, int width);

} // namespace unprojector::gui
