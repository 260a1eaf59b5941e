#pragma once

#include "core/geometry/setup.h"

#include <QString>

#include <optional>
#include <utility>

namespace unprojector::gui {

/// The proportion (3) or (4) in symbols, both sides with their numbers, and their common value.
struct ProportionText {
    QString symbols; ///< "(3) (x_w − left) / (right − left) = (x_v − vx) / width"
    QString left;    ///< "(0.0259 − (−0.83)) / (0.83 − (−0.83))"
    QString right;   ///< "(412.5 − 0) / 800"
    QString share;   ///< "0.5156"; empty without a pointer

    /// "(3) (0.0259 − (−0.83)) / (0.83 − (−0.83)) = (412.5 − 0) / 800 = 0.5156"
    QString line() const;
};

enum class Axis { X, Y };

/// Numbers that change with the pointer are padded with blanks to a fixed width, so that the text
/// does not jump.
/// @param pointer  window position; nothing: x_w and x_v (y_w and y_v) stay symbols
/// @pre the setup is valid
ProportionText proportionText(const geometry::Setup &setup, Axis axis,
                              const std::optional<geometry::WindowPoint> &pointer);

/// Lines of proportions as rich text: x_w, x_v and vx get subscripts, and blanks are kept.
QString proportionMarkup(const QString &plain);

/// Returns whether a circle looks distorted: from about half a percent on.
bool isDistorted(double circleAspect);

/// Two aspects, width to height, as texts that differ if the aspects do: "4 : 3" and "1.11 : 1".
std::pair<QString, QString> aspectTexts(double one, double other);

/// "A circle would be drawn 1.33 : 1, wider than high." or "A circle is drawn as a circle."
QString circleText(double circleAspect);

} // namespace unprojector::gui
