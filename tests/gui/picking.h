#pragma once

#include "gui/click/answer_view.h"
#include "gui/document/picks.h"
#include "tests/gui/gui_scene.h"

#include <QLabel>

#include <glm/geometric.hpp>

/// Helpers that the tests of the mouse on the view share.
namespace guitest {

/// A pivot is read from the depth buffer and rotated about in doubles: its position moves by
/// roundings only.
inline constexpr double kStillPixels = 1e-3;

inline QString heading(unprojector::gui::MainWindow &window)
{
    return part<unprojector::gui::AnswerView>(window).heading();
}

/// The picked point by formula.
inline glm::dvec3 picked(unprojector::gui::MainWindow &window)
{
    return window.document().picks().pick()->point.world[unprojector::unproject::Method::Formula]->coordinates();
}

inline bool isAt(const unprojector::gui::MainWindow &window, const glm::dvec3 &world, const glm::dvec2 &place,
                 double tolerance)
{
    const glm::dvec2 is = placeOf(window, world);
    if (glm::length(is - place) <= tolerance)
        return true;
    qWarning("at (%g, %g), not (%g, %g)", is.x, is.y, place.x, place.y);
    return false;
}

/// The window coordinates of the centre of the pixel under a position.
inline glm::dvec2 centerUnder(const unprojector::gui::SceneView &view, const QPointF &local)
{
    return windowOf(view, pixelUnder(view, local));
}

inline void addProjections()
{
    QTest::addColumn<bool>("isOrtho");
    QTest::newRow("perspective") << false;
    QTest::newRow("orthographic") << true;
}

} // namespace guitest
