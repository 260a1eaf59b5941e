#pragma once

#include <QObject>
#include <QString>

#include <cstddef>

namespace unprojector::gui {

class SceneDocument;

/// Placing the names of a template one after the other: skips them, marks them as missing, ends when
/// all are placed, and resumes when one waits again, as after an undone placement or on the next
/// scan of a series; but not in another scene.
class GuidedPlacing : public QObject {
    Q_OBJECT
public:
    explicit GuidedPlacing(SceneDocument &document, QObject *parent = nullptr);

    /// Sets whether a click places a landmark.
    void setPlacing(bool isPlacing);
    /// Continues on a scan of a series that was opened.
    void continueOnScan();
    /// Skips the next landmark to place.
    void skipNext();
    /// Marks the next landmark to place as missing on this specimen; without one, the selected
    /// landmarks. Removes the mark if they have it.
    void toggleMissing();

signals:
    /// Emitted when placing must begin or end.
    void placingWanted(bool isPlacing);
    /// Emitted with what happened, or with the reason why nothing did.
    void noticed(const QString &text);

private:
    void follow();
    QString nextText() const;

    SceneDocument &m_document;
    bool m_isPlacing = false;
    bool m_isWaiting = false; ///< placing has ended because all landmarks were placed
    bool m_isOnScan = false;  ///< the scene is a scan of a series
    bool m_hasWaited = false; ///< the scene before was one, and placing had ended there
    bool m_hasNext = false;   ///< before the present change
    std::size_t m_count = 0;  ///< of landmarks, at the same time
};

} // namespace unprojector::gui
