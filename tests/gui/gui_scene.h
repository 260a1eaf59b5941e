#pragma once

#include "gui/document/scene_document.h"
#include "gui/shell/main_window.h"
#include "gui/view/scene_view.h"

#include <QColor>
#include <QImage>
#include <QMouseEvent>
#include <QTest>

#include <array>
#include <memory>
#include <vector>

/// Helpers that the tests of the window share: a cube to click, a window on the screen, mouse
/// events, and a way from a pixel to a plane that shares no line with core.
namespace guitest {

/// Settings go to a folder of the test's own, never to the user's.
void redirectSettings();

// ---- scenes ----------------------------------------------------------------------------------

struct Face {
    const char *name;
    glm::dvec3 normal; ///< outwards
    glm::dvec3 across; ///< along one edge
    glm::u8vec3 color;
};
/// The faces of the cube, +x, -x, +y, -y, +z, -z: red, cyan, green, magenta, blue, yellow.
const std::array<Face, 6> &cubeFaces();
/// Away from the origin, so that the axes, which start there, cross none of its faces.
inline const glm::dvec3 kCubeCenter{3.25, 1.5, -2.75};
/// A cube of edge 2 about that centre, a colour a face.
std::vector<unprojector::scene::SceneObject> cubeScene();
/// Two such cubes, the second partly behind the first: their boxes overlap in the picture, seen
/// from kBeforeTwoCubes.
std::vector<unprojector::scene::SceneObject> twoCubes();
inline const std::array<glm::dvec3, 2> kTwoCubeCenters{{kCubeCenter, kCubeCenter + glm::dvec3(-1.2, 0.4, -3.1)}};
inline const unprojector::geometry::LookAt kBeforeTwoCubes{
    unprojector::geometry::WorldPoint(kCubeCenter + glm::dvec3(1.9, 2.3, 7.0)),
    unprojector::geometry::WorldPoint(kCubeCenter),
    {0.0, 1.0, 0.0}};
/// The face whose colour a pixel has under any light, or -1. Two channels of a face are equal, or
/// only one is not 0, and light scales them alike.
int faceOfColor(const QColor &color);

/// A plane of 2 x 2 half-edges about a point, both sides visible.
std::vector<unprojector::scene::SceneObject> planeScene(const glm::dvec3 &center, const glm::dvec3 &halfEdge,
                                                        const glm::dvec3 &otherHalfEdge);

void setClipPlanes(unprojector::gui::SceneDocument &document, const std::vector<glm::dvec4> &planes);
void setDepthRange(unprojector::gui::SceneDocument &document, const unprojector::geometry::DepthRange &range);

// ---- pictures --------------------------------------------------------------------------------

/// The number of pixels that differ by more than a few steps of colour: where surfaces meet, the
/// rounding of depths is visible.
int differentPixels(const QImage &a, const QImage &b);

// ---- windows ---------------------------------------------------------------------------------

/// Shows a window, and waits until it is on the screen and its view ready.
void bringUp(unprojector::gui::MainWindow &window);

/// Goes to the workspace of this name.
void enter(unprojector::gui::MainWindow &window, const char *name);
/// The panel of this name that the window has.
unprojector::gui::Panel panelNamed(const QString &name);

/// The one object of a class in the window: a part of a feature.
template <class Part>
Part &part(const unprojector::gui::MainWindow &window)
{
    return *window.findChild<Part *>();
}
/// A window on the screen with its view ready, without the dock unless asked for. It restores no
/// settings.
std::unique_ptr<unprojector::gui::MainWindow> shownWindow(bool smoothEdges, const QSize &size, bool withDock = false);
/// The cube, seen from the right, above and in front, in a window of 500 x 400.
std::unique_ptr<unprojector::gui::MainWindow> cubeWindow(bool isOrtho);
/// The two cubes in a window of 420 x 360, from kBeforeTwoCubes.
std::unique_ptr<unprojector::gui::MainWindow> twoCubesWindow(const unprojector::geometry::DepthRange &range = {});
/// Processes the consequences of the last step: timers that are due within the time, answers of the
/// window system, layouts and paints. A busy machine may wake up later, but everything due by then
/// is processed all the same.
void settle(int milliseconds = 50);
/// Resizes and waits until the view has its new size.
bool resized(unprojector::gui::MainWindow &window, const QSize &size);

// ---- positions -------------------------------------------------------------------------------

/// The pixel of the view under a position in it, worked out by hand: the pointer's device pixel in
/// the window less the device pixel that the view's corner is composed at.
unprojector::geometry::DevicePixel pixelUnder(const unprojector::gui::SceneView &view, const QPointF &local);
/// The window position of a pixel's centre, by hand.
glm::dvec2 windowOf(const unprojector::gui::SceneView &view, const unprojector::geometry::DevicePixel &pixel);
/// The position in the view of a world point, in logical pixels, not rounded.
QPointF localOf(const unprojector::gui::MainWindow &window, const glm::dvec3 &world);
/// The position of a world point in the picture, in device pixels from the bottom-left corner.
glm::dvec2 placeOf(const unprojector::gui::MainWindow &window, const glm::dvec3 &world);

// ---- mouse -----------------------------------------------------------------------------------

/// A mouse event at a position between the logical pixels, which QTest cannot give.
void sendMouse(unprojector::gui::SceneView &view, QEvent::Type type, const QPointF &local, Qt::MouseButton button,
               Qt::MouseButtons buttons, Qt::KeyboardModifiers modifiers = {});
void click(unprojector::gui::SceneView &view, const QPointF &local);
/// Press, move in steps, release.
void drag(unprojector::gui::SceneView &view, const QPointF &from, const QPointF &to, Qt::MouseButton button,
          Qt::KeyboardModifiers modifiers = {});
void turnWheel(unprojector::gui::SceneView &view, const QPointF &local, int notches);

// ---- rays by hand ----------------------------------------------------------------------------

struct Ray {
    glm::dvec3 origin;
    glm::dvec3 direction; ///< its component along the view is 1
};
/// The ray of a window position: from the arguments of glFrustum, glOrtho and gluLookAt, without a
/// matrix or a depth.
Ray rayThrough(const unprojector::geometry::Setup &setup, const glm::dvec2 &window);
glm::dvec3 onPlane(const Ray &ray, const glm::dvec3 &point, const glm::dvec3 &normal);
glm::dvec3 forwardOf(const unprojector::geometry::LookAt &camera);
/// Distance from the eye along the view.
double distanceOf(const unprojector::geometry::LookAt &camera, const glm::dvec3 &world);

} // namespace guitest
