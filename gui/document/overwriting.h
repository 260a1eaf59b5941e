#pragma once

#include <QString>

#include <filesystem>

namespace unprojector::gui {

class SceneDocument;
class Session;

/// The reason why an export may not write to a file: it is the scene's own file, one of its models
/// or a file that a model refers to, under any name. Empty if it is none of them.
QString overwritingText(const SceneDocument &document, const Session &session, const std::filesystem::path &file);

} // namespace unprojector::gui
