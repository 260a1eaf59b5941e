#pragma once

#include <QStringList>

class QWidget;

namespace unprojector::gui {

/// The texts inside a widget that are cut off, each in words:
/// - labels, buttons, combo boxes and fields that are narrower or lower than their text;
/// - children that stick out of their parents sideways or overlap each other.
/// A field that has the focus scrolls, and an elided label has less room on purpose: they are left
/// out.
QStringList cutTexts(const QWidget &widget);

} // namespace unprojector::gui
