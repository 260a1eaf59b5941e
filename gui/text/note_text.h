#pragma once

#include "core/landmark_files/landmark_file.h"
#include "core/mesh/mesh.h"

#include <QString>

#include <vector>

namespace unprojector::gui {

/// What a model does not show as its file has it: core's sentences, the file's name before them; empty without any.
QString notesText(const QString &fileName, const std::vector<mesh::ModelNote> &notes);
/// What a file of points does not have as it was given: core's words, a line each, the file's name before them.
QString landmarkNotesText(const QString &fileName, const std::vector<landmark_files::LandmarkNote> &notes);

} // namespace unprojector::gui
