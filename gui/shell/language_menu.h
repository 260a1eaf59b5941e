#pragma once

#include <QString>

class QMenu;

namespace unprojector::gui {

class MessageBar;
class Translation;
class Window;

/// A text that Chinese needs a font, and where to get one.
QString missingFontText();
/// Shows that text in a window, once for each user.
void tellOfFont(Window &window, const Translation &translation);

/// Fills the menu of languages; the choice applies at the next start.
/// @param translation, messages  outlive the menu
void fillLanguageMenu(QMenu &menu, Window &window, const Translation &translation, MessageBar &messages);

} // namespace unprojector::gui
