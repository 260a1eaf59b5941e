#pragma once

#include "core/maps/pixel_map.h"
#include "gui/document/scene_document.h"

#include <QObject>

#include <cstdint>
#include <list>
#include <memory>

namespace unprojector::gui {

/// A map, with what belongs to it.
struct MadeMap {
    maps::PixelMap map;
    maps::MapStatistics statistics;
    maps::Question question;
    Picture picture;
    bool leavesPointsOut = false; ///< the scene has points of clouds, which maps are not of
};

/// Makes maps of a document's picture on a thread of its own, one at a time: what is asked for later is what is wanted, and
/// ends what is under way. What rays meet is kept, so that another question about the same picture is answered at once.
class MapMaker : public QObject {
    Q_OBJECT
public:
    explicit MapMaker(const SceneDocument &document, QObject *parent = nullptr);
    ~MapMaker() override;

    /// Asks for a map of the picture as it is now.
    /// @return false while the models are not prepared for rays; then nothing is under way
    bool ask(const maps::Question &question);
    /// Nothing is wanted any more.
    void cancel();
    bool isMaking() const { return m_job != nullptr; }

signals:
    void made(const std::shared_ptr<const unprojector::gui::MadeMap> &map);
    /// @param share  of the map, in [0, 1]
    void progressed(double share);
    /// There is none of this picture, for this reason.
    void failed(const unprojector::geometry::Error &error);
    /// There is no memory for it, or no thread.
    void outOfMemory();

private:
    struct Seen;
    struct Job;

    void take(const std::shared_ptr<Job> &job);
    void reap(bool all);

    const SceneDocument &m_document;
    std::shared_ptr<const Seen> m_seen;     ///< of the last map; nothing once the scene is another one
    std::shared_ptr<Job> m_job;             ///< the one under way
    std::list<std::shared_ptr<Job>> m_jobs; ///< it, and those before that are ending
};

} // namespace unprojector::gui
