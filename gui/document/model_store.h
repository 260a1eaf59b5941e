#pragma once

#include "core/scene/scene.h"
#include "gui/document/background.h"

#include <QObject>

#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <vector>

namespace unprojector::gui {

/// Makes coarse stand-ins, in the background, for models that are too large to be drawn while the
/// view moves. It keeps no model alive.
class ModelStore : public QObject {
    Q_OBJECT
public:
    /// Objects with more triangles and points in total are drawn by their stand-ins while the view
    /// moves.
    static constexpr std::size_t kMostInMotion = 100'000;

    explicit ModelStore(QObject *parent = nullptr);

    /// Begins to make the stand-ins of these objects' models, if they are too large together; emits
    /// `standInReady` for each.
    void makeStandIns(const std::vector<scene::SceneObject> &objects);
    /// The objects with stand-ins for the models that are too large.
    /// @return nothing if the objects are small enough to be drawn themselves, or a stand-in is not
    /// made yet
    std::optional<std::vector<scene::SceneObject>> standInsFor(const std::vector<scene::SceneObject> &objects) const;
    /// Returns whether objects are too large to be drawn while the view moves.
    static bool areLarge(const std::vector<scene::SceneObject> &objects);

signals:
    void standInReady();
    /// Emitted when a stand-in could not be made, with the reason; the model itself is drawn.
    void jobFailed(const unprojector::gui::JobFailure &failure);

private:
    struct StandIn {
        std::weak_ptr<const mesh::Model> model;     ///< an address alone may be reused by another model
        std::shared_ptr<const mesh::Model> standIn; ///< null while it is being made, and if it could not be made
    };

    const StandIn *standInOf(const std::shared_ptr<const mesh::Model> &model) const;
    void dropUnused();

    std::map<const mesh::Model *, StandIn> m_standIns;
    Background m_background;
};

} // namespace unprojector::gui
