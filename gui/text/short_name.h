#pragma once

#include <QFontMetrics>
#include <QString>

#include <optional>

namespace unprojector::gui {

/// Shortens a name of several words: words lose their ends, the longest first, and keep at least
/// three letters; words of four stay. Names that differ in the middle or at the end stay different:
/// "palp. sup. right", "palp. inf. right".
/// @param width  logical pixels
/// @return the name itself if it fits; nothing if it is one word or cannot be shortened enough
std::optional<QString> shortName(const QString &name, const QFontMetrics &metrics, int width);

} // namespace unprojector::gui
