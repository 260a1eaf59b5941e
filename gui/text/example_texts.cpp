#include "gui/text/example_texts.h"

#include <QCoreApplication>

#include <array>

namespace unprojector::gui {
namespace {

struct Entry {
    const char *id;
    const char *name;
    const char *text;
    const char *source;
};

// Rich text. Panels and their parts are named as the window names them.
constexpr std::array kEntries{
    Entry{"zhangci-2d", QT_TRANSLATE_NOOP("Examples", "2-D: Three Coordinate Systems"),
          QT_TRANSLATE_NOOP(
              "Examples",
              "<p>Three pairs of axes, x red and y green: <b>MC</b> carries the yellow point, <b>WC</b> is the world, "
              "<b>VC</b> the camera, in the middle of the picture.</p>"
              "<p>The Pipeline panel follows the tutorial’s point: (1, 1) in MC, (3, 4) in the world, (−2, −2) for the "
              "camera. <b>Type another one</b> into any row, or click the yellow point.</p>"
              "<p>MC is a mirror and a step: glTranslate(4, 3, 0), glScale(−1, 1, 1). VC has its y axis downwards, "
              "so the world hangs upside down. In the plane that is a mirror, in space a half turn: the camera "
              "looks along +z, and z changes its sign. See the <a href='formulas:view'>view matrix</a>.</p>"),
          QT_TRANSLATE_NOOP("Examples", "Zhang Ci, section 2.1, figures 2.3 to 2.5")},
    Entry{"zhangci-model-view", QT_TRANSLATE_NOOP("Examples", "Modelview: m[14] = −8"),
          QT_TRANSLATE_NOOP(
              "Examples",
              "<p>The camera stands at (0, 0, 5), the object was moved by glTranslate(0, 0, −3).</p>"
              "<p><b>Open the Pipeline panel</b>, choose m[0..15], and open Modelview: "
              "m[14] = −8, which is −5 of the view and −3 of the model.</p>"
              "<p>The point (1, 1, 0) stands there already: its world z is −3, its eye z −8. A click on the yellow "
              "plate is followed instead.</p>"
              "<p><b>Correction:</b> the text of the figure prints M = VC⁻¹. The −8 is that of M = VC⁻¹ · MC.</p>"),
          QT_TRANSLATE_NOOP("Examples", "Zhang Ci, section 2.1, figures 2.6 and 2.7")},
    Entry{
        "zhangci-ortho", QT_TRANSLATE_NOOP("Examples", "glOrtho from −10 to 10"),
        QT_TRANSLATE_NOOP(
            "Examples",
            "<p>glOrtho(−10, 10, −10, 10, −10, 10). In the Pipeline panel, Projection is 0.1, 0.1, −0.1 on its "
            "diagonal and 0 in m[12], m[13], m[14].</p>"
            "<p><b>Click near a corner of the square</b>: it is the front of a cube of side 10, seen straight on, "
            "and fills only half of the picture. Its NDC are ±0.5 in x and y.</p>"
            "<p>The front lies in the plane of the eye, where a perspective could show nothing; a box may reach "
            "behind the eye. The depth there is 0.5.</p>"
            "<p><b>Correction:</b> the tutorial calls the volume a cube of side 10, normalised to side 1. Its side is "
            "20, and that of the <a href='formulas:ortho'>normalised volume</a> is 2.</p>"),
        QT_TRANSLATE_NOOP("Examples", "Zhang Ci, section 2.2.1, figures 2.9 and 2.10")},
    Entry{"zhangci-perspective", QT_TRANSLATE_NOOP("Examples", "gluPerspective, 45°"),
          QT_TRANSLATE_NOOP(
              "Examples",
              "<p>gluPerspective(45, 1, 1, 100). In the Pipeline panel with float digits, Projection is the figure’s: "
              "2.4142137, "
              "2.4142137, −1.0202020, −1 and −2.0202019.</p>"
              "<p>Three equal cubes at 5, 11 and 19 units. <b>Click one after the other</b>: the depth grows only from "
              "0.81 to 0.92 and 0.96, since most of its range lies close to the eye. A coordinate picked far away is "
              "less certain.</p>"
              "<p>Press 5 to switch to glOrtho: what lies at the picked distance keeps its size, the others no longer "
              "shrink.</p>"),
          QT_TRANSLATE_NOOP("Examples", "Zhang Ci, section 2.2.2, figures 2.11 and 2.12")},
    Entry{
        "zhangci-viewport-50", QT_TRANSLATE_NOOP("Examples", "Viewport of 50 × 50 Pixels"),
        QT_TRANSLATE_NOOP(
            "Examples",
            "<p>glViewport(0, 0, 50, 50): the small picture in the lower left corner. The rest of the window is "
            "outside the viewport.</p>"
            "<p>In the Pipeline panel the NDC (0, 0, 0.5) come to the window point (25, 25, 0.75). <b>Click the middle "
            "of the yellow plate</b>, and the panel follows the centre of that pixel, half a pixel beside it: "
            "(25.5, 25.5), for example.</p>"
            "<p><b>Correction:</b> the tutorial says that the depth 0.5 does not change. Its own "
            "<a href='formulas:viewport'>viewport matrix</a> makes it (0.5 + 1) / 2 = 0.75.</p>"),
        QT_TRANSLATE_NOOP("Examples", "Zhang Ci, section 2.3")},
    Entry{"zhangci-viewport-quarter", QT_TRANSLATE_NOOP("Examples", "Viewport in the Lower Right Quarter"),
          QT_TRANSLATE_NOOP(
              "Examples",
              "<p>glViewport(width/2, 0, width/2, height/2). y counts from the bottom, so the picture is in the "
              "<i>lower</i> right.</p>"
              "<p><b>Click the yellow plate</b>: formulas (9) to (12) subtract v<sub>x</sub> and v<sub>y</sub> first. "
              "Its depth is 0.75 here as well: the viewport’s rectangle has no part in it.</p>"
              "<p>Make the window wider: the outline, a square, is stretched with it, because this projection does not "
              "follow the viewport. Switch that on in Parameters, Projection.</p>"),
          QT_TRANSLATE_NOOP("Examples", "Zhang Ci, section 2.3, figure 2.13")},
    Entry{"derivation-matrix", QT_TRANSLATE_NOOP("Examples", "Three Projections: Hand-made Matrix"),
          QT_TRANSLATE_NOOP(
              "Examples",
              "<p>The first of three programs that are said to give the same picture. <b>Switch between the three</b> "
              "in the menu; only the projection changes.</p>"
              "<p>In their window of 800 × 600 this matrix has m[0] = 1.3333 and m[5] = 1. gluPerspective has m[0] = "
              "0.75. So the circle is drawn 16 : 9 here, and round there. <b>The three agree in a square window "
              "only.</b></p>"
              "<p>The cause: the names ViewAngleH and ViewAngleV are swapped, and the 90° meant for the width become "
              "those of the height.</p>"
              "<p><b>Correction:</b> the triangle stands where the program meant it, 10 nearer. Its glTranslatef "
              "between glBegin and glEnd is an error in OpenGL and moves nothing.</p>"),
          QT_TRANSLATE_NOOP("Examples", "projection-derivation, first program (the matrix in ReSize)")},
    Entry{"derivation-perspective", QT_TRANSLATE_NOOP("Examples", "Three Projections: gluPerspective, 90°"),
          QT_TRANSLATE_NOOP(
              "Examples",
              "<p>gluPerspective(90, 800/600, 5, 80000), the second of the three programs. <b>The circle is round</b>: "
              "m[0] = 0.75 and m[5] = 1 make up for the window’s 4 : 3.</p>"
              "<p>The other two have m[0] = 1.3333 and draw it 16 : 9. <b>Switch between the three</b> in the menu.</p>"
              "<p>Near : far is 1 : 16000. Click the triangle and look at the difference of the two methods, and at "
              "what is given as its <a href='formulas:matrix'>cause</a>.</p>"),
          QT_TRANSLATE_NOOP("Examples", "projection-derivation, second program")},
    Entry{
        "derivation-frustum", QT_TRANSLATE_NOOP("Examples", "Three Projections: glFrustum"),
        QT_TRANSLATE_NOOP(
            "Examples",
            "<p>glFrustum(−3.75, 3.75, −5, 5, 5, 80000), the third of the three programs in its window of 800 × 600. "
            "It is "
            "exactly the hand-made matrix: m[0] = 1.3333, m[5] = 1. <b>The circle is drawn 16 : 9.</b></p>"
            "<p>Left and right take the angle called V, bottom and top the one called H: the wrong way round. Exchange "
            "them in Parameters, Projection (left −5, right 5, bottom −3.75, top 3.75) and the circle is round.</p>"),
        QT_TRANSLATE_NOOP("Examples", "projection-derivation, third program")},
    Entry{"opencascade-round-trip", QT_TRANSLATE_NOOP("Examples", "Round Trip of Pixel (150, 150)"),
          QT_TRANSLATE_NOOP(
              "Examples",
              "<p>The start of the line is the world’s origin. In a view of <a href='view:300x300'>300 × 300</a> it is "
              "the "
              "window point (150, 150), and (150, 150) in the widget, as the Pipeline panel shows. In a larger view "
              "the picture stays in the lower left corner, and only "
              "the widget’s y is another.</p>"
              "<p><b>Click the middle of the yellow plate.</b> One unit is one pixel here, so that half a pixel shows: "
              "the pixel below and to the right of the origin has its centre at (0.5, −0.5).</p>"
              "<p>The article’s way back gives the origin with another depth z. Here the depth is read from the "
              "picture, and z comes out as well.</p>"
              "<p>In the Pipeline panel choose Rows to see the matrices as the article writes them, "
              "<a href='formulas:rows'>v · M</a>.</p>"),
          QT_TRANSLATE_NOOP("Examples", "opencascade-transforms, section 4, figure 4.1 (its camera is not printed)")},
    Entry{"parallel-orthographic", QT_TRANSLATE_NOOP("Examples", "Parallel Projection 1: Orthographic"),
          QT_TRANSLATE_NOOP(
              "Examples",
              "<p>glOrtho(−9, 9, −9, 9, 2, 9) and a square with red, green, blue and white corners at z = −4.</p>"
              "<p>All of it lies outside the cube from −1 to 1, and the projection brings it inside. <b>Click "
              "near a corner</b>: its NDC are ±4/9 = ±0.444 in x and y, −3/7 = −0.429 in z.</p>"
              "<p>The box is square and the window is not, so the square is stretched. Let the box follow the viewport "
              "(Parameters, Projection) and it is a square.</p>"
              "<p><b>Correction:</b> const int SIZE = 4.5 is 4. The integers n and f of its shader make "
              "−(n + f)/(f − n) −1: there, z is <a href='formulas:error-parallel-integers'>+0.143</a>.</p>"),
          QT_TRANSLATE_NOOP("Examples", "parallel-projection, first program")},
    Entry{"parallel-oblique", QT_TRANSLATE_NOOP("Examples", "Parallel Projection 2: Oblique"),
          QT_TRANSLATE_NOOP(
              "Examples",
              "<p>A box from z = −3 to −4.5, sheared by θ = φ = 0.78 radians (44.69°) and then projected by "
              "glOrtho(−10, 10, −10, "
              "10, 2, 9). Parallel edges stay parallel, and two sides can be seen beside the front.</p>"
              "<p><b>Click the front and a side.</b> The formula first finds the point of the sheared box by (11) "
              "and (12), then takes the <a href='formulas:oblique-back'>shear</a> off: x += cot θ · z.</p>"
              "<p><b>Correction:</b> the program means π/4, whose cotangent is 1. cot 0.78 is 1.01086.</p>"),
          QT_TRANSLATE_NOOP("Examples", "parallel-projection, second program")},
};

struct Examples {
    Q_DECLARE_TR_FUNCTIONS(Examples)
};

} // namespace

std::optional<ExampleText> exampleText(const std::string &id)
{
    for (const Entry &entry : kEntries) {
        if (id == entry.id)
            return ExampleText{Examples::tr(entry.name), Examples::tr(entry.text), Examples::tr(entry.source)};
    }
    return std::nullopt;
}

QString tutorialName(const std::string &tutorial)
{
    if (tutorial == "zhangci")
        return Examples::tr("OpenGL Pipeline (Zhang Ci)");
    if (tutorial == "projection-derivation")
        return Examples::tr("Projection Derivation");
    if (tutorial == "opencascade")
        return Examples::tr("OpenCASCADE Transforms");
    if (tutorial == "parallel-projection")
        return Examples::tr("Parallel Projection");
    return {};
}

} // namespace unprojector::gui
