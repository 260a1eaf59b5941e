#pragma once

#include "core/geometry/camera.h"
#include "core/geometry/projection.h"
#include "core/landmarks/landmark.h"
#include "gui/document/scene_keeper.h"
#include "gui/landmarks/scan.h"
#include "gui/landmarks/series_files.h"
#include "gui/landmarks/series_history.h"
#include "gui/landmarks/series_protocol.h"
#include "gui/landmarks/series_state.h"
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
    bool isOpen() const { return !m_now.scans.empty(); }
    const std::filesystem::path &folder() const { return m_now.folder; }
    const std::vector<Scan> &scans() const { return m_now.scans; }
    /// The scan that is shown, or that could not be shown; nothing while another scene is shown.
    std::optional<std::size_t> current() const { return m_now.current; }
    /// The scan in the view, where landmarks are placed: the one before, if `current` could not be
    /// shown.
    std::optional<std::size_t> inView() const { return m_now.current ? m_now.inView : std::nullopt; }
    bool hasNext() const { return isOpen() && (!m_now.index() || *m_now.index() + 1 < m_now.scans.size()); }
    bool hasPrevious() const { return isOpen() && m_now.index() != std::size_t(0); }
    /// The names of all landmarks of all scans, in the order of first appearance.
    QStringList landmarkNames() const { return m_now.names.namesOn(m_now.scans); }
    /// The names that the series places, in order, while a scan of it is shown; else none.
    std::vector<landmarks::Landmark> shownNames() const
    {
        return m_now.shown ? m_now.names.with(m_now.shownScan()) : std::vector<landmarks::Landmark>();
    }
    /// "9 of 10, 1 missing"
    QString progressText(const Scan &scan) const { return m_now.names.progressText(scan, m_now.lastShown()); }

    /// Saves the landmarks of the present scan and shows another one. @pre index < scans().size()
    void show(std::size_t index);
    void next() { step(1); }
    void previous() { step(-1); }
    /// The number of the present pass through the series, from 1: each has its own landmarks.
    int placing() const { return m_now.placing; }
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
    bool canSave() const override { return m_now.shown.has_value(); }
    std::optional<RecoverySeries> series() const override;
    void resume(const RecoverySeries &series) override;

signals:
    /// Emitted when the list of scans, or the progress of one, changes.
    void changed();
    /// Emitted before another scan is shown: messages about the present one are outdated.
    void leaving();
    /// Emitted when a scan is in the view, with its landmarks.
    void scanShown();
    /// Emitted when a series continues after a crash.
    void resumed();
    /// Emitted when a file could not be read or written, with the reason.
    void failed(const QString &reason);
    /// Emitted with import or export notes: what was left out.
    void warned(const QString &text);
    void noticed(const QString &text);

private:
    void step(int by);
    bool mayPlaceAs(int placing);
    void takeSeries(const std::filesystem::path &folder, std::vector<Scan> scans, int placing);
    /// Continues after a scan that could not be read.
    void passOver(const QString &reason);
    /// Adds the landmarks of the current scan once it is in the view.
    /// @param isLoaded  the scan has just been loaded
    void takeShown(bool isLoaded);
    /// The key that shows the scan after one that cannot be shown; empty if it is the last one.
    QString nextScanText() const;
    ScanPlacing shownPlacing() const;
    /// Puts the changes on all scans on the undo stack.
    void putHistoryBack();
    /// Shows the scan of a change, to undo or redo it there.
    void goTo(const std::shared_ptr<const ScanStep> &step, bool isRedo);
    void runTarget();
    /// Restores the scan from before a lesson, in its former state. @pre m_aside
    void comeBack();
    /// Saves the landmarks of the present scan, if there are any.
    /// @param isWanted  the user asked to save, not to leave
    ShownScan::Kept keepShown(bool isWanted);
    void keepTemplate();
    /// Opens the folder's protocol, or that of the scene.
    /// @return why it cannot be read; empty: no error
    QString openProtocol();
    /// Returns to the former series, whose scan is still in the view. @pre m_former
    void goBack();
    SceneDocument &m_document;
    Session &m_session;
    SeriesHistory m_history;
    SeriesFiles m_files;
    SeriesProtocol m_protocol;
    ShownScan m_shownScan;
    SeriesState m_now;
    std::optional<SeriesState> m_former; ///< the series before, while the first scan is being loaded
    bool m_isReadOnly = false;
    bool m_isOpening = false; ///< the current scan is being loaded
    std::function<bool(std::size_t, std::size_t)> m_waiting;
    bool m_wasAsked = false; ///< leaving the former scene was asked about since this scan is loading
    /// the camera and the projection of the scan that was shown last
    std::optional<std::pair<geometry::LookAt, geometry::Projection>> m_look;
    /// while the first scan of a series is searched: why others could not be read
    std::optional<QStringList> m_passedOver;
    std::optional<SeriesHistory::Wanted> m_target;
    QStringList m_toWarn;   ///< once a scan is shown: its opening hides earlier messages
    QStringList m_toNotice; ///< the same
};

} // namespace unprojector::gui
