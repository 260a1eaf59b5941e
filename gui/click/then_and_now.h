#pragma once

#include <QString>
#include <QStringList>

#include <optional>
#include <vector>

namespace unprojector::gui {

class SceneDocument;

/// A coordinate of the picked point, at the click and in the current view.
struct ThenAndNow {
    QString name;         ///< "Window x"
    QString then, now;    ///< each to the last certain digit
    bool differs = false; ///< by more than rounding
    double exactThen = 0.0;
    std::optional<double> exactNow = {}; ///< nothing: no such coordinate; `now` is "–"
};

/// The rows of window x, y and depth, then x, y, z in eye space and in world space. The current
/// point moves with its object, so it stays on the clicked surface. It has no window coordinates
/// ("–") in the plane of the eye or behind it.
/// @return empty without a picked point
std::vector<ThenAndNow> thenAndNow(const SceneDocument &document);

/// "Now the point is outside the view volume: z > w: behind the far plane."; empty if it is inside
/// or there is no point.
QString placeNowText(const SceneDocument &document);

/// The changes of the setup since the click, each with both values: "Near: 2 → 1".
QStringList setupChanges(const SceneDocument &document);

} // namespace unprojector::gui
