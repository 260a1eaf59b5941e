#pragma once

#include "core/files/file_stamp.h"
#include "core/landmarks/landmark.h"
#include "core/scene/scene.h"
#include "gui/landmarks/series_table.h"

#include <QObject>
#include <QString>
#include <QStringList>

#include <cstddef>
#include <filesystem>
#include <optional>
#include <vector>

namespace unprojector::gui {

class SceneDocument;
class Session;

/// How often a series can be gone through.
inline constexpr int kMostPlacings = 99;

/// A scan of a series, with its points.
struct Scan {
    std::filesystem::path file;
    landmarks::LandmarkSet points; ///< as they are kept, or as they are now; coordinates of the scan's own file
    QString problem;               ///< why the scan or its points could not be read; empty: none
    bool isKept = false;           ///< there is a file of its points
    bool isDamaged = false;        ///< that file could not be read
    std::size_t placedCount() const;
};

/// Reads the points that are kept beside the scan, of one placing.
void readKept(Scan &scan, int placing);

/// A folder of scans on which the same points are placed, one scan after the other. The points of each are kept beside it, in
/// "face.ply.points.csv": they are written when another scan is shown, when the scene is saved, and when it is left. What has no
/// name there yet is taken from the scan before.
///
/// Their coordinates there, and in `scans` and the tables, are those of the scan's own file: however the scan is moved, turned or
/// scaled in the scene, they stay what they are. A file that cannot be read, or that another program has changed since it was read,
/// is not written over.
class ScanSeries : public QObject {
    Q_OBJECT
public:
    using Table = SeriesTable;

    /// @param document, session  outlive it
    ScanSeries(SceneDocument &document, Session &session, QObject *parent = nullptr);

    /// Takes a folder's model files as a series, by name, and shows the first that has not all its points. Where somebody would
    /// rather not leave the scene that is shown for it, the series before stays.
    /// @return false without any model file, after `failed`
    bool open(const std::filesystem::path &folder);
    /// Keeps the points and forgets the series; what is shown stays.
    /// @return false after `failed`
    bool close();
    bool isOpen() const { return !m_scans.empty(); }
    const std::filesystem::path &folder() const { return m_folder; }
    const std::vector<Scan> &scans() const { return m_scans; }
    /// The scan that is shown, or that could not be; nothing while another scene is.
    std::optional<std::size_t> current() const { return m_current; }
    bool hasNext() const { return isOpen() && (!index() || *index() + 1 < m_scans.size()); }
    bool hasPrevious() const { return isOpen() && index() != std::size_t(0); }
    /// The names of all points of all scans, in the order in which they first appear.
    QStringList landmarkNames() const;

    /// Keeps the points of the scan that is shown and shows another one. @pre index < scans().size()
    void show(std::size_t index);
    void next() { step(1); }
    void previous() { step(-1); }
    /// Which time the series is gone through, counted from 1: the points of each are kept by themselves.
    int placing() const { return m_placing; }
    /// Stays where the points of the scan that is shown cannot be kept, or those of the other placing cannot be read.
    void setPlacing(int placing);
    /// Writes the points of the scan that is shown beside it, if they are other than there.
    /// @return false after `failed`
    bool keep();
    /// @return false after `failed`
    bool exportTable(const std::filesystem::path &file, Table table);

signals:
    /// The scans, or how far one of them is.
    void changed();
    /// What could not be read or written, in words.
    void failed(const QString &reason);
    /// What was left out of a file, or is not kept in it.
    void warned(const QString &text);
    void noticed(const QString &text);

private:
    /// A scan that is shown, and was before a lesson.
    struct SuspendedScan {
        std::size_t inView = 0;
        bool isShown = false; ///< its points are kept
        int placing = 1;
    };

    /// Where next and previous count from: in a lesson from the scan that it is left for.
    std::optional<std::size_t> index() const { return m_current || !m_aside ? m_current : m_aside->inView; }
    void step(int by);
    bool mayPlaceAs(int placing);
    /// The current scan is in the view: its points come to it.
    void takeShown();
    /// The scan that was shown before a lesson is again, as it was then. @pre m_aside
    void comeBack();
    /// The scan that is shown gets the scene's points.
    /// @return false where they have no finite coordinates in its file
    bool takeLandmarks(landmarks::LandmarkSet set);
    /// Whether the points of the scan that is shown are those that were kept. @pre m_shown
    bool isAsKept() const;
    /// To the series before, whose scan is still in the view. @pre m_former
    void goBack();
    /// Whether the scene holds nothing but the scan that is shown, as its file has it, and its points.
    bool isScanAlone() const;

    /// What was open before a series whose first scan is being loaded.
    struct PreviousSeries {
        std::filesystem::path folder;
        std::vector<Scan> scans;
        std::vector<landmarks::Landmark> names;
        std::vector<landmarks::Curve> curves;
        std::optional<std::size_t> inView, shown;
        std::optional<SuspendedScan> aside;
        int placing = 1;
    };

    SceneDocument &m_document;
    Session &m_session;
    std::filesystem::path m_folder;
    std::vector<Scan> m_scans;
    std::optional<std::size_t> m_current;
    std::vector<landmarks::Landmark> m_names; ///< that every scan gets
    std::vector<landmarks::Curve> m_curves;   ///< the same, by the names of their points
    bool m_isOpening = false;                 ///< the current scan is being loaded
    std::optional<std::size_t> m_inView;      ///< the scan in the view
    std::optional<std::size_t> m_shown;       ///< the same where its points are kept: not where their file is damaged
    std::optional<SuspendedScan> m_aside;     ///< the scan in the view, while a lesson is there instead
    scene::SceneObject m_object;              ///< it, as it was last in the scene
    landmarks::LandmarkSet m_kept;            ///< its points as they were read or last written
    files::FileStamp m_stamp;                 ///< of their file then
    int m_placing = 1;
    std::optional<PreviousSeries> m_former;
    bool m_wasAsked = false; ///< whether the scene before may be left, since the current scan is being loaded
};

} // namespace unprojector::gui
