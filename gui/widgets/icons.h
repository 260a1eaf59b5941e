#pragma once

#include <QIcon>

namespace unprojector::gui {

/// The drawings on the tool bar, in the colour of the text beside them: sharp at every size and
/// pixel ratio, light on a dark desktop.
enum class Drawing {
    Click,
    Pipeline,
    Doctor,
    Lessons,
    Help,
    Open,
    Save,
    Undo,
    Redo,
    Fit,
    Home,
    Perspective,
    FromOutside,
    Surface,
    Vertex,
    Edge,
    Face,
    Points,
    ToDock,
    Close,
};

QIcon drawnIcon(Drawing drawing);

/// The program's icon: a view volume, the clicked pixel and the point that its ray hits.
QIcon programIcon();

} // namespace unprojector::gui
