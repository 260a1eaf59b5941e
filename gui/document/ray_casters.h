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

/// A ray::RayCaster of each model in use. Casters of small models are built at once, others one
/// after the other on a separate thread. It keeps no model alive, and cancels the build of a model
/// that is no longer in use.
class RayCasters : public QObject {
    Q_OBJECT
public:
    using Caster = std::shared_ptr<const ray::RayCaster>;

    /// Models with at most so many triangles and points in total are built at once: in less time
    /// than a frame takes.
    static constexpr std::size_t kMostAtOnce = 20'000;

    explicit RayCasters(QObject *parent = nullptr);

    /// Builds the casters of these objects' models, except hidden ones and those built already;
    /// `built` reports each that comes later. Cancels builds for other objects.
    void prepare(const std::vector<scene::SceneObject> &objects);
    /// The same, and returns when all casters are built.
    void complete(const std::vector<scene::SceneObject> &objects);
    /// Makes only `complete` build casters from now on: for a program that may never ask for a ray.
    void waitUntilAsked() { m_isAhead = false; }
    bool isPreparing() const { return m_background.isRunning(); }

    /// The casters of these objects, one an object; null for a hidden one. A caster keeps its model
    /// alive.
    /// @return empty while a shown object's caster is not built
    std::optional<std::vector<Caster>> of(const std::vector<scene::SceneObject> &objects) const;
    /// The reason why one of these objects has no caster and none is being built; nothing if all
    /// have theirs or wait for them.
    std::optional<JobFailure> failureOf(const std::vector<scene::SceneObject> &objects) const;

signals:
    /// Emitted when another model's caster is built or has failed.
    void built();
    /// @param share  of all that is being prepared, in [0, 1]
    void progressed(double share);
    /// Emitted when no caster is being built any more.
    void finished();

private:
    /// A caster, which does not hold its model; null: the build was cancelled.
    using Built = JobResult<Caster>;
    struct Kept {
        std::weak_ptr<const mesh::Model> model; ///< an address alone may be reused by another model
        Built caster;
    };

    const Kept *keptOf(const std::shared_ptr<const mesh::Model> &model) const;
    /// The models without a caster, each once.
    std::vector<std::shared_ptr<const mesh::Model>> missing(const std::vector<scene::SceneObject> &objects) const;
    void keep(const std::shared_ptr<const mesh::Model> &model, Built caster);
    void require(const std::vector<scene::SceneObject> &objects);
    void begin();
    /// Stores the result for the model under way.
    void take(double size, const Built &caster);
    void dropUnused();

    std::map<const mesh::Model *, Kept> m_kept;
    std::list<std::weak_ptr<const mesh::Model>> m_waiting;
    std::weak_ptr<const mesh::Model> m_underWay;
    double m_all = 0.0;  ///< triangles and points being prepared
    double m_done = 0.0; ///< of `m_all`
    bool m_isAhead = true;
    Background m_background;
};

} // namespace unprojector::gui
