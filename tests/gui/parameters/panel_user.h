#pragma once

#include "core/scene/scene.h"
#include "gui/document/scene_document.h"
#include "gui/parameters/parameter_group.h"
#include "gui/parameters/parameters_panel.h"

#include <memory>

namespace unprojector::gui {

/// The initial state of every row; all its numbers differ.
inline scene::Scene startScene()
{
    scene::Scene scene;
    scene.camera =
        scene.home = {geometry::WorldPoint(0.0, 0.0, 10.0), geometry::WorldPoint(0.0, 0.0, 0.0), {0.0, 1.0, 0.0}};
    scene.projection = geometry::Frustum{-0.5, 0.75, -0.375, 0.25, 1.0, 100.0};
    scene.projectionFollowsViewport = false;
    scene.clipDistancesFitObjects = false;
    auto model = std::make_shared<mesh::Model>();
    model->bounds.add({-1.0, -1.0, -1.0});
    model->bounds.add({1.0, 1.0, 1.0});
    scene.objects = {{"first", {}, model, {}}, {"second", {}, model, {}}};
    return scene;
}

inline const geometry::Frustum &frustumOf(const scene::Scene &scene)
{
    return std::get<geometry::Frustum>(*scene.projection);
}

// The edits that prepare a row's scene.
inline void asIs(scene::Scene &) {}
inline void perspective(scene::Scene &s)
{
    s.projection = geometry::Perspective{0.8, 1.5, 1.0, 100.0};
}
inline void box(scene::Scene &s)
{
    s.projection = geometry::Ortho{-2.0, 3.0, -1.0, 4.0, 1.0, 100.0};
}
inline void oblique(scene::Scene &s)
{
    s.projection = geometry::Oblique{geometry::Ortho{-2.0, 3.0, -1.0, 4.0, 1.0, 100.0}, 1.0, 2.0};
}
inline void fixedViewport(scene::Scene &s)
{
    s.viewport.kind = scene::ViewportRule::Kind::Fixed;
}
inline void letterbox(scene::Scene &s)
{
    s.viewport.kind = scene::ViewportRule::Kind::KeepAspect;
}
inline void scaled(scene::Scene &s)
{
    s.objects[0].transform = {geometry::Scale{{2.0, 1.0, 1.0}}};
}
inline void rotated(scene::Scene &s)
{
    s.objects[0].transform = {geometry::Rotate{30.0, {0.0, 1.0, 0.0}}};
}
inline void cut(scene::Scene &s)
{
    s.clipPlanes = {{1.0, 0.0, 0.0, 0.5}};
}

/// Returns whether two scenes have the same parameters; of objects it compares only the transforms.
bool isSameScene(const scene::Scene &a, const scene::Scene &b);

/// A document, its parameters panel in a window of its own, and a user's actions on them.
class PanelUser {
public:
    /// Starts anew with startScene in a window of 801 x 601 pixels.
    void start();
    void open(const scene::Scene &scene);
    /// Unfolds a group.
    ParameterGroup *showGroup(const QString &name);
    /// The field of that name, inside a part of its group if the name is not unique; unfolds its
    /// group.
    NumberField *field(const QString &name, const QString &within = {});
    /// Replaces the text by typing, without Enter.
    void begin(NumberField *field, const QString &text);
    /// Replaces the text by typing, then presses Enter.
    void type(NumberField *field, const QString &text);
    void type(const QString &name, const QString &text) { type(field(name), text); }
    /// The text beneath a field, if it is on the screen.
    QString reasonBeneath(const NumberField *field) const;
    /// Chooses the entry that starts with a text.
    void choose(const QString &comboBox, const QString &text);
    void click(const QString &button, const QString &within = {});
    const scene::Scene &scene() const { return m_document->scene(); }

protected:
    std::unique_ptr<SceneDocument> m_document;
    std::unique_ptr<ParametersPanel> m_panel;
};

} // namespace unprojector::gui
