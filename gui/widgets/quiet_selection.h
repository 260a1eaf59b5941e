#pragma once

class QAbstractItemView;

namespace unprojector::gui {

/// Selected rows keep their black and grey digits apart: on the colour of the desktop's selections there is hardly a grey
/// that can be read, so that rows are selected with a tint of it. Follows when the desktop changes its colours.
void useQuietSelection(QAbstractItemView &view);

} // namespace unprojector::gui
