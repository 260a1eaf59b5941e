#pragma once

#include "core/landmarks/landmark.h"

#include <QString>

#include <filesystem>
#include <optional>
#include <vector>

namespace unprojector::gui {

class SceneDocument;

/// Lists of names to place in order, with a hint for each: those that come with the program and one that was loaded.
///
/// A scene does not know its template: its names are its points, missing ones among them. What is said of a name is found in
/// the template that was chosen last, else in any other, so that it is there for a scene that was opened again.
class LandmarkTemplates {
public:
    struct Bundled {
        QString name; ///< as a menu has it
        QString source;
        std::vector<landmarks::Landmark> points; ///< names, and hints as notes
    };

    /// In the language of the program.
    LandmarkTemplates();

    const std::vector<Bundled> &bundled() const { return m_bundled; }
    /// The names of the template that was chosen last.
    /// @param folder  that its pictures are given from
    void choose(std::vector<landmarks::Landmark> landmarks, const std::filesystem::path &folder = {})
    {
        m_chosen = std::move(landmarks);
        m_folder = folder;
    }
    /// Whether the template that was chosen last has this name.
    bool isChosen(const QString &name) const;
    /// Where a point of this name is; empty: nobody says.
    QString hintFor(const QString &name) const;
    /// The picture that the chosen template has of a point of this name; empty: none.
    std::filesystem::path pictureFor(const QString &name) const;

private:
    std::vector<Bundled> m_bundled;
    std::vector<landmarks::Landmark> m_chosen;
    std::filesystem::path m_folder;
};

/// Puts the names of a template that a scene lacks behind its points, as missing, in one undoable step, and lets the first
/// missing one wait.
void fillFromTemplate(SceneDocument &document, const std::vector<landmarks::Landmark> &landmarks, const QString &name);

} // namespace unprojector::gui
