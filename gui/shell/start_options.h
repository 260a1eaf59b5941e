#pragma once

#include "core/geometry/camera_motion.h"
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

/// The start options from the command line.
struct StartOptions {
    QString textToPrint;                        ///< the help or the version, to print instead of a start; else empty
    std::optional<QString> picture;             ///< the file that a screenshot run writes; nothing: a window for a user
    std::optional<QString> series;              ///< the folder of a series of scans
    std::optional<QString> pictures;            ///< the folder for an image of each scan of the series
    std::optional<geometry::StandardView> side; ///< that these images show; nothing: as the series opens
    std::optional<QSize> windowSize;            ///< logical pixels; a screenshot run always has one
    std::optional<QSize> viewSize;              ///< logical pixels; overrides windowSize
    std::optional<lessons::Workspace> workspace;
    bool hasPanels = true;
    std::optional<Appearance> appearance;
    std::optional<Language> language;
    std::optional<bool> smoothEdges;
    std::vector<geometry::WidgetPoint> clicks; ///< of a screenshot run; logical pixels of the view
    std::optional<QString> lesson;             ///< its name, optionally with a step after a colon, from 1
    std::vector<std::filesystem::path> files;  ///< none: the bundled scene

    bool isScreenshotRun() const { return picture || pictures; }
};

/// The language that the words ask for, even if they have other errors; nothing if they ask for no
/// supported language.
std::optional<Language> languageIn(const QStringList &words);

/// Parses the words of the command line, the program's name first.
/// @return the error in a sentence, if there is one
geometry::Result<StartOptions, QString> startOptions(const QStringList &words);

} // namespace unprojector::gui
