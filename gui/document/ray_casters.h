#pragma once

#include "core/ray/ray_caster.h"
#include "core/scene/scene.h"
#include "gui/document/background.h"

#include <QObject>

#include <cstddef>
#include <list>
#include <map>
#include <memory>
#include <optional>
#include <vector>

namespace unprojector::gui {

/// A ray::RayCaster of each model that is in use: those of small models are built at once, those of others one after the other
/// on a thread of its own. It keeps no model alive, and ends what it builds of one that nobody has any more.
class RayCasters : public QObject {
    Q_OBJECT
public:
    using Caster = std::shared_ptr<const ray::RayCaster>;

    /// Of so many triangles and points, together, the casters are built at once: in less time than a picture takes.
    static constexpr std::size_t kMostAtOnce = 20'000;

    explicit RayCasters(QObject *parent = nullptr);

    /// Builds the casters of these objects' models, as far as they are not hidden and not built yet; `built` tells of each that
    /// comes later. What was begun for other objects is given up.
    void prepare(const std::vector<scene::SceneObject> &objects);
    /// The same, all of it before this returns.
    void complete(const std::vector<scene::SceneObject> &objects);
    /// From now on only `complete` builds anything: for a program that may never ask for a ray.
    void waitUntilAsked() { m_isAhead = false; }
    bool isPreparing() const { return m_background.isRunning(); }

    /// The casters of these objects, one an object; null for a hidden one. Whoever has one has its model too.
    /// @return nothing while one is missing
    std::optional<std::vector<Caster>> of(const std::vector<scene::SceneObject> &objects) const;
    /// Why one of these objects has no caster and none is being built; nothing where all have theirs or wait for them.
    std::optional<JobFailure> failureOf(const std::vector<scene::SceneObject> &objects) const;

signals:
    /// Another model has its caster, or will have none.
    void built();
    /// @param share  of all that is being prepared, in [0, 1]
    void progressed(double share);
    /// Nothing is being prepared any more.
    void finished();

private:
    /// A caster, which does not hold its model; null: it was stopped.
    using Built = JobResult<Caster>;
    struct Kept {
        std::weak_ptr<const mesh::Model> model; ///< an address alone may be another's by now
        Built caster;
    };

    const Kept *keptOf(const std::shared_ptr<const mesh::Model> &model) const;
    /// Those that are missing, each once.
    std::vector<std::shared_ptr<const mesh::Model>> missing(const std::vector<scene::SceneObject> &objects) const;
    void keep(const std::shared_ptr<const mesh::Model> &model, Built caster);
    void require(const std::vector<scene::SceneObject> &objects);
    void begin();
    /// Takes what was built of the model that was under way.
    void take(double size, const Built &caster);
    void dropUnused();

    std::map<const mesh::Model *, Kept> m_kept;
    std::list<std::weak_ptr<const mesh::Model>> m_waiting;
    std::weak_ptr<const mesh::Model> m_underWay;
    double m_all = 0.0;  ///< triangles and points of what is being prepared
    double m_done = 0.0; ///< of them
    bool m_isAhead = true;
    Background m_background;
};

} // namespace unprojector::gui
