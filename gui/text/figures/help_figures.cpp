#include "gui/text/figures/help_figures.h"

#include "gui/text/figures/figures.h"
#include "gui/text/formula_layout.h"

#include <QFontMetricsF>
#include <QPainter>

#include <algorithm>
#include <array>

namespace unprojector::gui {
namespace {

using namespace figures;

struct Figure {
    const char *name;
    double width, height; ///< in multiples of the font height
    void (*draw)(Drawing &);
};

constexpr std::array kFigures{
    Figure{"pipeline", 47.0, 12.1, drawPipeline},
    Figure{"homogeneous", 25.0, 10.2, drawHomogeneous},
    Figure{"normals", 31.0, 8.4, drawNormals},
    Figure{"look-at", 26.0, 11.0, drawLookAt},
    Figure{"view-steps", 31.0, 10.0, drawViewSteps},
    Figure{"ortho", 41.0, 9.6, drawOrtho},
    Figure{"frustum", 26.0, 16.6, drawFrustum},
    Figure{"depth", 27.0, 13.6, drawDepth},
    Figure{"frustum-steps", 34.0, 9.6, drawFrustumSteps},
    Figure{"perspective", 34.0, 10.0, drawPerspective},
    Figure{"oblique", 41.0, 10.4, drawOblique},
    Figure{"clip-plane", 25.0, 10.4, drawClipPlane},
    Figure{"viewport", 38.0, 13.4, drawViewport},
    Figure{"scales", 29.4, 7.6, drawScales},
    Figure{"similar-triangles", 26.0, 10.4, drawSimilarTriangles},
    Figure{"near-window", 38.0, 11.2, drawNearWindow},
    Figure{"flip", 27.0, 11.0, drawFlip},
    Figure{"ray", 34.0, 14.2, drawRay},
    Figure{"eye-to-world", 26.0, 11.4, drawEyeToWorld},
    Figure{"certainty", 31.0, 10.4, drawCertainty},
    Figure{"half-pixel", 22.4, 12.0, drawHalfPixel},
};

const Figure *figureOf(const QString &name)
{
    const auto *found = std::find_if(kFigures.begin(), kFigures.end(),
                                     [&name](const Figure &one) { return name == QLatin1String(one.name); });
    return found == kFigures.end() ? nullptr : found;
}

/// Somewhat smaller than the text, as captions are.
QFont letteringOf(const QFont &font, double scale = 1.0)
{
    constexpr double kLettering = 0.94;
    return formulaFont(font.pointSizeF() * kLettering * scale);
}

} // namespace

QStringList helpFigureNames()
{
    QStringList names;
    for (const Figure &figure : kFigures)
        names << QString::fromLatin1(figure.name);
    return names;
}

QSizeF helpFigureSize(const QString &name, const QFont &font)
{
    const Figure *figure = figureOf(name);
    return figure ? QSizeF(figure->width, figure->height) * QFontMetricsF(letteringOf(font)).height() : QSizeF();
}

void drawHelpFigure(QPainter &painter, const QRectF &place, const QString &name, const QFont &font,
                    const FigureColors &colors)
{
    const Figure *figure = figureOf(name);
    if (!figure)
        return;
    painter.save();
    // Everything shrinks, lines and labels, if the figure must be smaller than its text requires.
    const QSizeF size = helpFigureSize(name, font);
    const double scale = std::min(1.0, place.width() / size.width());
    painter.translate(place.topLeft());
    painter.scale(scale, scale);
    Drawing drawing(painter, QRectF(QPointF(), size), letteringOf(font), colors);
    figure->draw(drawing);
    drawing.paintLabels();
    painter.restore();
}

} // namespace unprojector::gui
