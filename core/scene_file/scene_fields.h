#pragma once

#include "core/base/json_fields.h"
#include "core/base/number_text.h"
#include "core/base/translation.h"
#include "core/geometry/condition_number.h"
#include "core/geometry/error_text.h"
#include "core/geometry/numbers.h"
#include "core/landmarks/landmark.h"
#include "core/scene_file/scene_file.h"

#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <variant>

namespace unprojector::scene_file {

// The keys of a scene file in the order in which they are written: see json_fields.h. Reading,
// writing, unknown keys and error paths all follow from this.

using base::Is, base::Whole, base::Words, base::tr;

struct Room {};
using SceneReader = base::JsonReader<Room>;

constexpr int kSceneVersion = 1;
constexpr Whole kAnyWhole{-std::numeric_limits<int>::max(), std::numeric_limits<int>::max()};
constexpr Whole kElementNumber{0, std::numeric_limits<std::uint32_t>::max()};

/// parseJson, or tooLargeText.
base::Expected<base::Json, base::Error> parsedJson(std::string_view text, const std::string &name,
                                                   std::size_t mostBytes = kMostSceneBytes);

/// Refuses values that core's check of them refuses.
/// @param key  of the member that the error is about; empty: the value itself
template <class Fields, class T>
void refuse(Fields &json, const geometry::Result<T> &checked, const char *key = "")
{
    if constexpr (Fields::kReads) {
        if (!checked && *key != '\0')
            json.failAt(key, errorText(checked.error()));
        if (!checked)
            json.fail(errorText(checked.error()));
    }
}

inline geometry::Check checkThat(bool isValid, geometry::ErrorCode code, double value = 0.0)
{
    return isValid ? geometry::Check(std::monostate{}) : geometry::Check(geometry::Error{code, value});
}

// ---- lists of numbers ----

template <class Fields, class T>
requires requires(T &point)
{
    point.coordinates();
}
void describe(Fields &json, T &point)
{
    auto coordinates = point.coordinates();
    json.value(coordinates);
    if constexpr (Fields::kReads)
        point = T(coordinates);
}

template <class Fields, Is<geometry::DepthRange> T>
void describe(Fields &json, T &range)
{
    glm::dvec2 ends(range.atNear, range.atFar);
    json.value(ends);
    if constexpr (Fields::kReads)
        range = {ends.x, ends.y};
}

template <class Fields, Is<geometry::DevicePixel> T>
void describe(Fields &json, T &pixel)
{
    std::array numbers{pixel.i, pixel.j};
    json.elements(numbers, kAnyWhole);
    if constexpr (Fields::kReads)
        pixel = {numbers[0], numbers[1]};
}

template <class Fields, Is<geometry::DoubleDouble> T>
void describe(Fields &json, T &number)
{
    double value = number.value;
    json.value(value);
    if constexpr (Fields::kReads)
        number = value;
}

/// [-1, 1] or [0, 1]; an API may allow only one of them.
struct NdcDepthOf {
    geometry::Api api;

