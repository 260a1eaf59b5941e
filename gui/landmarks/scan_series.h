#pragma once

#include "core/geometry/camera.h"
#include "core/geometry/projection.h"
#include "core/landmarks/landmark.h"
#include "gui/document/scene_keeper.h"
#include "gui/landmarks/scan.h"
#include "gui/landmarks/series_files.h"
#include "gui/landmarks/series_history.h"
#include "gui/landmarks/series_protocol.h"
#include "gui/landmarks/series_table.h"
#include "gui/landmarks/shown_scan.h"

#include <QObject>
#include <QString>
#include <QStringList>

#include <cstddef>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace unprojector::gui {

class LandmarkTemplates;
class SceneDocument;
class Session;

/// A folder of scans with the same landmarks, shown one after the other. The landmarks of each are
/// saved beside it, in "face.ply.points.csv": when another scan is shown, by File > Save, when the
/// scene is saved, and when it is left. Names that a scan lacks are taken from the scan before; a
/// name to place that is removed from the shown scan is removed from all.
///
/// Coordinates in these files, in `scans` and in the tables are in the space of the scan's own
/// file: they don't change when the scan is moved, turned or scaled in the scene. A file that
/// cannot be read, or that another program has changed since it was read, is never overwritten.
class ScanSeries : public QObject, public SceneKeeper {
    Q_OBJECT
public:
    using Table = SeriesTable;

    /// @param document, session  outlive it
    ScanSeries(SceneDocument &document, Session &session, QObject *parent = nullptr);

    /// Sets the templates: the series then keeps its own one in the folder.
    /// @param templates  outlives it
    void setTemplates(LandmarkTemplates &templates) { m_files.setTemplates(templates); }
    /// Only shows: saves nothing, and gives a scan no curves of other scans.
    void setReadOnly() { m_isReadOnly = true; }
    /// Opens a folder's model files as a series, sorted by name, and shows the first one that can be
    /// read and lacks a landmark. If the user refuses to leave the present scene, the former series
    /// stays.
    /// @return false without any model file, after `failed`
    bool open(const std::filesystem::path &folder);
    /// Saves the landmarks and closes the series; the present scene stays.
    /// @return false after `failed`, or if the user cancels
    bool close();
    bool isOpen() const { return !m_scans.empty(); }
    const std::filesystem::path &folder() const { return m_folder; }
    const std::vector<Scan> &scans() const { return m_scans; }
    /// The scan that is shown, or that could not be shown; nothing while another scene is shown.
    std::optional<std::size_t> current() const { return m_current; }
    /// The scan in the view, where landmarks are placed: the one before, if `current` could not be
    /// shown.
    std::optional<std::size_t> inView() const { return m_current ? m_inView : std::nullopt; }
    bool hasNext() const { return isOpen() && (!index() || *index() + 1 < m_scans.size()); }
    bool hasPrevious() const { return isOpen() && index() != std::size_t(0); }
    /// The names of all landmarks of all scans, in the order of first appearance.
    QStringList landmarkNames() const;
    /// The number of landmarks that a scan has or that are to be placed on it.
    std::size_t wantedCount(const Scan &scan) const;
    /// "9 of 10, 1 missing"
    QString progressText(const Scan &scan) const;

    /// Saves the landmarks of the present scan and shows another one. @pre index < scans().size()
    void show(std::size_t index);
    void next() { step(1); }
    void previous() { step(-1); }
    /// The number of the present pass through the series, from 1: each has its own landmarks.
    int placing() const { return m_placing; }
    /// Changes the placing, unless the landmarks of the present scan cannot be saved, or the other
    /// placing's cannot be read.
    void setPlacing(int placing);
    /// Saves the landmarks of the present scan beside it, if they have changed. Asks before much
    /// fewer landmarks replace the saved ones.
    /// @return false after `failed`, or if the user cancels
    bool keep();
    /// Reads the landmark files of the other scans again: another program may have changed them.
    void readAgain();
    /// Keeps a template that the user has chosen.
    void keepChosenTemplate();
    /// The measures that the series keeps, see SeriesProtocol.
    const std::vector<landmarks::KeptMeasure> &measures() const { return m_protocol.measures(); }
    /// The placings of all scans, after those of the present scan are saved; nothing after `failed`.
    std::optional<SeriesRepeats> repeats();
    /// Sets a callback that shows the progress of a long export and returns false to cancel it.
    void setWaiting(std::function<bool(std::size_t done, std::size_t count)> waiting)
    {
        m_waiting = std::move(waiting);
    }
    /// @return false after `failed`, or if the user cancels
    bool exportTable(const std::filesystem::path &file, Table table);

