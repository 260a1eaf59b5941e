#pragma once

#include <QString>

#include <optional>

namespace unprojector::gui {

/// The colours of the window.
enum class Appearance {
    Desktop, ///< the desktop's
    Light,
    Dark,
};

/// The appearance named "desktop", "light" or "dark"; nothing for any other name.
std::optional<Appearance> appearanceOf(const QString &name);
QString appearanceName(Appearance appearance);

/// Applies these colours to all windows, including open ones.
void setAppearance(Appearance appearance);
Appearance currentAppearance();

/// Makes Hanzi use one font with Chinese glyphs: on a desktop of another language each could come
/// from a different font, some from a Japanese one. Characters of the desktop's own font are
/// unaffected.
/// @pre no window exists yet
void preferHanziOfChina();

} // namespace unprojector::gui
