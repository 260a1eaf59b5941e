#pragma once

#include "core/geometry/viewport.h"

#include <QString>

#include <optional>
#include <vector>

namespace unprojector::gui {

/// A typed or pasted text for a message: its first 40 characters, printable.
QString typedBeginning(const QString &text);

/// Parses the coordinates of a point, typed or copied from a program: "1.5 2 -3", "1.5, 2, -3",
/// "vec3(1.500000, 2.000000, -3.000000)", "[1.5 2. -3.]", "{1.5f, 2, -3}", "QVector3D(1.5, 2, -3)".
/// Each may be an expression without blanks. An additional 1, the w of a point, may follow.
/// @return nothing for any other text, such as one number or "1 / 3"
/// @pre count >= 3
std::optional<std::vector<double>> typedNumbers(const QString &text, std::size_t count);

/// Parses the size of a window or of a picture in whole device pixels: "1000 x 700".
std::optional<geometry::Surface> typedSize(QString text);
/// The sentence that a text is no such size.
QString sizeFaultText(const QString &text);

} // namespace unprojector::gui