    bool keepBeforeLeaving() override;
    std::optional<bool> save() override;
    bool canSave() const override { return m_shown.has_value(); }
    std::optional<RecoverySeries> series() const override;
    void resume(const RecoverySeries &series) override;

signals:
    /// Emitted when the list of scans, or the progress of one, changes.
    void changed();
    /// Emitted when a series continues after a crash.
    void resumed();
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
    void takeSeries(const std::filesystem::path &folder, std::vector<Scan> scans, int placing);
    /// Reads the saved landmarks of a scan, without names to place that the series has no more.
    void read(Scan &scan);
    /// The first scan from this index on that lacks a landmark; else the first one.
    std::size_t firstIncomplete(std::size_t from) const;
    /// Continues after a scan that could not be read.
    void passOver(const QString &reason);
    /// Adds the landmarks of the current scan once it is in the view.
    /// @param isLoaded  the scan has just been loaded
    void takeShown(bool isLoaded);
    ScanPlacing shownPlacing() const;
    /// Puts the changes on all scans on the undo stack.
    void putHistoryBack();
    /// Shows the scan of a change, to undo or redo it there.
    void goTo(const std::shared_ptr<const ScanStep> &step, bool isRedo);
    void runTarget();
    /// Restores the scan from before a lesson, in its former state. @pre m_aside
    void comeBack();
    /// Removes names to place that were removed from the present scan from the other scans too.
    void dropRemoved(const std::vector<landmarks::Landmark> &before);
    /// Saves the landmarks of the present scan, if there are any.
    /// @param isWanted  the user asked to save, not to leave
    ShownScan::Kept keepShown(bool isWanted);
    void keepTemplate();
    /// Opens the folder's protocol, or that of the scene.
    /// @return why it cannot be read; empty: no error
    QString openProtocol();
    /// Returns to the former series, whose scan is still in the view. @pre m_former
    void goBack();
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
    SeriesHistory m_history;
    SeriesFiles m_files;
    SeriesProtocol m_protocol;
    ShownScan m_shownScan;
    std::filesystem::path m_folder;
    std::vector<Scan> m_scans;
    std::optional<std::size_t> m_current;
    std::vector<landmarks::Landmark> m_names; ///< given to every scan
    std::vector<landmarks::Curve> m_curves;   ///< the same, by the names of their landmarks
    bool m_isReadOnly = false;
    bool m_isOpening = false;            ///< the current scan is being loaded
    std::optional<std::size_t> m_inView; ///< the scan in the view
    /// the same, but nothing if its landmark file is damaged: then they are not saved
    std::optional<std::size_t> m_shown;
    std::optional<SuspendedScan> m_aside; ///< the scan before the present lesson
    int m_placing = 1;
    std::optional<PreviousSeries> m_former;
    std::function<bool(std::size_t, std::size_t)> m_waiting;
    bool m_wasAsked = false; ///< leaving the former scene was asked about since this scan is loading
    /// the camera and the projection of the scan that was shown last
    std::optional<std::pair<geometry::LookAt, geometry::Projection>> m_look;
    /// while the first scan of a series is searched: why others could not be read
    std::optional<QStringList> m_passedOver;
    std::optional<SeriesHistory::Wanted> m_target;
    QStringList m_toWarn; ///< once a scan is shown: its opening hides earlier messages
};

} // namespace unprojector::gui
