#pragma once

#include "core/maps/pixel_map.h"
#include "gui/document/background.h"
#include "gui/document/scene_document.h"

#include <QObject>

#include <cstdint>
#include <memory>

namespace unprojector::gui {

/// A map, with what belongs to it.
struct MadeMap {
    maps::PixelMap map;
    maps::MapStatistics statistics;
    maps::Question question;
    geometry::Setup setup;
    bool leavesPointsOut = false; ///< the scene has points of clouds, which maps are not of
};

/// Makes maps of a document's picture on a thread of its own, one at a time: what is asked for later is what is wanted, and
/// ends what is under way. What rays meet is kept, so that another question about the same picture is answered at once.
class MapMaker : public QObject {
    Q_OBJECT
public:
    explicit MapMaker(const SceneDocument &document, QObject *parent = nullptr);

    /// Asks for a map of the picture as it is now.
    /// @return false while the models are not prepared for rays; then nothing is under way
    bool ask(const maps::Question &question);
    /// Nothing is wanted any more.
    void cancel() { m_background.cancel(); }
    bool isMaking() const { return m_background.isRunning(); }

signals:
    void made(const std::shared_ptr<const unprojector::gui::MadeMap> &map);
    /// @param share  of the map, in [0, 1]
    void progressed(double share);
    /// There is none of this picture, for this reason.
    void failed(const unprojector::geometry::Error &error);
    /// It could not be computed, and why.
    void jobFailed(const unprojector::gui::JobFailure &failure);

private:
    struct Seen;
    struct Answer;

    static Answer answerOf(const maps::Question &question, std::shared_ptr<const Seen> seen, Job &job);

    const SceneDocument &m_document;
    std::shared_ptr<const Seen> m_seen; ///< of the last map; nothing once the scene is another one
    Background m_background{2};         ///< the next need not wait for the cancelled one
};

} // namespace unprojector::gui
