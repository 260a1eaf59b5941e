#pragma once

class QLineEdit;

namespace unprojector::gui {

/// Gives a field whose text cannot be taken a reddish ground, mixed from the theme's own colours, so that the text is
/// readable on a dark one as well; also after other colours are chosen.
void setRefused(QLineEdit &field, bool isRefused);

} // namespace unprojector::gui
