#pragma once

#include "core/scene/scene.h"
#include "gui/document/scene_document.h"
#include "gui/parameters/parameter_group.h"
#include "gui/parameters/parameters_panel.h"

#include <memory>

namespace unprojector::gui {

/// The state that every row starts from, each number another one.
inline Scene startScene()
{
    Scene scene;
    scene.camera = scene.home = {WorldPoint(0.0, 0.0, 10.0), WorldPoint(0.0, 0.0, 0.0), {0.0, 1.0, 0.0}};
    scene.projection = Frustum{-0.5, 0.75, -0.375, 0.25, 1.0, 100.0};
    scene.projectionFollowsViewport = false;
    scene.clipDistancesFitObjects = false;
    auto model = std::make_shared<Model>();
    model->bounds.add({-1.0, -1.0, -1.0});
    model->bounds.add({1.0, 1.0, 1.0});
    scene.objects = {{"first", {}, model, {}}, {"second", {}, model, {}}};
    return scene;
}

inline const Frustum &frustumOf(const Scene &scene)
{
    return std::get<Frustum>(*scene.projection);
}

// What the rows make of it first.
inline void asIs(Scene &) {}
inline void perspective(Scene &s)
{
    s.projection = Perspective{0.8, 1.5, 1.0, 100.0};
}
inline void box(Scene &s)
{
    s.projection = Ortho{-2.0, 3.0, -1.0, 4.0, 1.0, 100.0};
}
inline void oblique(Scene &s)
{
    s.projection = Oblique{Ortho{-2.0, 3.0, -1.0, 4.0, 1.0, 100.0}, 1.0, 2.0};
}
inline void fixedViewport(Scene &s)
{
    s.viewport.kind = ViewportRule::Kind::Fixed;
}
inline void letterbox(Scene &s)
{
    s.viewport.kind = ViewportRule::Kind::KeepAspect;
}
inline void scaled(Scene &s)
{
    s.objects[0].transform = {Scale{{2.0, 1.0, 1.0}}};
}
inline void rotated(Scene &s)
{
    s.objects[0].transform = {Rotate{30.0, {0.0, 1.0, 0.0}}};
}
inline void cut(Scene &s)
{
    s.clipPlanes = {{1.0, 0.0, 0.0, 0.5}};
}

/// Compares what a scene's parameters are; of its objects only how they are placed.
bool isSameScene(const Scene &a, const Scene &b);

/// A document, its parameters panel in a window of its own, and a person's hands on them.
class PanelUser {
public:
    /// Everything anew, with startScene in a window of 801 x 601 pixels.
    void start();
    void open(const Scene &scene);
    /// Unfolds a group.
    ParameterGroup *showGroup(const QString &name);
    /// The field of that name, inside a part of its group where the name is not its alone; its group is unfolded.
    NumberField *field(const QString &name, const QString &within = {});
    /// Types instead of what is there, without Enter.
    void begin(NumberField *field, const QString &text);
    /// Types instead of what is there, and Enter.
    void type(NumberField *field, const QString &text);
    void type(const QString &name, const QString &text) { type(field(name), text); }
    /// What stands beneath a field, if it is on the screen.
    QString reasonBeneath(const NumberField *field) const;
    /// Chooses the entry that starts with a text.
    void choose(const QString &comboBox, const QString &text);
    void click(const QString &button, const QString &within = {});
    const Scene &scene() const { return m_document->scene(); }

protected:
    std::unique_ptr<SceneDocument> m_document;
    std::unique_ptr<ParametersPanel> m_panel;
};

} // namespace unprojector::gui
