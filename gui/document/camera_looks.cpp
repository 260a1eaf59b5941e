#include "gui/document/camera_looks.h"

#include "core/scene/opening_view.h"

#include <algorithm>
#include <utility>

namespace unprojector::gui {
using namespace geometry;
using namespace scene;
using namespace unproject;

namespace {

/// Applies camera and projection of a setup; its near and far planes only if they cut nothing off
/// within these bounds.
void showFramed(SceneDocument &document, Setup setup, const Box &bounds)
{
    // User-defined near and far stay while they cut nothing off.
    if (!document.scene().clipDistancesFitObjects && !bounds.isEmpty()) {
        const Projection fitted = withFittedClipDistances(setup, bounds, {});
        const ProjectionWindow own = projectionWindow(setup.projection()), tight = projectionWindow(fitted);
        if (own.nearDistance > tight.nearDistance || own.farDistance < tight.farDistance)
            setup.projection() = withClipDistances(setup.projection(), std::min(own.nearDistance, tight.nearDistance),
                                                   std::max(own.farDistance, tight.farDistance));
    }
    setView(document, setup.camera(), setup.projection());
}

} // namespace

void setCamera(SceneDocument &document, const LookAt &camera, const QString &mergeKey)
{
    setView(document, camera, document.scene().projection, mergeKey);
}

void setProjection(SceneDocument &document, const Projection &projection, const QString &mergeKey)
{
    setView(document, document.scene().camera, projection, mergeKey);
}

void setView(SceneDocument &document, const LookAt &camera, const Projection &projection, const QString &mergeKey)
{
    document.look({SceneDocument::tr("Camera"), mergeKey}, [&](SceneSettings &settings) {
        settings.camera = camera;
        settings.projection = projection;
    });
}

void fitAll(SceneDocument &document)
{
    Framing framing(document.setup());
    for (const SceneObject &object : document.objects()) {
        if (!object.isHidden)
            add(framing, object);
    }
    Box bounds = document.bounds();
    if (document.objects().empty()) {
        for (const landmarks::Landmark &landmark : document.landmarks()) {
            if (!landmark.isPlaced() || landmark.isHidden)
                continue;
            framing.add(*landmark.world);
            bounds.add(landmark.world->coordinates());
        }
    }
    showFramed(document, framing.setup(), bounds);
}

void fitObject(SceneDocument &document, std::size_t index)
{
    Q_ASSERT(index < document.objects().size());
    const SceneObject &object = document.objects()[index];
    Framing framing(document.setup());
    add(framing, object);
    showFramed(document, framing.setup(), boundsOf(object));
}

void fitAllFrom(SceneDocument &document, const LookAt &camera, const Projection &projection)
{
    const WorldPoint center(document.bounds().isEmpty() ? glm::dvec3(0.0) : document.bounds().center());
    setView(document, {center + (camera.eye - camera.center), center, camera.up}, projection);
    fitAll(document);
}

void goHome(SceneDocument &document)
{
    document.look({SceneDocument::tr("Home")}, [](SceneSettings &settings) {
        if (settings.home.matrix())
            settings.camera = settings.home;
        else
            settings.camera = *settings.home; // keeps the record that there was a matrix
        if (settings.projectionFollowsViewport)
            settings.projection = openingProjection();
    });
}

void switchProjection(SceneDocument &document)
{
    const bool isPerspectiveNow = isPerspective(document.scene().projection);
    document.look({isPerspectiveNow ? SceneDocument::tr("Orthographic") : SceneDocument::tr("Perspective")},
                  [isPerspectiveNow](SceneSettings &settings) {
                      settings.projection = converted(
                          settings.projection, isPerspectiveNow ? ProjectionKind::Ortho : ProjectionKind::Perspective,
                          centerDistance(settings.camera));
                  });
}

void openObjects(SceneDocument &document, std::vector<SceneObject> objects)
{
    const LookAt camera = openingCamera(objects, document.setup().surface);
    openObjects(document, std::move(objects), camera);
}

void openObjects(SceneDocument &document, std::vector<SceneObject> objects, const LookAt &home)
{
    Scene scene;
    scene.camera = scene.home = home;
    scene.projection = openingProjection();
    scene.objects = std::move(objects);
    const Check opened = document.open(std::move(scene));
    Q_ASSERT(opened.hasValue());
}

double centerDistance(const LookAt &camera)
{
    return distance(camera.center, camera.eye);
}

WorldPoint pivotOf(const LookAt &camera, const Result<Pick> &pick)
{
    if (!pick)
        return camera.center;
    if (const Result<WorldPoint> &surface = pick->point.world[Method::Formula]; pick->hit())
        return surface ? *surface : camera.center;
    const Result<WorldPoint> &enter = pick->rayNear.world[Method::Formula];
    const Result<WorldPoint> &leave = pick->rayFar.world[Method::Formula];
    const Result<EyeFrame> frame = eyeFrame(camera);
    if (!enter || !leave || !frame)
        return camera.center;
    const double wanted = eyeFromWorld(*frame, camera.center).z;
    const double zEnter = eyeFromWorld(*frame, *enter).z;
    const double zLeave = eyeFromWorld(*frame, *leave).z;
    const double t = (wanted - zEnter) / (zLeave - zEnter);
    return *enter + t * (*leave - *enter);
}

} // namespace unprojector::gui
