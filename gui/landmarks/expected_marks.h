#pragma once

#include "core/geometry/setup.h"
#include "gui/landmarks/expected_landmarks.h"

#include <QFontMetricsF>
#include <QPointF>
#include <QRectF>
#include <QString>

#include <optional>
#include <vector>

class QPainter;

namespace unprojector::gui {

/// The mark of an expected place in the view.
struct ExpectedMark {
    QPointF at; ///< logical pixels of the surface, origin top-left
    /// Radius of the circle that shows the spread, logical pixels. 0: the spread is not known, or larger
    /// than any view.
    double radius = 0.0;
    bool isNext = false;
    QString label; ///< of the next landmark; else empty
};

/// The marks of all expected places in the view.
std::vector<ExpectedMark> expectedMarks(const SceneDocument &document, const std::vector<ExpectedLandmark> &expected);

/// The box of the label of the next landmark's mark, beside it; null: there is none.
/// @param taken  boxes of other texts, which it avoids if it can
QRectF expectedLabelBox(const std::vector<ExpectedMark> &marks, const QFontMetricsF &metrics, const QRectF &area,
                        const std::vector<QRectF> &taken);

/// The box around the cross of a mark.
QRectF boxOf(const ExpectedMark &mark);

/// Draws dots and circles that leave the surface visible: faint ones, and the next landmark's brighter.
void drawExpected(QPainter &painter, const std::vector<ExpectedMark> &marks, const QRectF &labelBox);

} // namespace unprojector::gui
