#pragma once

#include <QColor>

class QTextDocument;

namespace unprojector::gui {

struct ManualColors {
    QColor text, page, heading, link;
};

/// Lays out a page of the manual that Markdown was put into: sizes of headings, which follow the document's font,
/// tables with borders and padding, code on a ground of its own.
void layOutManual(QTextDocument &text, const ManualColors &colors);

/// Makes the images of the page as wide as they are, in logical pixels, or as the column.
/// @param ratio  device pixels in a logical one
void fitManualImages(QTextDocument &text, double columnWidth, double ratio);

} // namespace unprojector::gui
