#pragma once

#include "core/camera_motion.h"
#include "core/mesh.h"
#include "core/pick.h"

#include <QObject>
#include <QString>

#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

namespace unprojector {

/// One model placed in the world.
struct SceneObject {
    QString name;
    std::filesystem::path file; ///< empty for a bundled object
    std::shared_ptr<const Model> model;
    glm::dmat4 worldFromObject{1.0};
};

/// The one owner of the scene, the camera and the picked point. Widgets show it and ask it to change; it unprojects.
class SceneDocument : public QObject {
    Q_OBJECT
public:
    explicit SceneDocument(QObject *parent = nullptr);

    const std::vector<SceneObject> &objects() const { return m_objects; }
    const ViewGeometry &geometry() const { return m_geometry; }
    /// The picked surface or background; nothing before the first click and after a change of the scene.
    const std::optional<Pick> &pick() const { return m_pick; }

    /// Around all objects, world space.
    const Box &bounds() const { return m_bounds; }
    /// The drawn ground: a square at the lowest height of the objects, world space.
    const Box &ground() const { return m_ground; }
    /// Distance of two ground lines: 1, 2 or 5 times a power of ten, world units.
    double groundSpacing() const { return m_groundSpacing; }

    /// Shows other objects and looks at them from their home view. The pick goes.
    void setObjects(std::vector<SceneObject> objects, const LookAt &home);
    /// The same, with a home view from the front and a little above that fits the objects.
    void setObjects(std::vector<SceneObject> objects);

    /// The view's size changed: the viewport fills the surface and the projection takes its aspect.
    void setSurface(const Surface &surface);

    void setCamera(const LookAt &camera);
    /// The window and kind of the projection; near and far are fitted to the objects.
    void setProjection(const Projection &projection);
    /// Camera and projection in one step.
    void setView(const LookAt &camera, const Projection &projection);

    void fit();
    void goHome();
    void switchProjection();

    /// Unprojects a click and keeps it as the pick.
    void pickAt(const WidgetPoint &position, const DepthSample &sample);
    void clearPick();
    /// Unprojects without keeping, for the pointer's readout.
    Result<Pick> unprojected(const WidgetPoint &position, const DepthSample &sample) const;
    /// The world point that navigation turns about when the pointer is at this sample: the surface there, else the
    /// point of the pointer's ray at the centre's distance.
    WorldPoint pivotAt(const WidgetPoint &position, const DepthSample &sample) const;

signals:
    void objectsChanged();
    void geometryChanged();
    void pickChanged();
    /// A click that could not be unprojected, with the reason; the last pick stays.
    void pickFailed(const unprojector::Error &error);

private:
    void updateBounds();
    void applyView(ViewGeometry geometry);

    std::vector<SceneObject> m_objects;
    ViewGeometry m_geometry;
    LookAt m_home;
    std::optional<Pick> m_pick;
    Box m_bounds;
    Box m_ground;
    double m_groundSpacing = 1.0;
};

} // namespace unprojector
