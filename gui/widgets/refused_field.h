#pragma once

class QLineEdit;

namespace unprojector::gui {

/// Sets or removes the reddish background of a field with a rejected text. The colour is mixed with
/// the theme's base colour, so the text is readable in dark themes too. It follows later changes of
/// the theme.
void setRefused(QLineEdit &field, bool isRefused);

} // namespace unprojector::gui