    template <class Fields, class T>
    void operator()(Fields &json, T &depth) const
    {
        using geometry::NdcDepth;
        glm::dvec2 ends(depth == NdcDepth::ZeroToOne ? 0.0 : -1.0, 1.0);
        json.value(ends);
        if constexpr (Fields::kReads) {
            static constexpr std::array kChoices{"[-1, 1]", "[0, 1]"};
            if (ends.y != 1.0 || (ends.x != 0.0 && ends.x != -1.0))
                json.failChoice(kChoices);
            depth = ends.x == 0.0 ? NdcDepth::ZeroToOne : NdcDepth::MinusOneToOne;
            const geometry::ApiConventions &conventions = conventionsOf(api);
            const std::string only = "[0, 1] (\"conventions\": \"" + std::string(conventions.key) + "\")";
            if (conventions.hasOnlyThatDepth && depth != conventions.ndcDepth)
                json.failChoice(std::array{only.c_str()});
        }
    }
};

/// A matrix that has an inverse: 16 numbers, column by column.
struct InvertibleMatrix {
    template <class Fields, class T>
    void operator()(Fields &json, T &matrix) const
    {
        json.elements(std::span(glm::value_ptr(matrix), 16), {},
                      base::marked("a list of 16 numbers, column by column"));
        if constexpr (Fields::kReads)
            refuse(json,
                   checkThat(!std::isinf(geometry::conditionNumber(matrix)), geometry::ErrorCode::SingularMatrix));
    }
};

/// (A, B, C, D), the first three not all 0.
struct ClipPlaneNumbers {
    template <class Fields, class T>
    void operator()(Fields &json, T &plane) const
    {
        json.elements(plane);
        refuse(json, checkThat(glm::dvec3(plane) != glm::dvec3(0.0), geometry::ErrorCode::ClipPlaneHasNoNormal));
    }
};

/// Degrees. An angle that was given in radians has these under a key of their own beside it.
template <class Fields, Is<geometry::Angle> T>
void describeAngle(Fields &json, const char *degreesKey, const char *radiansKey, T &angle)
{
    double degrees = angle.degrees();
    json.required(degreesKey, degrees);
    const auto rounded = geometry::Angle::fromDegrees(degrees);
    if constexpr (Fields::kReads)
        angle = rounded;
    if (!json.has(radiansKey, rounded != angle))
        return;
    double exact = angle.radians.value;
    json.required(radiansKey, exact);
    if constexpr (Fields::kReads) {
        // Other programs may have rewritten the degrees with fewer digits; a different angle is a
        // deliberate change.
        constexpr double kSame = 1e-9;
        if (!(std::abs(exact - rounded.radians.value) <= kSame * std::abs(rounded.radians.value)))
            json.failAt(radiansKey, tr("%1 radians differ from %2, which is %3 degrees; remove the wrong key",
                                       base::shortestText(exact), degreesKey, base::shortestText(degrees)));
        angle = exact;
    }
}

// ---- landmarks ----

template <class Fields, Is<landmarks::Anchor> T>
void describe(Fields &json, T &anchor)
{
    static constexpr std::array kKinds{"triangle", "vertex", "edge"};
    // Free comes first in the variant, and is not written.
    const std::size_t kind = json.oneKeyOf(kKinds, anchor.index() - 1);
    base::describeAlternative(anchor, kind + 1, [&]<class Held>(Held &held) {
        if constexpr (Is<Held, landmarks::OnTriangle>) {
            json.required("triangle", held.triangle, kElementNumber);
            json.required("barycentric", held.barycentric);
        } else if constexpr (Is<Held, landmarks::AtVertex>) {
            json.required("vertex", held.vertex, kElementNumber);
        } else if constexpr (Is<Held, landmarks::OnEdge>) {
            json.object("edge", [&held](auto &edge) { edge.elements(held.vertices, kElementNumber); });
            json.required("share", held.share);
        }
    });
}

template <class Fields, Is<landmarks::Landmark> T>
void describe(Fields &json, T &landmark)
{
    static constexpr std::array kAbsences{"notPlaced", "skipped", "missing"};
    json.optional("name", landmark.name);
    json.nullable("position", landmark.world);
    if (!landmark.world)
        json.unlessDefault("absence", landmark.absence, Words{kAbsences});
    json.unlessDefault("object", landmark.object);
    json.unlessDefault("held", landmark.anchor);
    json.optional("uncertainty", landmark.uncertainty);
    json.unlessDefault("note", landmark.note);
    json.optional("color", landmark.color, Whole{0, 255});
    json.unlessDefault("hidden", landmark.isHidden);
}

template <class Fields, Is<landmarks::Curve> T>
void describe(Fields &json, T &curve)
{
    static constexpr std::array kKinds{"geodesic", "planeSection"};
    json.optional("name", curve.name);
    json.optional("points", curve.points);
    json.required("kind", curve.kind, Words{kKinds});
    json.required("count", curve.count, Whole{2, landmarks::kMostSemilandmarks});
    json.unlessDefault("semilandmarks", curve.semilandmarks);
}

template <class Fields, Is<landmarks::KeptMeasure> T>
void describe(Fields &json, T &measure)
{
    static constexpr std::array kKinds{"distance", "angle", "height", "length", "surface"};
    json.required("name", measure.name);
    json.required("kind", measure.kind, Words{kKinds});
    json.optional("landmarks", measure.landmarks);
}

template <class Fields, Is<landmarks::LandmarkSet> T>
void describe(Fields &json, T &set)
{
    static constexpr std::array kAxes{"LPS", "RAS"};
    json.unlessDefault("name", set.name);
    json.unlessDefault("mesh", set.mesh);
    json.unlessDefault("unit", set.unit);
    json.unlessDefault("axes", set.axes, Words{kAxes});
    json.optional("points", set.landmarks);
    json.unlessDefault("curves", set.curves);
    json.unlessDefault("measures", set.measures);
}

// ---- the setup ----

template <class Fields, Is<geometry::Viewport> T>
void describe(Fields &json, T &viewport)
{
    json.required("x", viewport.x);
    json.required("y", viewport.y);
    json.required("width", viewport.width);
    json.required("height", viewport.height);
    refuse(json, check(viewport), viewport.width > 0.0 ? "height" : "width");
}

template <class Fields, Is<geometry::LookAt> T>
void describe(Fields &json, T &camera)
{
    json.required("eye", camera.eye);
    json.required("center", camera.center);
    json.required("up", camera.up);
    if constexpr (Fields::kReads) {
        const geometry::Result<geometry::EyeFrame> frame = eyeFrame(camera);
        const bool isUp = !frame
                          && (frame.error().code == geometry::ErrorCode::UpIsZero
                              || frame.error().code == geometry::ErrorCode::UpParallelToView);
        refuse(json, frame, isUp ? "up" : "center");
    }
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
    if constexpr (Is<Box, geometry::Frustum>)
        json.unlessDefault("skew", box.skew);
}

/// A camera matrix with its image's size.
template <class Fields, Is<geometry::Pinhole> T>
void describe(Fields &json, T &pinhole)
{
    static constexpr std::array kCenters{"half", "integer"};
    json.required("fx", pinhole.fx);
    json.required("fy", pinhole.fy);
    json.required("cx", pinhole.cx);
    json.required("cy", pinhole.cy);
    json.unlessDefault("skew", pinhole.skew);
    json.required("width", pinhole.width);
    json.required("height", pinhole.height);
    json.required("pixelCenters", pinhole.areCentersWhole, Words{kCenters});
    json.required("near", pinhole.nearDistance);
    json.required("far", pinhole.farDistance);
}

template <class Fields, Is<geometry::Oblique> T>
void describe(Fields &json, T &oblique)
{
    describe(json, oblique.box);
    describeAngle(json, "theta", "thetaRadians", oblique.theta);
    describeAngle(json, "phi", "phiRadians", oblique.phi);
}

/// Describes a matrix in the convention of the file's API; the scene stores OpenGL's.
template <class Fields, Is<geometry::MatrixProjection> T>
void describe(Fields &json, T &projection, geometry::Api api)
{
    geometry::MatrixProjection inFile;
    if constexpr (!Fields::kReads) {
        inFile = apiFromOurs(projection, api);
        if (conventionsOf(api).hasOnlyThatDepth)
            inFile.ndcDepth.reset();
    }
    json.required("matrix", inFile.clipFromEye, InvertibleMatrix{});
    json.optional("ndcDepth", inFile.ndcDepth, NdcDepthOf{api});
    if constexpr (Fields::kReads)
        projection = oursFromApi(inFile, api);
}

/// The same for eyeFromWorld.
template <class Fields, Is<glm::dmat4> T>
void describeView(Fields &json, T &eyeFromWorld, geometry::Api api)
{
    glm::dmat4 inFile = viewFromOurs(eyeFromWorld, api);
    json.required("matrix", inFile, InvertibleMatrix{});
    if constexpr (Fields::kReads)
        eyeFromWorld = oursFromView(inFile, api);
}

/// A perspective may take its aspect from the viewport. It does so too where no double gives the
/// aspect: the viewport's does.
template <class Fields, Is<geometry::Perspective> T, Is<SceneFile> Scene>
void describe(Fields &json, T &perspective, Scene &scene)
{
    describeAngle(json, "fovy", "fovyRadians", perspective.verticalFov);
    const bool hasAspect = json.has("aspect", !scene.aspectFromViewport && perspective.aspect.rest == 0.0);
    if (hasAspect)
        json.required("aspect", perspective.aspect);
    if constexpr (Fields::kReads) {
        scene.aspectFromViewport = !hasAspect;
        if (!hasAspect)
            perspective.aspect = aspectOf(setupOf(scene).viewport);
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
    base::describeAlternative(scene.projection, type == Type::Matrix ? 1 : 0, [&]<class Either>(Either &either) {
        if constexpr (Is<Either, geometry::MatrixProjection>) {
            describe(json, either, scene.conventions.value_or(geometry::Api::OpenGl));
        } else {
            base::describeAlternative(either, static_cast<std::size_t>(type), [&]<class Kind>(Kind &projection) {
                if constexpr (Is<Kind, geometry::Perspective>)
                    describe(json, projection, scene);
                else
                    describe(json, projection);
            });
            if constexpr (Fields::kReads) {
                const geometry::Check valid = check(either);
                refuse(json, valid, valid ? "" : keyOf(valid.error(), either));
            }
        }
    });
}

// ---- the scene ----

template <class Fields, Is<geometry::TransformStep> T>
void describe(Fields &json, T &step)
{
    static constexpr std::array kSteps{"translate", "rotate", "scale"};
    const std::size_t kind = json.oneKeyOf(kSteps, step.index());
    base::describeAlternative(step, kind, [&]<class Step>(Step &one) {
        if constexpr (Is<Step, geometry::Translate>) {
            json.required(kSteps[0], one.offset);
        } else if constexpr (Is<Step, geometry::Scale>) {
            json.required(kSteps[2], one.factors);
        } else {
            glm::dvec4 numbers(one.degrees, one.axis);
            json.required(kSteps[1], numbers);
            if constexpr (Fields::kReads)
                one = {numbers.x, {numbers.y, numbers.z, numbers.w}};
        }
    });
    refuse(json, check(step), kSteps[kind]);
}

template <class Fields, Is<SceneFileObject> T>
void describe(Fields &json, T &object)
{
    static constexpr std::array kSources{"file", "bundled"};
    json.optional("name", object.name);
    if (json.oneKeyOf(kSources, object.file.empty() ? 1 : 0) == 0)
        json.required("file", object.file);
    else
        json.required("bundled", object.bundled);
    if constexpr (Fields::kReads) {
        if (object.file.empty() && object.bundled.empty())
            json.failAt("bundled", tr("this is not a name of a file"));
    }
    json.optional("transform", object.transform);
    json.unlessDefault("hidden", object.isHidden);
}

template <class Fields, Is<scene::ViewportRule> T>
void describe(Fields &json, T &rule)
{
    static constexpr std::array kKinds{"wholeWindow", "fixed", "keepAspect", "quarter"};
    json.required("kind", rule.kind, Words{kKinds});
    json.optional("aspect", rule.aspect);
    refuse(json, checkThat(rule.aspect > 0.0, geometry::ErrorCode::AspectNotPositive, rule.aspect), "aspect");
    json.optional("fixed", rule.fixed);
}

template <class Fields, Is<geometry::GivenPoint> T>
void describe(Fields &json, T &given)
{
    static constexpr std::array kSpaces{"object", "world", "eye", "clip", "ndc", "window"};
    std::size_t space = given.point.index();
    json.required("space", space, Words{kSpaces});
    base::describeAlternative(given.point, space, [&json](auto &point) { json.required("coordinates", point); });
    json.unlessDefault("object", given.object);
}

template <class Fields, Is<SceneFile> T>
void describeUi(Fields &json, T &scene)
{
    auto &ui = scene.ui;
    json.optional("viewportRule", ui.viewportRule);
    json.optional("projectionFollowsViewport", ui.projectionFollowsViewport);
    json.optional("clipDistancesFitObjects", ui.clipDistancesFitObjects);
    json.optional("home", ui.home);
    if (!json.has("clipPlanesOff", !ui.clipPlanesOff.empty()))
        return;
    std::size_t planes = scene.clipPlanes.size();
    const std::size_t most = scene::kMostClipPlanes - planes;
    if constexpr (Fields::kReads)
        planes += base::JsonNode(json, "clipPlanesOff").size();
    json.list("clipPlanesOff", ui.clipPlanesOff, most, [planes](auto &entry, auto &off) {
        entry.required("place", off.index, Whole{0, double(planes) - 1});
        entry.required("plane", off.plane, ClipPlaneNumbers{});
    });
}

template <class Fields, Is<SceneFile> T>
void describe(Fields &json, T &scene)
{
    json.object("unprojector", [](auto &version) {
        if constexpr (!Fields::kReads)
            version.set(kSceneVersion);
        else if (const double found = version.number(); found != kSceneVersion)
            version.fail(tr("version %1 cannot be read, only version %2", base::shortestText(found), kSceneVersion));
    });
    json.written("generator",
                 "Unprojector " UNPROJECTOR_VERSION); // the last program that wrote the file; readers ignore it
    std::array<const char *, geometry::kApis.size()> apis{};
    std::transform(geometry::kApis.begin(), geometry::kApis.end(), apis.begin(),
                   [](geometry::Api api) { return conventionsOf(api).key; });
    json.optional("conventions", scene.conventions, Words{apis});
    json.object("window", [&](auto &window) {
        constexpr Whole kPixels{1, kMostWindowPixels};
        window.required("width", scene.windowWidth, kPixels);
        window.required("height", scene.windowHeight, kPixels);
        // Either side has at least half a device pixel, which is rounded to one, and at most the
        // number above.
        window.optional("devicePixelRatio", scene.devicePixelRatio, [&](auto &member, auto &ratio) {
            member.value(ratio);
            refuse(member, checkThat(ratio > 0.0, geometry::ErrorCode::PixelRatioNotPositive, ratio));
            const auto [shorter, longer] = std::minmax(scene.windowWidth, scene.windowHeight);
            if constexpr (Fields::kReads)
                static_cast<void>(member.number(0.5 / shorter, double(kMostWindowPixels) / longer));
        });
        window.unlessDefault("fixed", scene.isWindowFixed);
    });
    json.optional("viewport", scene.viewport);
    json.optional("depthRange", scene.depthRange);
    refuse(json, check(scene.depthRange), "depthRange");
    json.object("projection", [&](auto &projection) { describeProjection(projection, scene); });
    json.object("view", [&](auto &view) {
        const bool isMatrix = view.has("matrix", std::holds_alternative<glm::dmat4>(scene.view));
        base::describeAlternative(scene.view, isMatrix ? 1 : 0, [&]<class Either>(Either &either) {
            if constexpr (Is<Either, glm::dmat4>)
                describeView(view, either, scene.conventions.value_or(geometry::Api::OpenGl));
            else
                describe(view, either);
        });
    });
    json.optional("objects", scene.objects);
    json.list("clipPlanes", scene.clipPlanes, scene::kMostClipPlanes, ClipPlaneNumbers{});
    json.unlessDefault("landmarks", scene.landmarks);
    json.optional("point", scene.point);
    json.optionalObject("ui", [&](auto &ui) { describeUi(ui, scene); });
}

} // namespace unprojector::scene_file
