#pragma once

#include <QString>

#include <optional>

namespace unprojector::gui {

/// The colours of the window.
enum class Appearance {
    Desktop, ///< as the desktop has them
    Light,
    Dark,
};

/// "desktop", "light", "dark"; nothing for any other.
std::optional<Appearance> appearanceOf(const QString &name);
QString appearanceName(Appearance appearance);

/// Gives all windows these colours, those that are open too.
void setAppearance(Appearance appearance);
Appearance currentAppearance();

/// Hanzi in one font, in their shapes of China: on a desktop of another language each would come from whichever font has
/// it, some from a Japanese one. What the desktop's own font has, it draws as before.
/// @pre no window is there yet
void preferHanziOfChina();

} // namespace unprojector::gui
