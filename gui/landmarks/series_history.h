#pragma once

#include "core/landmarks/landmark.h"
#include "core/scene/scene.h"

#include <QObject>
#include <QString>

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace unprojector::gui {

class SceneDocument;

/// A scan and the pass through the series in which its landmarks are placed.
struct ScanPlacing {
    std::filesystem::path scan;
    int placing = 1;
    friend bool operator==(const ScanPlacing &, const ScanPlacing &) = default;
};

/// A change of the landmarks of a scan, without the scan's model.
struct ScanStep {
    ScanPlacing where;
    QString text; ///< "Place nasion"
    /// Landmarks in coordinates of the scan's own file.
    landmarks::LandmarkSet before, after;
};

/// The undo history of a series: one history over all its scans.
///
/// The document's undo stack is cleared with each scan that is shown. The history takes the changes
/// of landmarks from it before, and puts them back on the next scan's stack. Undo of a change on
/// another scan asks for that scan first (`wanted`), and changes nothing until it is shown.
/// Changes of the view and of objects are not kept: they belong to the scene that was left.
class SeriesHistory : public QObject {
    Q_OBJECT
public:
    /// A change to undo or redo once its scan is shown.
    struct Wanted {
        std::shared_ptr<const ScanStep> step;
        bool isRedo = false;
    };

    /// @param document  outlives it
    explicit SeriesHistory(SceneDocument &document, QObject *parent = nullptr);

    /// Takes the changes from the document's stack.
    /// @param shown  the scan in the view
    void collect(const ScanPlacing &shown);
    /// Puts the changes on the document's stack, which is cleared first.
    /// @param shown   the scan in the view
    /// @param isHere  whether a scan belongs to the series; changes on other scans are dropped
    void putBack(const ScanPlacing &shown, const std::function<bool(const std::filesystem::path &)> &isHere);
    /// No scan is in the view: a change can't be undone without showing its scan first.
    void setNoneShown() { m_shown.reset(); }
    /// Forgets all changes, also on the document's stack.
    void forget();
    /// Undoes or redoes a change, now that its scan is shown.
    /// @return whether it was the next one, and was not refused
    bool run(const std::shared_ptr<const ScanStep> &step, bool isRedo);

signals:
    /// Emitted when a change on another scan must be undone or redone: its scan must be shown.
    void wanted(const std::shared_ptr<const unprojector::gui::ScanStep> &step, bool isRedo);
    /// Emitted when a change can't be undone or redone, with the reason. It is dropped.
    void refused(const QString &reason);

private:
    class Command;

    /// The index of a change on the document's stack.
    std::optional<int> indexOf(const ScanStep *step) const;
    /// Moves the stack's index without undoing changes on other scans.
    void setIndexQuietly(int index);
    /// @return false if the change must be dropped
    bool apply(const std::shared_ptr<const ScanStep> &step, bool isRedo);
    /// Puts the stack back to its state before the user's wish, and emits `wanted`.
    void passOn();

    SceneDocument &m_document;
    std::vector<std::shared_ptr<const ScanStep>> m_steps;
    int m_index = 0; ///< number of changes that are not undone
    std::optional<ScanPlacing> m_shown;
    bool m_isQuiet = false; ///< commands do nothing: the stack is being arranged
    std::optional<Wanted> m_wanted;
};

} // namespace unprojector::gui
