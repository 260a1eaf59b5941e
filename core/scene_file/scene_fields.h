#pragma once

#include "core/scene_file/json_fields.h"
#include "core/scene_file/landmark_fields.h"
#include "core/scene_file/scene_file.h"

#include <algorithm>
#include <array>
#include <span>

namespace unprojector::scene_file {

// The keys of a scene file in the order in which they are written: see json_fields.h. Reading,
// writing, unknown keys and error paths all follow from this.

constexpr int kSceneVersion = 1;

/// The keys of the APIs, in the order of Api.
inline std::span<const char *const> apiWords()
{
    static const auto words = [] {
        std::array<const char *, geometry::kApis.size()> keys{};
        std::transform(geometry::kApis.begin(), geometry::kApis.end(), keys.begin(),
                       [](geometry::Api api) { return conventionsOf(api).key; });
        return keys;
    }();
    return words;
}

/// Returns the value of type T in a variant; when reading, sets the variant to that type first.
template <class T, class Variant>
auto &as(Variant &variant)
{
    if constexpr (!std::is_const_v<Variant>) {
        if (!std::holds_alternative<T>(variant))
            variant = T{};
    }
    return std::get<T>(variant);
}

inline geometry::Check checkPositive(double value, geometry::ErrorCode code)
{
    return value > 0.0 ? geometry::Check(std::monostate{}) : geometry::Check(geometry::Error{code, value});
}

template <class Fields, Is<geometry::Viewport> T>
void describe(Fields &json, T &viewport)
{
    json.required("x", viewport.x);
    json.required("y", viewport.y);
    json.required("width", viewport.width);
    json.required("height", viewport.height);
    json.check([&] { return check(viewport); }, viewport.width > 0.0 ? "height" : "width");
}

template <class Fields, Is<geometry::LookAt> T>
void describe(Fields &json, T &camera)
{
    json.required("eye", camera.eye);
    json.required("center", camera.center);
    json.required("up", camera.up);
    json.check(
        [&] {
            const geometry::Result<geometry::EyeFrame> frame = eyeFrame(camera);
            return frame ? geometry::Check(std::monostate{}) : geometry::Check(frame.error());
        },
        [](const geometry::Error &error) {
            const bool isUp =
                error.code == geometry::ErrorCode::UpIsZero || error.code == geometry::ErrorCode::UpParallelToView;
            return isUp ? "up" : "center";
        });
}

template <class Fields, class Box>
requires(Is<Box, geometry::Frustum> || Is<Box, geometry::Ortho>) void describe(Fields &json, Box &box)
{
    json.required("left", box.left);
    json.required("right", box.right);
    json.required("bottom", box.bottom);
    json.required("top", box.top);
    json.required("near", box.nearDistance);
    json.required("far", box.farDistance);
    if constexpr (Is<Box, geometry::Frustum>) {
        if (json.has("skew", box.skew != 0.0))
            json.required("skew", box.skew);
    }
}

/// A camera matrix with its image's size.
template <class Fields, Is<geometry::Pinhole> T>
void describe(Fields &json, T &pinhole)
{
    enum class Centers { Half, Integer };
    static constexpr std::array kCenters{"half", "integer"};
    json.required("fx", pinhole.fx);
    json.required("fy", pinhole.fy);
    json.required("cx", pinhole.cx);
    json.required("cy", pinhole.cy);
    if (json.has("skew", pinhole.skew != 0.0))
        json.required("skew", pinhole.skew);
    json.required("width", pinhole.width);
    json.required("height", pinhole.height);
    auto centers = static_cast<Centers>(pinhole.areCentersWhole);
    json.required("pixelCenters", centers, Words{kCenters});
    if constexpr (Fields::kReads)
        pinhole.areCentersWhole = centers == Centers::Integer;
    json.required("near", pinhole.nearDistance);
    json.required("far", pinhole.farDistance);
}

template <class Fields, Is<geometry::Oblique> T>
void describe(Fields &json, T &oblique)
{
    describe(json, oblique.box);
    json.angle("theta", "thetaRadians", oblique.theta);
    json.angle("phi", "phiRadians", oblique.phi);
}

/// Describes a matrix in the convention of the file's API; the scene stores OpenGL's.
template <class Fields, Is<geometry::MatrixProjection> T>
void describe(Fields &json, T &projection, geometry::Api api)
{
    if constexpr (Fields::kReads) {
        json.required("matrix", projection.clipFromEye, InvertibleMatrix{});
        json.optional("ndcDepth", projection.ndcDepth, NdcDepthOf{api});
        projection = oursFromApi(projection, api);
    } else {
        geometry::MatrixProjection written = apiFromOurs(projection, api);
        if (conventionsOf(api).hasOnlyThatDepth)
            written.ndcDepth.reset();
        json.required("matrix", written.clipFromEye, InvertibleMatrix{});
        json.optional("ndcDepth", std::as_const(written.ndcDepth), NdcDepthOf{api});
    }
}

/// The same for eyeFromWorld.
template <class Fields, Is<glm::dmat4> T>
void describeView(Fields &json, T &eyeFromWorld, geometry::Api api)
{
    if constexpr (Fields::kReads) {
        json.required("matrix", eyeFromWorld, InvertibleMatrix{});
        eyeFromWorld = oursFromView(eyeFromWorld, api);
    } else {
        json.required("matrix", viewFromOurs(eyeFromWorld, api), InvertibleMatrix{});
    }
}

/// A perspective may take its aspect from the viewport. It does so too where no double gives the
/// aspect: the viewport's does.
template <class Fields, Is<geometry::Perspective> T, Is<SceneFile> Scene>
void describe(Fields &json, T &perspective, Scene &scene)
{
    json.angle("fovy", "fovyRadians", perspective.verticalFov);
    const bool hasAspect = json.has("aspect", !scene.aspectFromViewport && perspective.aspect.rest == 0.0);
    if (hasAspect)
        json.number("aspect", perspective.aspect);
    if constexpr (Fields::kReads) {
        scene.aspectFromViewport = !hasAspect;
        if (const geometry::Viewport viewport = setupOf(scene).viewport; !hasAspect)
            perspective.aspect = aspectOf(viewport);
    }
    json.required("near", perspective.nearDistance);
    json.required("far", perspective.farDistance);
}

/// The key that an error of a projection is about.
inline const char *keyOf(const geometry::Error &error, const geometry::Projection &projection)
{
    switch (error.code) {
    case geometry::ErrorCode::LeftEqualsRight: return "left";
    case geometry::ErrorCode::BottomEqualsTop: return "bottom";
    case geometry::ErrorCode::FieldOfViewOutOfRange: return "fovy";
    case geometry::ErrorCode::AspectNotPositive: return "aspect";
    case geometry::ErrorCode::FocalLengthIsZero: {
        const auto *pinhole = std::get_if<geometry::Pinhole>(&projection);
        return pinhole && pinhole->fx == 0.0 ? "fx" : "fy";
    }
    case geometry::ErrorCode::EmptyImage: return error.value > 0.0 ? "height" : "width";
    case geometry::ErrorCode::ShearAngleOutOfRange: {
        const auto *oblique = std::get_if<geometry::Oblique>(&projection);
        return oblique && oblique->theta.radians.value == error.value ? "theta" : "phi";
    }
    default: return "near"; // near not above 0, not before far
    }
}

template <class Fields, Is<SceneFile> T>
void describeProjection(Fields &json, T &scene)
{
    enum class Type { Frustum, Ortho, Perspective, Oblique, Pinhole, Matrix };
    static constexpr std::array kTypes{"frustum", "ortho", "perspective", "oblique", "pinhole", "matrix"};
    Type type = Type::Matrix;
    if (const auto *parameters = std::get_if<geometry::Projection>(&scene.projection))
        type = static_cast<Type>(parameters->index());
    json.required("type", type, Words{kTypes});
    if (json.failed())
        return;
    if (type == Type::Matrix)
        return describe(json, as<geometry::MatrixProjection>(scene.projection),
                        scene.conventions.value_or(geometry::Api::OpenGl));
    auto &projection = as<geometry::Projection>(scene.projection);
    switch (type) {
    case Type::Frustum: describe(json, as<geometry::Frustum>(projection)); break;
    case Type::Ortho: describe(json, as<geometry::Ortho>(projection)); break;
    case Type::Perspective: describe(json, as<geometry::Perspective>(projection), scene); break;
    case Type::Oblique: describe(json, as<geometry::Oblique>(projection)); break;
    case Type::Pinhole: describe(json, as<geometry::Pinhole>(projection)); break;
    case Type::Matrix: break;
    }
    json.check([&] { return check(projection); },
               [&](const geometry::Error &error) { return keyOf(error, projection); });
}

template <class Fields, Is<geometry::TransformStep> T>
void describe(Fields &json, T &step)
{
    static constexpr std::array kSteps{"translate", "rotate", "scale"};
    const std::size_t kind = json.oneKeyOf(kSteps, step.index());
    switch (kind) {
    case 0: json.required(kSteps[kind], as<geometry::Translate>(step).offset); break;
    case 1: json.required(kSteps[kind], as<geometry::Rotate>(step)); break;
    default: json.required(kSteps[kind], as<geometry::Scale>(step).factors); break;
    }
    json.check([&] { return check(step); }, kSteps[kind]);
}

template <class Fields, Is<SceneFileObject> T>
void describe(Fields &json, T &object)
{
    static constexpr std::array kSources{"file", "bundled"};
    json.optional("name", object.name);
    if (json.oneKeyOf(kSources, object.file.empty() ? 1 : 0) == 0)
        json.required("file", object.file);
    else
        json.required("bundled", object.bundled, SomeText{});
    json.list("transform", object.transform);
    if (json.has("hidden", object.isHidden))
        json.required("hidden", object.isHidden);
}

template <class Fields, Is<scene::ViewportRule> T>
void describe(Fields &json, T &rule)
{
    static constexpr std::array kKinds{"wholeWindow", "fixed", "keepAspect", "quarter"};
    json.required("kind", rule.kind, Words{kKinds});
    json.optional("aspect", rule.aspect);
    json.check([&] { return checkPositive(rule.aspect, geometry::ErrorCode::AspectNotPositive); }, "aspect");
    json.optional("fixed", rule.fixed);
}

template <class Fields, Is<geometry::GivenPoint> T>
void describe(Fields &json, T &given)
{
    enum class Space { Object, World, Eye, Clip, Ndc, Window };
    static constexpr std::array kSpaces{"object", "world", "eye", "clip", "ndc", "window"};
    auto space = static_cast<Space>(given.point.index());
    json.required("space", space, Words{kSpaces});
    if (json.failed())
        return;
    switch (space) {
    case Space::Object: json.required("coordinates", as<geometry::ObjectPoint>(given.point)); break;
    case Space::World: json.required("coordinates", as<geometry::WorldPoint>(given.point)); break;
    case Space::Eye: json.required("coordinates", as<geometry::EyePoint>(given.point)); break;
    case Space::Clip: json.required("coordinates", as<geometry::ClipPoint>(given.point)); break;
    case Space::Ndc: json.required("coordinates", as<geometry::NdcPoint>(given.point)); break;
    case Space::Window: json.required("coordinates", as<geometry::WindowPoint>(given.point)); break;
    }
    describeText(json, "object", given.object);
}

template <class Fields, Is<SceneFile> T>
void describeUi(Fields &json, T &scene)
{
    auto &ui = scene.ui;
    json.optional("viewportRule", ui.viewportRule);
    json.optional("projectionFollowsViewport", ui.projectionFollowsViewport);
    json.optional("clipDistancesFitObjects", ui.clipDistancesFitObjects);
    json.optional("home", ui.home);
    const std::size_t notCutting = json.sizeOf("clipPlanesOff", ui.clipPlanesOff.size());
    if (notCutting == 0)
        return;
    const std::size_t cutting = scene.clipPlanes.size();
    json.list("clipPlanesOff", ui.clipPlanesOff, scene::kMostClipPlanes - cutting, [&](auto &entry, auto &off) {
        const int last = static_cast<int>(cutting + notCutting) - 1;
        entry.required("place", off.index, Count{0, last});
        entry.required("plane", off.plane, ClipPlaneNumbers{});
    });
}

template <class Fields, Is<SceneFile> T>
void describe(Fields &json, T &scene)
{
    int version = kSceneVersion;
    json.required("unprojector", version, Version{kSceneVersion});
    json.written("generator", "Unprojector " UNPROJECTOR_VERSION); // who wrote it last: of no meaning to who reads it
    json.optional("conventions", scene.conventions, Words{apiWords()});
    json.object("window", [&](auto &window) {
        window.required("width", scene.windowWidth, Count{1, kMostWindowPixels});
        window.required("height", scene.windowHeight, Count{1, kMostWindowPixels});
        window.optional("devicePixelRatio", scene.devicePixelRatio,
                        PixelRatio{scene.windowWidth, scene.windowHeight, kMostWindowPixels});
        if (window.has("fixed", scene.isWindowFixed))
            window.required("fixed", scene.isWindowFixed);
    });
    json.optional("viewport", scene.viewport);
    json.optional("depthRange", scene.depthRange);
    json.check([&] { return check(scene.depthRange); }, "depthRange");
    if (json.failed()) // a perspective may take its aspect from these
        return;
    json.object("projection", [&](auto &projection) { describeProjection(projection, scene); });
    json.object("view", [&](auto &view) {
        if (view.has("matrix", std::holds_alternative<glm::dmat4>(scene.view)))
            describeView(view, as<glm::dmat4>(scene.view), scene.conventions.value_or(geometry::Api::OpenGl));
        else
            describe(view, as<geometry::LookAt>(scene.view));
    });
    json.list("objects", scene.objects);
    json.list("clipPlanes", scene.clipPlanes, scene::kMostClipPlanes, ClipPlaneNumbers{});
    if (json.has("landmarks", !(scene.landmarks == landmarks::LandmarkSet())))
        json.required("landmarks", scene.landmarks);
    json.optional("point", scene.point);
    json.optionalObject("ui", [&](auto &ui) { describeUi(ui, scene); });
}

} // namespace unprojector::scene_file
