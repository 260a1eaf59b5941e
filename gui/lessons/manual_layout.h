#pragma once

#include <QColor>

class QTextDocument;

namespace unprojector::gui {

struct ManualColors {
    QColor text, page, heading, link;
};

/// Formats a page of the manual after the Markdown import: heading sizes relative to the document's
/// font, table borders and padding, and a background for code.
void layOutManual(QTextDocument &text, const ManualColors &colors);

/// Scales the page's images: an image has its own width in logical pixels, or the column's if that
/// is narrower.
/// @param ratio  device pixels per logical pixel
void fitManualImages(QTextDocument &text, double columnWidth, double ratio);

} // namespace unprojector::gui
