#pragma once

#include <QStringList>

class QWidget;

namespace unprojector::gui {

/// What of the texts inside a widget is not to be seen as a whole, each in words: labels, buttons, combo boxes and fields
/// that are narrower or lower than their text, children that stick out of their parents sideways or lie on each other.
/// A field that has the focus scrolls, and is left out.
QStringList cutTexts(const QWidget &widget);

} // namespace unprojector::gui
