#pragma once

#include "core/files/file_stamp.h"
#include "core/landmarks/landmark.h"
#include "core/scene/scene.h"
#include "gui/landmarks/series_protocol.h"
#include "gui/landmarks/series_table.h"

#include <QObject>
#include <QString>
#include <QStringList>

#include <cstddef>
#include <filesystem>
#include <functional>
#include <optional>
#include <vector>

namespace unprojector::gui {

class SceneDocument;
class Session;

using landmarks::kMostPlacings;

/// A scan of a series, with its landmarks.
struct Scan {
    std::filesystem::path file;
    landmarks::LandmarkSet points; ///< saved or current, in coordinates of the scan's own file
    QString problem;               ///< why the scan or its landmarks could not be read; empty: no error
    bool isKept = false;           ///< it has a landmark file
    bool isDamaged = false;        ///< that file could not be read
    std::size_t placedCount() const;
};

/// Reads the landmarks of one placing that are saved beside the scan.
void readKept(Scan &scan, int placing);

/// A folder of scans with the same landmarks, shown one after the other. The landmarks of each are
/// saved beside it, in "face.ply.points.csv": when another scan is shown, when the scene is saved,
/// and when it is left. Names that a scan lacks are taken from the scan before.
///
/// Coordinates in these files, in `scans` and in the tables are in the space of the scan's own
/// file: they don't change when the scan is moved, turned or scaled in the scene. A file that
/// cannot be read, or that another program has changed since it was read, is never overwritten.
class ScanSeries : public QObject {
    Q_OBJECT
public:
    using Table = SeriesTable;

    /// @param document, session  outlive it
    ScanSeries(SceneDocument &document, Session &session, QObject *parent = nullptr);

    /// Opens a folder's model files as a series, sorted by name, and shows the first incomplete
    /// one. If the user refuses to leave the present scene, the former series stays.
    /// @return false without any model file, after `failed`
    bool open(const std::filesystem::path &folder);
    /// Saves the landmarks and closes the series; the present scene stays.
    /// @return false after `failed`
    bool close();
    bool isOpen() const { return !m_scans.empty(); }
    const std::filesystem::path &folder() const { return m_folder; }
    const std::vector<Scan> &scans() const { return m_scans; }
    /// The scan that is shown, or that could not be shown; nothing while another scene is shown.
    std::optional<std::size_t> current() const { return m_current; }
    bool hasNext() const { return isOpen() && (!index() || *index() + 1 < m_scans.size()); }
    bool hasPrevious() const { return isOpen() && index() != std::size_t(0); }
    /// The names of all landmarks of all scans, in the order of first appearance.
    QStringList landmarkNames() const;

    /// Saves the landmarks of the present scan and shows another one. @pre index < scans().size()
    void show(std::size_t index);
    void next() { step(1); }
    void previous() { step(-1); }
    /// The number of the present pass through the series, from 1: each has its own landmarks.
    int placing() const { return m_placing; }
    /// Changes the placing, unless the landmarks of the present scan cannot be saved, or the other
    /// placing's cannot be read.
    void setPlacing(int placing);
    /// Saves the landmarks of the present scan beside it, if they have changed.
    /// @return false after `failed`
    bool keep();
    /// The measures that the series keeps, see SeriesProtocol.
    const std::vector<landmarks::KeptMeasure> &measures() const { return m_protocol.measures(); }
    /// The placings of all scans, after those of the present scan are saved; nothing after `failed`.
    std::optional<SeriesRepeats> repeats();
    /// Sets a callback that shows the progress of a long export and returns false to cancel it.
    void setWaiting(std::function<bool(std::size_t done, std::size_t count)> waiting)
    {
        m_waiting = std::move(waiting);
    }
    /// @return false after `failed`
    bool exportTable(const std::filesystem::path &file, Table table);

signals:
    /// Emitted when the list of scans, or the progress of one, changes.
    void changed();
    /// Emitted when a file could not be read or written, with the reason.
    void failed(const QString &reason);
    /// Emitted with import or export notes: what was left out.
    void warned(const QString &text);
    void noticed(const QString &text);

private:
    /// The scan that was shown before a lesson.
    struct SuspendedScan {
        std::size_t inView = 0;
        bool isShown = false; ///< its landmarks are saved
        int placing = 1;
    };

    /// The index that next and previous start from; in a lesson the suspended scan's.
    std::optional<std::size_t> index() const { return m_current || !m_aside ? m_current : m_aside->inView; }
    void step(int by);
    bool mayPlaceAs(int placing);
    /// Adds the landmarks of the current scan once it is in the view.
    void takeShown();
    /// Restores the scan from before a lesson, in its former state. @pre m_aside
    void comeBack();
    /// Copies the scene's landmarks to the present scan.
    /// @return false if they have no finite coordinates in its file
    bool takeLandmarks(landmarks::LandmarkSet set);
    /// Opens the folder's protocol, or that of the scene.
    void openProtocol();
    /// Returns whether the landmarks of the present scan are the saved ones. @pre m_shown
    bool isAsKept() const;
    /// Returns to the former series, whose scan is still in the view. @pre m_former
    void goBack();
    /// Returns whether the scene has only the present scan, as in its file, and its landmarks.
    bool isScanAlone() const;

    /// The state before a series whose first scan is being loaded.
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
    std::vector<landmarks::Landmark> m_names; ///< given to every scan
    std::vector<landmarks::Curve> m_curves;   ///< the same, by the names of their landmarks
    bool m_isOpening = false;                 ///< the current scan is being loaded
    std::optional<std::size_t> m_inView;      ///< the scan in the view
    /// the same, but nothing if its landmark file is damaged: then they are not saved
    std::optional<std::size_t> m_shown;
    std::optional<SuspendedScan> m_aside; ///< the scan before the present lesson
    scene::SceneObject m_object;          ///< the scan, as it was last in the scene
    landmarks::LandmarkSet m_kept;        ///< its landmarks as last read or written
    files::FileStamp m_stamp;             ///< of their file at that time
    int m_placing = 1;
    std::optional<PreviousSeries> m_former;
    SeriesProtocol m_protocol;
    std::function<bool(std::size_t, std::size_t)> m_waiting;
    bool m_wasAsked = false; ///< leaving the former scene was asked about since this scan is loading
};

} // namespace unprojector::gui
