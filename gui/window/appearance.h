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

} // namespace unprojector::gui
