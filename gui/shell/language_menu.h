#pragma once

#include <QString>

class QMenu;

namespace unprojector::gui {

class MessageBar;
class Translation;
class Window;

/// Says that the program would speak Chinese, had it a font for it, and where to get one.
QString missingFontText();
/// Says so in a window whose user has not been told before.
void tellOfFont(Window &window, const Translation &translation);

/// Fills the menu of languages; the choice counts at the next start.
/// @param translation, messages  outlive the menu
void fillLanguageMenu(QMenu &menu, Window &window, const Translation &translation, MessageBar &messages);

} // namespace unprojector::gui
