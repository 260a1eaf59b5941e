#pragma once

#include "core/geometry/result.h"
#include "core/mesh/import/mesh_import.h"
#include "core/scene_file/scene_file_error.h"
#include "core/text/expression.h"

#include <QString>

namespace unprojector::gui {

/// What core says is wrong, as sentences of the window.
QString errorText(const geometry::Error &error);
QString errorText(const mesh::ImportError &error);
/// Names the file and the place in it.
QString errorText(const scene_file::SceneFileError &error);
/// Why a text typed for a number is none, with the place in it.
QString errorText(const text::ExpressionError &error, const QString &typed);

/// A path as people read it.
QString pathText(const std::filesystem::path &path);
/// A tooltip that shows this text as it is, whatever looks like markup in it; empty for none.
QString plainToolTip(const QString &text);
/// The suffixes of models, as a filter of a file dialog: "Models (*.obj *.stl …)".
QString modelFileFilter();
/// The same with scenes: "Models and scenes (*.obj … *.json)".
QString openableFileFilter();

} // namespace unprojector::gui
