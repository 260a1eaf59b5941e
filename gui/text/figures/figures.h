#pragma once

#include <QCoreApplication>

namespace unprojector::gui {

class Drawing;

namespace figures {

/// The translation context of the words in the figures.
struct Words {
    Q_DECLARE_TR_FUNCTIONS(unprojector::gui::HelpFigures)
};

void drawPipeline(Drawing &d);
void drawHomogeneous(Drawing &d);
void drawLookAt(Drawing &d);
void drawViewSteps(Drawing &d);
void drawNormals(Drawing &d);
void drawEyeToWorld(Drawing &d);

void drawOrtho(Drawing &d);
void drawFrustum(Drawing &d);
void drawFrustumSteps(Drawing &d);
void drawSimilarTriangles(Drawing &d);
void drawDepth(Drawing &d);
void drawPerspective(Drawing &d);
void drawOblique(Drawing &d);

void drawClipPlane(Drawing &d);
void drawViewport(Drawing &d);
void drawScales(Drawing &d);
void drawNearWindow(Drawing &d);
void drawFlip(Drawing &d);
void drawHalfPixel(Drawing &d);
void drawRay(Drawing &d);
void drawCertainty(Drawing &d);

} // namespace figures
} // namespace unprojector::gui
