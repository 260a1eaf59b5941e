#pragma once

#include "core/base/error.h"
#include "core/base/expression.h"
#include "core/geometry/result.h"

#include <QString>

#include <filesystem>

namespace unprojector::gui {

/// Core's errors as sentences for the window.
QString errorText(const geometry::Error &error);
/// Names the file, and the position or the value in it.
QString errorText(base::Error error);
/// Explains why a typed text is not a number, with the position of the error.
QString errorText(const base::ExpressionError &error, const QString &typed);

/// A path in readable form.
QString pathText(const std::filesystem::path &path);
/// A tooltip that shows this text without interpreting markup; empty for an empty text.
QString plainToolTip(const QString &text);
/// The suffixes of models as a filter of a file dialog: "Models (*.obj *.stl …)".
QString modelFileFilter();
/// The same with scenes: "Models and scenes (*.obj … *.json)".
QString openableFileFilter();

} // namespace unprojector::gui
