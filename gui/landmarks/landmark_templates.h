#pragma once

#include "core/landmarks/landmark.h"

#include <QString>
#include <QStringList>

#include <filesystem>
#include <optional>
#include <vector>

namespace unprojector::gui {

class SceneDocument;

/// Templates: lists of names to place in order, with a hint for each; the bundled ones and one that
/// was loaded.
///
/// A scene does not store its template: its names are landmarks, some not placed yet. A name's
/// hint is looked up in the last chosen template, then in all others, so that a reopened scene has
/// hints too.
class LandmarkTemplates {
public:
    struct Bundled {
        QString name; ///< as in a menu
        QString source;
        std::vector<landmarks::Landmark> points; ///< names, and hints as notes
    };

    /// Loads the bundled templates in the program's language.
    LandmarkTemplates();

    const std::vector<Bundled> &bundled() const { return m_bundled; }
    /// Sets the chosen template.
    /// @param folder  base folder of its images
    void choose(std::vector<landmarks::Landmark> landmarks, const std::filesystem::path &folder = {})
    {
        m_chosen = std::move(landmarks);
        m_folder = folder;
    }
    /// Returns whether the last chosen template has this name.
    bool isChosen(const QString &name) const;
    /// The hint for a landmark of this name; empty if there is none. For a name of the chosen
    /// template, no other template counts: a face's nasion has no hint for skulls.
    QString hintFor(const QString &name) const;
    /// The chosen template's image for a landmark of this name; empty if there is none.
    std::filesystem::path pictureFor(const QString &name) const;
    /// A template with the names of these landmarks, their hints and images.
    /// @param folder  of the template's file: the images are relative to it
    landmarks::LandmarkSet templateOf(const std::vector<landmarks::Landmark> &names,
                                      const std::filesystem::path &folder) const;

private:
    std::vector<Bundled> m_bundled;
    std::vector<landmarks::Landmark> m_chosen;
    std::filesystem::path m_folder;
};

/// Adds a template's names that the scene lacks as landmarks to place, in its order. It replaces the
/// other landmarks to place; those marked as missing stay. One undoable step. The first landmark to
/// place is next.
/// @return the names that it removed
QStringList fillFromTemplate(SceneDocument &document, const std::vector<landmarks::Landmark> &landmarks,
                             const QString &name);

} // namespace unprojector::gui
