#pragma once

#include "core/geometry/result.h"
#include "core/landmark_files/landmark_file.h"
#include "core/landmark_files/sliders.h"
#include "core/landmarks/landmark.h"
#include "core/ray/tie_landmark.h"

#include <QObject>
#include <QString>
#include <QStringList>

#include <cstddef>
#include <filesystem>
#include <optional>
#include <span>
#include <vector>

namespace unprojector::gui {

class SceneDocument;

/// Questions to the user when landmarks are imported.
class LandmarkFileQuestions {
public:
    enum class Join { Replace, Append, Cancel };
    enum class Stray { Tie, LeaveFree, Cancel };
    enum class Order { Fill, Behind, Cancel };

    virtual ~LandmarkFileQuestions() = default;
    /// The numbers of placed landmarks, of names to place, and of landmarks in the file.
    struct Counts {
        int placed = 0, waiting = 0, coming = 0;
    };
    /// Asks what to do with the present landmarks and the names to place.
    virtual Join askJoin(const Counts &counts) = 0;
    /// Asks what to do with landmarks that lie far from every object.
    /// @param text  which, and how far
    virtual Stray askStray(const QString &text) = 0;
    /// Asks whether nameless landmarks take the names to place, whose number differs, in order.
    /// @param text  the numbers
    virtual Order askOrder(const QString &text) = 0;
};

/// Imports and exports a document's landmarks in the formats of core/landmark_files. A file's
/// coordinates are in world space.
class LandmarkFiles : public QObject {
    Q_OBJECT
public:
    /// @param questions  outlive it. Null: no questions; imported landmarks replace the present
    /// ones and strays stay free
    LandmarkFiles(SceneDocument &document, LandmarkFileQuestions *questions, QObject *parent = nullptr);

    /// Returns whether the file is a landmark file by its name: not "x.json", but "x.mrk.json".
    static bool isLandmarkFile(const std::filesystem::path &file);
    /// Returns whether the file is a template of names by its name.
    static bool isTemplate(const std::filesystem::path &file);
    /// The filter for a file dialog: "Points (*.csv *.pp …)".
    static QString importFilter();
    /// One filter a format, separated by ";;".
    static QString exportFilters();

    /// Imports a file and ties its landmarks to the visible objects, as one undoable step. The
    /// scene's unit and other programs' keys stay unless the file has its own.
    /// Names to place are filled by name if the scene has nothing else or the user chooses to
    /// append; a file without names fills them in order. Landmarks named like semilandmarks of a
    /// format without curves become curves again.
    /// @return whether its landmarks are in the scene
    bool importFrom(const std::filesystem::path &file);
    /// @param names  of a series, in order. TPS and NTSYS have no names of points: there, the file has a point of
    ///               each name in this order, as a table of the series
    /// @return whether it is written; false if the user gives up waiting for the curves
    bool exportTo(const std::filesystem::path &file, std::span<const landmarks::Landmark> names = {});

signals:
    /// Emitted when a file could not be read or written, with the reason.
    void failed(const QString &reason);
    /// Emitted with the import or export notes: what was not kept.
    void warned(const QString &text);
    /// Emitted with information that needs no answer.
    void noticed(const QString &text);

private:
    struct Stray {
        std::size_t index = 0;
        landmarks::Landmark untied;
    };
    std::vector<ray::TyingTarget> targets() const;
    LandmarkFileQuestions::Join howToJoin(const landmarks::LandmarkSet &coming) const;
    /// Gives nameless landmarks the names to place, in order.
    /// @param notes  receives what was done
    /// @return false if the user cancelled the import
    bool nameAll(std::vector<landmarks::Landmark> &landmarks, LandmarkFileQuestions::Join join, const QString &file,
                 QStringList &notes);
    /// Ties landmarks to the objects; the user decides about strays.
    /// @return what was done, in words; nothing if the user cancelled the import
    std::optional<QString> tieAll(std::vector<landmarks::Landmark> &landmarks);

    SceneDocument &m_document;
    LandmarkFileQuestions *m_questions;
};

/// The messages about the sliders beside a table.
struct SlidersReport {
    QStringList said; ///< where they are
    QStringList lost; ///< why they could not be written; a file of an earlier export that no longer fits
};
/// Writes the sliders of a written table beside it, if there are any.
SlidersReport writeSliders(const std::filesystem::path &table,
                           const base::Expected<landmark_files::Sliders, base::Error> &sliders);

} // namespace unprojector::gui
