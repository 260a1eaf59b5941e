#pragma once

#include "core/geometry/result.h"
#include "core/geometry/spaces.h"
#include "core/lessons/link.h"
#include "gui/shell/appearance.h"
#include "gui/text/translation.h"

#include <QSize>
#include <QString>
#include <QStringList>

#include <filesystem>
#include <optional>
#include <vector>

namespace unprojector::gui {

/// How the program starts, as the command line says.
struct StartOptions {
    QString textToPrint;             ///< the help or the version, to print instead of a start; else empty
    std::optional<QString> picture;  ///< the file that a screenshot run writes; nothing: a window for a user
    std::optional<QSize> windowSize; ///< logical pixels; a screenshot run always has one
    std::optional<QSize> viewSize;   ///< logical pixels; instead of the window's
    std::optional<lessons::Workspace> workspace;
    bool hasPanels = true;
    std::optional<Appearance> appearance;
    std::optional<Language> language;
    std::optional<bool> smoothEdges;
    std::vector<geometry::WidgetPoint> clicks; ///< of a screenshot run; logical pixels of the view
    std::optional<QString> lesson;             ///< its name, and its step behind a colon, from 1 on
    std::vector<std::filesystem::path> files;  ///< none: the bundled scene

    bool isScreenshotRun() const { return picture.has_value(); }
};

/// The language that the words ask for, whatever else is wrong with them; nothing where they ask for none that the program has.
std::optional<Language> languageIn(const QStringList &words);

/// Parses the words of the command line, the program's name first.
/// @return the mistake in a sentence where there is one
geometry::Result<StartOptions, QString> startOptions(const QStringList &words);

} // namespace unprojector::gui
