#pragma once

#include "core/maps/pixel_map.h"
#include "gui/document/background.h"
#include "gui/document/scene_document.h"

#include <QObject>

#include <cstdint>
#include <memory>

namespace unprojector::gui {

/// A map, with its question and setup.
struct MadeMap {
    maps::PixelMap map;
    maps::MapStatistics statistics;
    maps::Question question;
    geometry::Setup setup;
    bool leavesPointsOut = false; ///< the scene has points of clouds, which maps ignore
};

/// Makes maps of a document's view on a separate thread, one at a time: a new question cancels the
/// former one. Ray hits are cached, so that another question about the same setup is answered at
/// once.
class MapMaker : public QObject {
    Q_OBJECT
public:
    explicit MapMaker(const SceneDocument &document, QObject *parent = nullptr);

    /// Requests a map of the present setup.
    /// @return false while the models are not prepared for rays; then no request is under way
    bool ask(const maps::Question &question);
    /// Cancels the request.
    void cancel() { m_background.cancel(); }
    bool isMaking() const { return m_background.isRunning(); }

signals:
    void made(const std::shared_ptr<const unprojector::gui::MadeMap> &map);
    /// @param share  of the map, in [0, 1]
    void progressed(double share);
    /// Emitted when the setup has no map, with the reason.
    void failed(const unprojector::geometry::Error &error);
    /// Emitted when the map could not be computed, with the reason.
    void jobFailed(const unprojector::gui::JobFailure &failure);

private:
    struct Seen;
    struct Answer;

    static Answer answerOf(const maps::Question &question, std::shared_ptr<const Seen> seen, Job &job);

    const SceneDocument &m_document;
    std::shared_ptr<const Seen> m_seen; ///< of the last map; nothing after the scene has changed
    Background m_background{2};         ///< the next one need not wait for a cancelled one
};

} // namespace unprojector::gui
