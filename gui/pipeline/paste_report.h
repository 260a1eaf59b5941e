#pragma once

#include "core/cameras/pasted_camera.h"
#include "core/geometry/setup.h"
#include "core/report/report.h"

#include <QString>

#include <optional>

namespace unprojector::gui {

/// A pasted camera, and what became of it in the view.
struct ShownPaste {
    const cameras::PastedCamera &camera;
    bool isBlenders = false;                    ///< the text has a matrix as Blender prints it
    QString fault = {};                         ///< why it is not shown; empty: see camera.fault
    std::optional<geometry::Setup> setup = {};  ///< of the view that shows it
    std::optional<geometry::Box> objects = {};  ///< world space
    std::optional<geometry::Surface> size = {}; ///< that the view gets from the camera's image
    bool isCorrected = false;
    QString refusal = {}; ///< why another text or file is not taken instead
};

// The targets of the report's links: kCorrect with the index of the matrix and of its finding, kDirection with a
// PoseDirection.
inline constexpr char kCorrect[] = "correct", kDirection[] = "direction", kAsPasted[] = "as-pasted";

/// How a text was read, what the camera means, and what it shows.
report::Report pasteReport(const ShownPaste &shown);

} // namespace unprojector::gui
