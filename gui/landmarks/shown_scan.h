#pragma once

#include "core/base/file_stamp.h"
#include "core/landmarks/landmark.h"
#include "core/scene/scene.h"
#include "gui/landmarks/scan.h"
#include "gui/landmarks/series_files.h"
#include "gui/landmarks/series_protocol.h"

#include <QObject>
#include <QString>

#include <filesystem>
#include <functional>
#include <optional>
#include <vector>

namespace unprojector::gui {

class SceneDocument;
class Session;

/// The landmarks of the scan in the view: reads them from the file beside the scan into the scene,
/// and saves them there. The file has coordinates of the scan's own file.
class ShownScan : public QObject {
    Q_OBJECT
public:
    /// The fate of the landmarks that were to be saved.
    enum class Kept {
        Written,
        AsBefore, ///< nothing to write
        Dropped,  ///< the user keeps the saved ones
        Cancelled,
        Failed
    };
    /// @param files     makes backups
    /// @param protocol  the measures that the scene has with each scan
    /// @param shown     the scan whose landmarks are in the scene; null: none
    ShownScan(SceneDocument &document, Session &session, SeriesFiles &files, SeriesProtocol &protocol,
              std::function<Scan *()> shown);

    /// Finds the object of a scan that is in the view now, and notes the state of its landmark file.
    void begin(const std::filesystem::path &scan, const std::filesystem::path &landmarkFile);
    /// Takes the landmarks that were read, with the names and curves of the series.
    /// @return landmarks that lost their anchor, in words
    QString takeRead(Scan &scan, const std::vector<landmarks::Landmark> &names,
                     const std::vector<landmarks::Curve> &curves);
    /// Shows the saved landmarks in the scene, with the measures of the series, as one edit.
    void showSaved();
    /// Copies the scene's landmarks to the scan, and its measures to the protocol.
    /// @return false if they have no finite coordinates in its file
    bool take(Scan &scan) { return take(scan, sceneLandmarks()); }
    /// Saves the landmarks of the shown scan, if they have changed. Asks before much fewer landmarks
    /// replace the saved ones.
    /// @param isWanted  the user asked to save, not to leave
    Kept keep(const std::filesystem::path &landmarkFile, bool isWanted);

    const landmarks::LandmarkSet &saved() const { return m_saved; }
    /// The state of the landmark file at the last read or write.
    const base::FileStamp &stamp() const { return m_stamp; }
    /// Sets the state in which the landmark file may be replaced.
    void setStamp(const base::FileStamp &stamp) { m_stamp = stamp; }
    /// Returns whether the scene has only this scan, as in its file, and its landmarks.
    bool isAlone() const;

signals:
    void failed(const QString &reason);
    void warned(const QString &text);
    void noticed(const QString &text);

private:
    const landmarks::LandmarkSet &sceneLandmarks() const;
    bool take(Scan &scan, landmarks::LandmarkSet set);
    bool isAsSaved(const Scan &scan) const;
    Kept write(Scan &scan, const std::filesystem::path &landmarkFile, bool isWanted);
    /// Asks whether fewer landmarks replace the saved ones. @return Written if they do
    Kept mayReplace(const Scan &scan, const std::filesystem::path &landmarkFile, bool isWanted);

    SceneDocument &m_document;
    Session &m_session;
    SeriesFiles &m_files;
    SeriesProtocol &m_protocol;
    std::function<Scan *()> m_shown;
    std::filesystem::path m_scan;
    scene::SceneObject m_object;    ///< the scan, as it was last in the scene
    landmarks::LandmarkSet m_saved; ///< as last read or written
    base::FileStamp m_stamp;
    std::optional<landmarks::LandmarkSet> m_dropped; ///< landmarks that the user chose not to save
};

} // namespace unprojector::gui
