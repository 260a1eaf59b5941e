#pragma once

#include "gui/text/figures/drawing.h"

#include <QSizeF>
#include <QStringList>

namespace unprojector::gui {

/// The figures of the help, by their names in its pages: <img src="figure:frustum">. They are
/// drawn, not stored: sharp in every size and on every screen, in the page's own colours and the
/// program's language.
QStringList helpFigureNames();

/// @param font  of the page's text
/// @return in logical pixels; empty if there is no such figure
QSizeF helpFigureSize(const QString &name, const QFont &font);

/// @param place  filled as far as the figure's proportions allow, from its top left corner; in the
/// painter's units
void drawHelpFigure(QPainter &painter, const QRectF &place, const QString &name, const QFont &font,
                    const FigureColors &colors);

} // namespace unprojector::gui
