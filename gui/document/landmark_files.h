#pragma once

#include "core/landmarks/landmark.h"
#include "core/ray/tie_landmark.h"

#include <QObject>
#include <QString>

#include <cstddef>
#include <filesystem>
#include <optional>
#include <vector>

namespace unprojector::gui {

class SceneDocument;

/// What only a person can answer when points are read from a file.
class LandmarkFileQuestions {
public:
    enum class Join { Replace, Append, Cancel };
    enum class Stray { Tie, LeaveFree, Cancel };
    enum class Order { Fill, Behind, Cancel };

    virtual ~LandmarkFileQuestions() = default;
    /// How many points are there with a place, how many names wait for one, and how many points the file has.
    struct Counts {
        int placed = 0, waiting = 0, coming = 0;
    };
    /// What becomes of the points that are there, and of the names that wait.
    virtual Join askJoin(const Counts &counts) = 0;
    /// What becomes of points that lie far from every object.
    /// @param text  which, and how far
    virtual Stray askStray(const QString &text) = 0;
    /// Whether points without names take the names that wait, of which there are more or fewer, by their order.
    /// @param text  how many
    virtual Order askOrder(const QString &text) = 0;
};

/// Points of a document from files and into files, in the formats of core/landmark_files. A file's coordinates are the world's.
class LandmarkFiles : public QObject {
    Q_OBJECT
public:
    /// @param questions  outlive it; null: nobody is there to ask, points replace those before and strays stay where they are
    LandmarkFiles(SceneDocument &document, LandmarkFileQuestions *questions, QObject *parent = nullptr);

    /// Whether a file is one of points by its name. "x.json" is none: "x.mrk.json" is.
    static bool isLandmarkFile(const std::filesystem::path &file);
    /// Whether a file is one of names to place, by its name.
    static bool isTemplate(const std::filesystem::path &file);
    /// As filters of file dialogs have it: "Points (*.csv *.pp …)".
    static QString importFilter();
    /// One a format, separated by ";;".
    static QString exportFilters();

    /// Reads a file and ties its points to the objects that are not hidden, as one undoable step. What else the scene says of its
    /// points, their unit and the keys of other programs, stays where the file says nothing of it. Names that wait for a place are
    /// filled by name where nothing else is there, and where somebody says that the points are to be put behind; by a file without
    /// names, in their order. Points named as semilandmarks are written where a format has no curves, are curves again.
    /// @return whether its points are in the scene
    bool importFrom(const std::filesystem::path &file);
    /// @return whether it is written; not where somebody gives up waiting for the curves
    bool exportTo(const std::filesystem::path &file);

signals:
    /// What could not be read or written, in words.
    void failed(const QString &reason);
    /// What of a file was not kept, or is not kept in it.
    void warned(const QString &text);
    /// What is good to know and needs no answer.
    void noticed(const QString &text);

private:
    struct Stray {
        std::size_t index = 0;
        landmarks::Landmark untied;
    };
    std::vector<ray::TyingTarget> targets() const;
    LandmarkFileQuestions::Join howToJoin(const landmarks::LandmarkSet &coming) const;
    /// Points without names take those that wait, by their order.
    /// @param notes  gets what was done
    /// @return false where the import was given up
    bool nameAll(std::vector<landmarks::Landmark> &landmarks, LandmarkFileQuestions::Join join, const QString &file,
                 QStringList &notes);
    /// Ties points to the objects, strays as somebody says.
    /// @return what was done, in words; nothing where the import was given up
    std::optional<QString> tieAll(std::vector<landmarks::Landmark> &landmarks);

    SceneDocument &m_document;
    LandmarkFileQuestions *m_questions;
};

} // namespace unprojector::gui
