#pragma once

#include "core/landmarks/landmark.h"

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

/// A folder of scans on which the same points are placed, one scan after the other. The points of each are kept beside it, in
/// "face.ply.points.csv": they are written when another scan is shown, when the scene is saved, and when it is left. What has no
/// name there yet is taken from the scan before.
class ScanSeries : public QObject {
    Q_OBJECT
public:
    struct Scan {
        std::filesystem::path file;
        landmarks::LandmarkSet points; ///< as they are kept, or as they are now
        QString problem;               ///< why the scan or its points could not be read; empty: none
        bool isKept = false;           ///< there is a file of its points
        std::size_t placedCount() const;
    };
    /// What the points of all scans are written as.
    enum class Table {
        Long, ///< a row a point
        Wide, ///< a row a scan
        Tps,
        Nts,
        Repeats ///< a row a point of each scan, of all placings: their mean and how far they scatter
    };

    /// @param document, session  outlive it
    ScanSeries(SceneDocument &document, Session &session, QObject *parent = nullptr);

    /// Takes a folder's model files as a series, by name, and shows the first that has not all its points.
    /// @return false without any model file, after `failed`
    bool open(const std::filesystem::path &folder);
    bool isOpen() const { return !m_scans.empty(); }
    const std::filesystem::path &folder() const { return m_folder; }
    const std::vector<Scan> &scans() const { return m_scans; }
    /// The scan that is shown, or that could not be; nothing while another scene is.
    std::optional<std::size_t> current() const { return m_current; }
    /// The names of all points of all scans, in the order in which they first appear.
    QStringList pointNames() const;

    /// Keeps the points of the scan that is shown and shows another one. @pre place < scans().size()
    void show(std::size_t place);
    void next() { step(1); }
    void previous() { step(-1); }
    /// Which time the series is gone through, counted from 1: the points of each are kept by themselves.
    int placing() const { return m_placing; }
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
    void noticed(const QString &text);

private:
    void step(int by);
    void readKept(Scan &scan) const;
    /// The current scan is in the view: its points come to it.
    void takeShown();
    /// Whether the scene holds nothing but the scan that is shown, as its file has it, and its points.
    bool isScanAlone() const;
    std::vector<landmarks::LandmarkSet> alignedSets() const;
    std::string repeatsText() const;

    SceneDocument &m_document;
    Session &m_session;
    std::filesystem::path m_folder;
    std::vector<Scan> m_scans;
    std::optional<std::size_t> m_current;
    std::vector<landmarks::Landmark> m_names; ///< that every scan gets
    bool m_isOpening = false;                 ///< the current scan is being loaded
    std::optional<std::size_t> m_shown;       ///< the scan in the view, whose points are kept
    landmarks::LandmarkSet m_kept;            ///< its points as they were read or last written
    int m_placing = 1;
};

} // namespace unprojector::gui
