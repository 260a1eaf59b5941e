#pragma once

#include "core/base/note.h"

#include <QString>

#include <vector>

namespace unprojector::gui {

/// A model's import notes: core's sentences after the file's name; empty without any.
QString notesText(const QString &fileName, const std::vector<base::Note> &notes);
/// The import notes of a landmark file: core's words, a line each, after the file's name.
QString landmarkNotesText(const QString &fileName, const std::vector<base::Note> &notes);

} // namespace unprojector::gui
