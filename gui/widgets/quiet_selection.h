#pragma once

class QAbstractItemView;

namespace unprojector::gui {

/// Tints selected rows lightly, so that black and grey digits stay distinguishable: on the
/// desktop's selection colour hardly any grey is readable. Follows changes of the desktop's
/// colours.
void useQuietSelection(QAbstractItemView &view);

} // namespace unprojector::gui
