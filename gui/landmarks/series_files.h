#pragma once

#include "core/geometry/result.h"
#include "core/landmarks/landmark.h"

#include <QString>

#include <filesystem>
#include <optional>
#include <set>
#include <variant>
#include <vector>

namespace unprojector::gui {

class LandmarkTemplates;

/// The files that a series keeps besides the landmarks: a backup of each landmark file, and the
/// template of all scans, "series-template.csv" in their folder.
class SeriesFiles {
public:
    /// Success, or the reason for a failure.
    using Done = geometry::Result<std::monostate, QString>;

    /// Sets the templates with the hints of the names. Without them, no template is written.
    /// @param templates  outlives it
    void setTemplates(LandmarkTemplates &templates) { m_templates = &templates; }

    /// Copies a landmark file to "face.ply.points.csv~", unless this run of the program has
    /// done so: the copy has the state before its first change.
    Done backUp(const std::filesystem::path &file);

    /// Reads the template of a folder's series and chooses it for hints.
    /// @return its names; nothing if there is no template; the reason if it cannot be read
    geometry::Result<std::optional<std::vector<landmarks::Landmark>>, QString>
    readTemplate(const std::filesystem::path &folder);
    /// Notes that the user has chosen a template: it is written, also before landmarks are.
    void setChosen() { m_isChosen = true; }
    /// Writes the template if it has changed. Doesn't replace one that could not be read. A folder
    /// without one gets it once a template was chosen or landmarks were written there.
    /// @return whether it was written; the reason if that failed
    geometry::Result<bool, QString> keepTemplate(const std::filesystem::path &folder,
                                                 const std::vector<landmarks::Landmark> &names);

private:
    LandmarkTemplates *m_templates = nullptr;
    std::set<std::filesystem::path> m_backedUp;
    std::optional<landmarks::LandmarkSet> m_template; ///< as last read or written
    bool m_isDamaged = false;                         ///< the template could not be read
    bool m_isChosen = false;
};

} // namespace unprojector::gui
