#pragma once

#include <QString>
#include <QStringList>

#include <optional>
#include <vector>

namespace unprojector::gui {

class SceneDocument;

/// A coordinate of the picked point at the click and in the view as it is now.
struct ThenAndNow {
    QString name;         ///< "Window x"
    QString then, now;    ///< each to the last certain digit
    bool differs = false; ///< by more than rounding
    double exactThen = 0.0;
    std::optional<double> exactNow = {}; ///< nothing: there is none, and `now` is "–"
};

/// Window x, y and depth; then x, y, z in eye space and in world space. The point is carried along with its object, so
/// that it stays on the surface that was clicked. A point in the plane of the eye or behind it has no window point now:
/// "–".
/// @return nothing without a picked point
std::vector<ThenAndNow> thenAndNow(const SceneDocument &document);

/// "Now the point is outside the view volume: z > w: behind the far plane."; empty where it is inside, and without a
/// point.
QString placeNowText(const SceneDocument &document);

/// The changes of the setup since the click, a phrase with both values each: "Near: 2 → 1".
QStringList setupChanges(const SceneDocument &document);

} // namespace unprojector::gui
