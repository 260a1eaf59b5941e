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

/// What is made of models beside the window's work: a coarse stand-in of each that is too large to be drawn while the view
/// moves. It keeps no model alive.
class ModelStore : public QObject {
    Q_OBJECT
public:
    /// Objects with more triangles and points than this, all together, are drawn by their stand-ins while the view moves.
    static constexpr std::size_t kMostInMotion = 100'000;

    explicit ModelStore(QObject *parent = nullptr);

    /// Begins to make the stand-ins of these objects' models, where together they are too large; `standInReady` tells of
    /// each.
    void makeStandIns(const std::vector<scene::SceneObject> &objects);
    /// The objects with stand-ins for the models that are too large.
    /// @return nothing where the objects are few enough to be drawn themselves, or a stand-in is not made yet
    std::optional<std::vector<scene::SceneObject>> standInsFor(const std::vector<scene::SceneObject> &objects) const;
    /// Whether objects are too large to be drawn while the view moves.
    static bool areLarge(const std::vector<scene::SceneObject> &objects);

signals:
    void standInReady();
    /// A stand-in could not be made, and why; its model is drawn itself.
    void jobFailed(const unprojector::gui::JobFailure &failure);

private:
    struct StandIn {
        std::weak_ptr<const mesh::Model> model;     ///< an address alone may be another's by now
        std::shared_ptr<const mesh::Model> standIn; ///< null while it is being made, and where it could not be made
    };

    const StandIn *standInOf(const std::shared_ptr<const mesh::Model> &model) const;
    void dropUnused();

    std::map<const mesh::Model *, StandIn> m_standIns;
    Background m_background;
};

} // namespace unprojector::gui
