#pragma once

#include <QString>

#include <filesystem>

namespace unprojector::gui {

class SceneDocument;
class Session;

/// Why an export may not go to a file: it is the scene's own, one of its models or one that a model refers to, under
/// whatever name. Empty where it is none of them.
QString overwritingText(const SceneDocument &document, const Session &session, const std::filesystem::path &file);

} // namespace unprojector::gui
